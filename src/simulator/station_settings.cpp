#include "pmts/simulator/station_settings.hpp"

#include "unit_text.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace pmts::simulator {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("SimulatedStation", text); }

}  // namespace

core::Result<void> checkSettings(const StationSettings& settings) {
    constexpr double kFastest = 1e5;
    const std::array outputs{QStringLiteral("request"), QStringLiteral("reg_key"), QStringLiteral("slave")};
    const auto refuse = [](const QString& happened) {
        return core::fail(core::ErrorKind::kBadInput, happened);
    };
    if (!(settings.time_scale > 0.0) || settings.time_scale > kFastest) {
        return refuse(tr("The time scale must be above 0 and at most 100000."));
    }
    if (!(settings.baud >= 0.0) || settings.baud > 1e6) {
        return refuse(tr("The baud rate must be 0 (no pace) or up to 1000000."));
    }
    if (!unitDigits(settings.unit_status.toStdString(), settings.mbar_digit)) {
        return refuse(
            tr("\"%1\" is no unit status: four digits are needed, pressure 1-3, temperature 1-2, length 1-2, "
               "angle 1-4.")
                .arg(settings.unit_status));
    }
    if (std::ranges::find(outputs, settings.output) == outputs.end()) {
        return refuse(tr("\"%1\" is no output: it is request, reg_key or slave.").arg(settings.output));
    }
    if (settings.end_mark < 0 || settings.end_mark > 255) {
        return refuse(tr("The end mark must be a character number from 0 to 255."));
    }
    return {};
}

}  // namespace pmts::simulator
