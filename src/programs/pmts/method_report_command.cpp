#include "method_report_command.hpp"

#include "command_options.hpp"
#include "pmts/app/field/method_fit.hpp"
#include "pmts/targeting/method_report.hpp"

#include <vector>

namespace pmts {
namespace {

using core::Result;

/// As many numbers as the example has, separated as it separates them.
Result<std::vector<double>> numbers(const QCommandLineParser& parser, const QString& option, QChar separator,
                                    const QString& example) {
    const QStringList parts = parser.value(option).split(separator);
    std::vector<double> values;
    for (const QString& part : parts) {
        bool understood = false;
        values.push_back(part.toDouble(&understood));
        if (!understood || parts.size() != example.split(separator).size()) {
            return unreadable(option, example);
        }
    }
    return values;
}

Result<targeting::MethodReportOptions> optionsFrom(const QCommandLineParser& parser) {
    const auto image = numbers(parser, QStringLiteral("image"), u'x', QStringLiteral("640x480"));
    PMTS_TRY(image);
    const auto centre = numbers(parser, QStringLiteral("centre"), u',', QStringLiteral("315,240"));
    PMTS_TRY(centre);
    const auto pointing = numbers(parser, QStringLiteral("pointing"), u',', QStringLiteral("199.3587,105.9808"));
    PMTS_TRY(pointing);
    const auto f_px = numbers(parser, QStringLiteral("f"), u',', QStringLiteral("784"));
    PMTS_TRY(f_px);
    const auto offset_m = numbers(parser, QStringLiteral("offset"), u',', QStringLiteral("0,0.085,0.052"));
    PMTS_TRY(offset_m);
    if (!((*f_px)[0] > 0 && (*image)[0] >= 1 && (*image)[1] >= 1)) {
        return core::fail(core::ErrorKind::kBadInput, QStringLiteral("The image size and f must be above zero."));
    }
    targeting::MethodReportOptions options;
    options.width_px = static_cast<int>((*image)[0]);
    options.height_px = static_cast<int>((*image)[1]);
    options.camera.centre_px = {(*centre)[0], (*centre)[1]};
    options.photo = {core::Angle::fromGon((*pointing)[0]), core::Angle::fromGon((*pointing)[1])};
    options.camera.f_px = (*f_px)[0];
    options.offset_right_m = (*offset_m)[0];
    options.camera.forward_m = (*offset_m)[1];
    options.camera.up_m = (*offset_m)[2];
    return options;
}

}  // namespace

Result<QString> methodReportFor(const QStringList& arguments) {
    QCommandLineParser parser;
    PMTS_TRY(readOptions(parser, arguments,
                         {{"method-report", "FILE", ""},
                          {"image", "WxH", "640x480"},
                          {"centre", "X,Y", "315,240"},
                          {"pointing", "HA,VA", "199.3587,105.9808"},
                          {"f", "PX", "784"},
                          {"offset", "X,Y,Z", "0,0.085,0.052"}},
                         QStringLiteral("fit")));
    const auto targets = targeting::readTargetFile(parser.value(QStringLiteral("method-report")));
    PMTS_TRY(targets);
    auto options = optionsFrom(parser);
    PMTS_TRY(options);
    if (parser.isSet(QStringLiteral("fit"))) {
        auto fit = app::fitToTargets(*targets, *options);
        PMTS_TRY(fit);
        options->fit = std::move(*fit);
    }
    return targeting::methodReport(*targets, *options);
}

}  // namespace pmts
