#include "pmts/app/settings/instrument_care_settings.hpp"

#include "setting_values.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pmts::app {
namespace {

const QString kTests = QStringLiteral("instrument_care/tests");

QJsonObject jsonOf(const geometry::AxisError& error) {
    QJsonObject json{{QStringLiteral("mgon"), error.value.mgon()}};
    if (error.sigma) {
        json.insert(QStringLiteral("sigma_mgon"), error.sigma->mgon());
    }
    return json;
}

geometry::AxisError errorFrom(const QJsonObject& json) {
    geometry::AxisError error{.value = core::Angle::fromMgon(json.value(QStringLiteral("mgon")).toDouble()), .sigma = {}};
    if (const auto sigma = json.value(QStringLiteral("sigma_mgon")); sigma.isDouble()) {
        error.sigma = core::Angle::fromMgon(sigma.toDouble());
    }
    return error;
}

QJsonObject jsonOf(const AxisTestRecord& test) {
    QJsonObject json{{QStringLiteral("serial_number"), test.serial_number},
                     {QStringLiteral("utc"), test.utc.toString(Qt::ISODate)},
                     {QStringLiteral("collimation"), jsonOf(test.errors.collimation)},
                     {QStringLiteral("index"), jsonOf(test.errors.index)},
                     {QStringLiteral("pairs"), test.errors.pairs}};
    if (test.errors.tilting) {
        json.insert(QStringLiteral("tilting"), jsonOf(*test.errors.tilting));
    }
    if (test.temperature_degc) {
        json.insert(QStringLiteral("temperature_degc"), *test.temperature_degc);
    }
    return json;
}

std::optional<AxisTestRecord> testFrom(const QJsonObject& json) {
    AxisTestRecord test;
    test.serial_number = json.value(QStringLiteral("serial_number")).toString();
    test.utc = QDateTime::fromString(json.value(QStringLiteral("utc")).toString(), Qt::ISODate);
    test.errors.collimation = errorFrom(json.value(QStringLiteral("collimation")).toObject());
    test.errors.index = errorFrom(json.value(QStringLiteral("index")).toObject());
    test.errors.pairs = json.value(QStringLiteral("pairs")).toInt();
    if (json.contains(QStringLiteral("tilting"))) {
        test.errors.tilting = errorFrom(json.value(QStringLiteral("tilting")).toObject());
    }
    if (const auto temperature = json.value(QStringLiteral("temperature_degc")); temperature.isDouble()) {
        test.temperature_degc = temperature.toDouble();
    }
    return test.utc.isValid() && test.errors.pairs > 0 ? std::optional(test) : std::nullopt;
}

core::Angle mgonFrom(const QSettings& file, const char* key, core::Angle fallback) {
    return core::Angle::fromMgon(numberFrom(file, key, fallback.mgon(), 0.1, 1000));
}

}  // namespace

void InstrumentCareSettings::load(const QSettings& file) {
    target_test.on = file.value(QStringLiteral("instrument_care/target_test"), target_test.on).toBool();
    target_test.angle = mgonFrom(file, "instrument_care/target_test_mgon", target_test.angle);
    target_test.offset_m = numberFrom(file, "instrument_care/target_test_m", target_test.offset_m, 0.001, 100);
    axis_limit = mgonFrom(file, "instrument_care/axis_limit_mgon", axis_limit);
    expires_degc = numberFrom(file, "instrument_care/expires_degc", expires_degc, 0.5, 100);
    expires_days = static_cast<int>(numberFrom(file, "instrument_care/expires_days", expires_days, 1, 3650));
    face_limit = mgonFrom(file, "instrument_care/face_limit_mgon", face_limit);
    face_limit_m = numberFrom(file, "instrument_care/face_limit_m", face_limit_m, 0.0001, 1);
    tests.clear();
    for (const auto& json : QJsonDocument::fromJson(file.value(kTests).toByteArray()).array()) {
        if (const auto test = testFrom(json.toObject())) {
            keep(*test);
        }
    }
}

void InstrumentCareSettings::save(QSettings& file) const {
    file.setValue(QStringLiteral("instrument_care/target_test"), target_test.on);
    file.setValue(QStringLiteral("instrument_care/target_test_mgon"), target_test.angle.mgon());
    file.setValue(QStringLiteral("instrument_care/target_test_m"), target_test.offset_m);
    file.setValue(QStringLiteral("instrument_care/axis_limit_mgon"), axis_limit.mgon());
    file.setValue(QStringLiteral("instrument_care/expires_degc"), expires_degc);
    file.setValue(QStringLiteral("instrument_care/expires_days"), expires_days);
    file.setValue(QStringLiteral("instrument_care/face_limit_mgon"), face_limit.mgon());
    file.setValue(QStringLiteral("instrument_care/face_limit_m"), face_limit_m);
    QJsonArray all;
    for (const AxisTestRecord& test : tests) {
        all.append(jsonOf(test));
    }
    file.setValue(kTests, QJsonDocument(all).toJson(QJsonDocument::Compact));
}

const AxisTestRecord* InstrumentCareSettings::testOf(const QString& serial_number) const {
    const auto found = std::ranges::find(tests, serial_number, &AxisTestRecord::serial_number);
    return found == tests.end() ? nullptr : &*found;
}

void InstrumentCareSettings::keep(const AxisTestRecord& record) {
    std::erase_if(tests, [&](const AxisTestRecord& test) { return test.serial_number == record.serial_number; });
    tests.push_back(record);
}

}  // namespace pmts::app
