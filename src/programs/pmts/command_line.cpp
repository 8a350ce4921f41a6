#include "command_line.hpp"

#include <QRegularExpression>

namespace pmts {
namespace {

core::Error unreadable(const QString& option, const QString& value) {
    return {.kind = core::ErrorKind::kBadInput,
            .happened = QStringLiteral("“%1 %2” is not understood.")
                            .arg(option, value)
                            .replace(QStringLiteral(" ”"), QStringLiteral("”")),
            .remedy = QStringLiteral("pmts --help lists what is."),
            .info_code = std::nullopt,
            .detail = {}};
}

bool takeFlag(CommandLine& line, const QString& option) {
    if (option == QLatin1String("--no-camera")) {
        line.camera = false;
    } else if (option == QLatin1String("--right-to-left")) {
        line.right_to_left = true;
    } else if (option == QLatin1String("--help") || option == QLatin1String("-h")) {
        line.help = true;
    } else if (option == QLatin1String("--version")) {
        line.version = true;
    } else {
        return false;
    }
    return true;
}

bool takeSize(CommandLine& line, const QString& value) {
    static const QRegularExpression size(QStringLiteral("^(\\d{3,5})x(\\d{3,5})$"));
    const auto match = size.match(value);
    if (match.hasMatch()) {
        line.window_size = QSize(match.captured(1).toInt(), match.captured(2).toInt());
    }
    return match.hasMatch();
}

/// Nothing when the option belongs to somebody else; false when its value cannot be read.
std::optional<bool> takeValue(CommandLine& line, const QString& option, const QString& value) {
    bool is_read = !value.isEmpty();
    if (option == QLatin1String("--palette")) {
        line.palette = gui::paletteFromText(value);
        is_read = line.palette.has_value();
    } else if (option == QLatin1String("--instrument")) {
        line.instrument = value;
    } else if (option == QLatin1String("--unattended")) {
        line.rehearsal_folder = value;
    } else if (option == QLatin1String("--size")) {
        is_read = takeSize(line, value);
    } else if (option == QLatin1String("--text")) {
        line.text_scale = value.toDouble(&is_read) / 100.0;
    } else {
        return std::nullopt;
    }
    return is_read;
}

}  // namespace

core::Result<CommandLine> commandLineFrom(const QStringList& arguments) {
    CommandLine line;
    QStringList for_app;
    for (int i = 0; i < arguments.size(); ++i) {
        if (takeFlag(line, arguments[i])) {
            continue;
        }
        const QString value = arguments.value(i + 1);
        if (const auto taken = takeValue(line, arguments[i], value)) {
            if (!*taken) {
                return tl::unexpected(unreadable(arguments[i], value));
            }
            ++i;
        } else {
            for_app.append(arguments[i]);
        }
    }
    auto start = app::StartOptions::fromArguments(for_app);
    if (!start) {
        return tl::unexpected(start.error());
    }
    line.start = *start;
    return line;
}

QString helpText() {
    return QStringLiteral(
        "pmts: photogrammetric mapping with a total station\n\n"
        "  --job FILE              open this job, made when missing\n"
        "  --instrument PORT       connect to this port; `simulated` for the simulated instrument\n"
        "  --no-camera             start without a camera\n"
        "  --palette day|night|sun\n"
        "  --size WIDTHxHEIGHT     size of the window\n"
        "  --text PERCENT          size of the text, 80 to 160\n"
        "  --right-to-left         mirror the window\n"
        "  --data DIR              settings, log and sample job\n"
        "  --simulated --seed N --time-scale X --scene FILE --fault NAME\n"
        "                          the simulated instrument\n"
        "  --camera-lens brown|rational|fisheye|thesis --camera-mount telescope|handle --rig-error N\n"
        "                          the simulated camera as it truly is; N: knocked, otherwise for each N\n"
        "  --replay FILE [--speed X]\n"
        "                          show a black box file; nothing is sent to any instrument\n"
        "  --unattended DIR        drive the window through the main job by clicks and keys;\n"
        "                          leaves DIR/job.gpkg, DIR/points.csv and DIR/*.png\n"
        "  --method-report FILE.csv [--image 640x480] [--centre 315,240] [--pointing 199.3587,105.9808]\n"
        "                          [--f 784] [--offset 0,0.085,0.052] [--fit]\n"
        "                          the thesis's tables 6.1-6.4 for a list of targets, without a window\n"
        "  --calibrate-board DIR --pattern 9x6 [--charuco DICT_4X4_50] [--square 25mm] [--marker 18mm] [--k3]\n"
        "                          [--output FILE.yaml|cameras.txt]\n"
        "                          the lens from pictures of a board (inner corners), without a window\n"
        "  --help, --version\n");
}

}  // namespace pmts
