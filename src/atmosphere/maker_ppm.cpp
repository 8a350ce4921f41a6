#include "pmts/atmosphere/maker_ppm.hpp"

#include <QCoreApplication>

namespace pmts::atmosphere {
namespace {

QString text(const char* sentence) { return QCoreApplication::translate("pmts::atmosphere", sentence); }

}  // namespace

core::Result<double> makerPpm(double pressure_mbar, double temperature_degc) {
    // Written so that NaN fails too.
    const bool plausible = pressure_mbar > 0.0 && pressure_mbar < 2000.0 && temperature_degc > -100.0 &&
                           temperature_degc < 100.0;
    const double ppm = plausible ? 275.0 - 79.55 * pressure_mbar / (273.0 + temperature_degc) : 0.0;
    if (!plausible || ppm < kLeastPpm || ppm > kGreatestPpm) {
        return core::fail(
            core::ErrorKind::kLimit,
            text("%1 mbar at %2 °C gives no correction that the instrument accepts.")
                .arg(pressure_mbar)
                .arg(temperature_degc),
            text("Enter the pressure at the station (not reduced to sea level) in mbar, about 1013 "
                 "at sea level and 800 at 2000 m."));
    }
    return ppm;
}

}  // namespace pmts::atmosphere
