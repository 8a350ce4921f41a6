#include "pmts/app/lab/rig_check.hpp"

namespace pmts::app {

QJsonObject rigCheckToJson(const RigCheck& check) {
    QJsonObject json{{"utc", check.utc.toUTC().toString(Qt::ISODateWithMs)},
                     {"pointings", check.pointings},
                     {"rms_px", check.rms_px},
                     {"largest_px", check.largest_px},
                     {"rms_gon", check.rms.gon()},
                     {"largest_gon", check.largest.gon()},
                     {"limit_px", check.limit_px},
                     {"limit_gon", check.limit.gon()},
                     {"passed", check.passed},
                     {"target", check.target},
                     {"residuals", residualsToJson(check.residuals)}};
    if (check.temperature_c) {
        json.insert(QStringLiteral("temperature_c"), *check.temperature_c);
    }
    return json;
}

RigCheck rigCheckFromJson(const QJsonObject& json) {
    const auto number = [&json](const char* name) { return json.value(QLatin1String(name)).toDouble(); };
    const auto gon = [&number](const char* name) { return core::Angle::fromGon(number(name)); };
    RigCheck check{.utc = QDateTime::fromString(json.value(QLatin1String("utc")).toString(), Qt::ISODateWithMs).toUTC(),
                   .pointings = json.value(QLatin1String("pointings")).toInt(),
                   .rms_px = number("rms_px"),
                   .largest_px = number("largest_px"),
                   .rms = gon("rms_gon"),
                   .largest = gon("largest_gon"),
                   .limit_px = number("limit_px"),
                   .limit = gon("limit_gon"),
                   .passed = json.value(QLatin1String("passed")).toBool(),
                   .target = json.value(QLatin1String("target")).toString(),
                   .residuals = residualsFromJson(json.value(QLatin1String("residuals")).toArray())};
    if (json.contains(QLatin1String("temperature_c"))) {
        check.temperature_c = number("temperature_c");
    }
    return check;
}

}  // namespace pmts::app
