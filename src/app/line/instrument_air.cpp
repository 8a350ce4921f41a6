#include "pmts/app/line/instrument_air.hpp"

#include <QStringList>

#include <cmath>

namespace pmts::app {

QString InstrumentAir::text() const {
    QStringList parts;
    const auto add = [&parts](const std::optional<double>& value, int decimals, const char16_t* unit) {
        if (value) {
            const double scale = std::pow(10.0, decimals);
            const double rounded = std::round(*value * scale) / scale + 0.0;  // -0.02 ppm is 0.0, not -0.0
            parts.append(QStringLiteral("%1 %2").arg(rounded, 0, 'f', decimals).arg(QString::fromUtf16(unit)));
        }
    };
    add(temperature_degc, 1, u"°C");
    add(pressure_mbar, 1, u"mbar");
    add(humidity_percent, 0, u"%");
    add(ppm, 1, u"ppm");
    return parts.join(QStringLiteral(", "));
}

}  // namespace pmts::app
