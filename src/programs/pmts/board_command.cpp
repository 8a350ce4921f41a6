#include "board_command.hpp"

#include "command_options.hpp"
#include "pmts/calibration/board_calibration.hpp"
#include "pmts/camera/lens_file.hpp"

#include <QDir>
#include <QRegularExpression>

namespace pmts {
namespace {

using core::Result;

Result<double> length(const QCommandLineParser& parser, const QString& option) {
    static const QRegularExpression form(QStringLiteral("^([0-9.]+)(mm|cm|m)?$"));
    const auto match = form.match(parser.value(option));
    bool is_number = false;
    const double value = match.captured(1).toDouble(&is_number);
    if (!match.hasMatch() || !is_number || !(value > 0)) {
        return unreadable(option, QStringLiteral("25mm"));
    }
    const QString unit = match.captured(2);
    return unit == QLatin1String("m") ? value : unit == QLatin1String("cm") ? value / 100 : value / 1000;
}

Result<calibration::BoardPattern> patternFrom(const QCommandLineParser& parser) {
    static const QRegularExpression form(QStringLiteral("^(\\d{1,2})x(\\d{1,2})$"));
    const auto match = form.match(parser.value(QStringLiteral("pattern")));
    if (!match.hasMatch()) {
        return unreadable(QStringLiteral("pattern"), QStringLiteral("9x6 (inner corners across and down)"));
    }
    const auto square_m = length(parser, QStringLiteral("square"));
    PMTS_TRY(square_m);
    calibration::BoardPattern pattern{.columns = match.captured(1).toInt(), .rows = match.captured(2).toInt(), .square_m = *square_m,
                                      .dictionary = parser.value(QStringLiteral("charuco"))};
    if (parser.isSet(QStringLiteral("marker"))) {
        const auto marker_m = length(parser, QStringLiteral("marker"));
        PMTS_TRY(marker_m);
        pattern.marker_m = *marker_m;
    }
    return pattern;
}

}  // namespace

Result<QString> boardCalibrationFor(const QStringList& arguments) {
    QCommandLineParser parser;
    PMTS_TRY(readOptions(parser, arguments,
                         {{"calibrate-board", "DIR", ""},
                          {"pattern", "COLUMNSxROWS", "9x6"},
                          {"charuco", "DICT", ""},
                          {"square", "LENGTH", "25mm"},
                          {"marker", "LENGTH", ""},
                          {"output", "FILE", ""}},
                         QStringLiteral("k3")));
    const auto pattern = patternFrom(parser);
    PMTS_TRY(pattern);
    const QString folder = parser.value(QStringLiteral("calibrate-board"));
    if (!QDir(folder).exists()) {
        return core::fail(core::ErrorKind::kBadInput, QStringLiteral("There is no folder “%1”.").arg(folder),
                          QStringLiteral("Give the folder with the pictures of the board."));
    }
    const auto result = calibration::calibrateBoardFolder(folder, *pattern, {.free_k3 = parser.isSet(QStringLiteral("k3"))});
    PMTS_TRY(result);
    if (const QString output = parser.value(QStringLiteral("output")); !output.isEmpty()) {
        PMTS_TRY(camera::lensToFile(result->lens, result->width_px, result->height_px, output));
    }
    return calibration::boardCalibrationText(*result);
}

}  // namespace pmts
