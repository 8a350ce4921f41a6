#include "pmts/app/lab/rig_profile.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/camera/rig_json.hpp"
#include "pmts/simulator/simulated_rig.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pmts::app {

namespace {

constexpr qint64 kLargestFile = 1 << 20;

const QString kPixelAngleKey = QStringLiteral("average_pixel_angle");
const QString kCalibrationKey = QStringLiteral("calibration");
const QString kUseKey = QStringLiteral("use");
const QString kPreviousKey = QStringLiteral("previous");

QString say(const char* text) { return QCoreApplication::translate("RigProfile", text); }

QJsonObject pixelAngleToJson(const targeting::AveragePixelAngle& angle) {
    return {{"horizontal_gon", angle.horizontal.gon()}, {"vertical_gon", angle.vertical.gon()}};
}

core::Result<std::optional<targeting::AveragePixelAngle>> pixelAngleFromJson(const QJsonValue& json) {
    if (json.isUndefined()) {
        return std::nullopt;
    }
    const double horizontal_gon = json[QLatin1String("horizontal_gon")].toDouble();
    const double vertical_gon = json[QLatin1String("vertical_gon")].toDouble();
    if (horizontal_gon == 0 || vertical_gon == 0) {
        return core::fail(core::ErrorKind::kBadInput, say("The average pixel angle of the rig profile cannot be read."),
                          say("Correct average_pixel_angle, or take it out of the file."));
    }
    return targeting::AveragePixelAngle{core::Angle::fromGon(horizontal_gon), core::Angle::fromGon(vertical_gon)};
}

QJsonObject earlierToJson(const EarlierRig& earlier) {
    QJsonObject json{{"rig", camera::rigToJson(earlier.rig)}};
    if (earlier.calibration) {
        json.insert(kCalibrationKey, calibrationRecordToJson(*earlier.calibration));
    }
    return json;
}

std::optional<CalibrationRecord> recordOf(const QJsonObject& json) {
    return json.contains(kCalibrationKey) ? std::optional(calibrationRecordFromJson(json.value(kCalibrationKey).toObject()))
                                          : std::nullopt;
}

/// A rig of before that cannot be read is no reason to refuse the one of today.
std::optional<EarlierRig> earlierFromJson(const QJsonObject& json) {
    const auto rig = camera::rigFromJson(json.value(QLatin1String("rig")).toObject());
    return rig ? std::optional(EarlierRig{.rig = *rig, .calibration = recordOf(json)}) : std::nullopt;
}

QJsonArray checksToJson(const std::vector<RigCheck>& checks) {
    QJsonArray rows;
    for (const RigCheck& check : checks) {
        rows.append(rigCheckToJson(check));
    }
    return rows;
}

std::vector<RigCheck> checksFromJson(const QJsonArray& rows) {
    std::vector<RigCheck> checks;
    for (const auto& row : rows) {
        checks.push_back(rigCheckFromJson(row.toObject()));
    }
    return checks;
}

}  // namespace

RigProfile simulatedRigProfile() {
    return {.name = say("Simulated camera"), .rig = simulator::simulatedRig()};
}

QByteArray rigProfileToJson(const RigProfile& profile) {
    QJsonObject object{{"name", profile.name}, {"rig", camera::rigToJson(profile.rig)}};
    if (profile.average_pixel_angle) {
        object.insert(kPixelAngleKey, pixelAngleToJson(*profile.average_pixel_angle));
    }
    if (profile.use) {
        object.insert(kUseKey, cameraUseToJson(*profile.use));
    }
    if (profile.calibration) {
        object.insert(kCalibrationKey, calibrationRecordToJson(*profile.calibration));
    }
    if (profile.previous) {
        object.insert(kPreviousKey, earlierToJson(*profile.previous));
    }
    if (!profile.checks.empty()) {
        object.insert(QStringLiteral("checks"), checksToJson(profile.checks));
    }
    if (!profile.knock_sign.isEmpty()) {
        object.insert(QStringLiteral("knock_sign"), profile.knock_sign);
    }
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

core::Result<RigProfile> rigProfileFromJson(const QByteArray& json) {
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (!object.contains(QLatin1String("rig"))) {
        return core::fail(core::ErrorKind::kBadInput, say("This is not a rig profile."),
                          say("Choose a file that PMTS exported."));
    }
    const auto rig = camera::rigFromJson(object.value(QLatin1String("rig")).toObject());
    PMTS_TRY(rig);
    const auto pixel_angle = pixelAngleFromJson(object.value(kPixelAngleKey));
    PMTS_TRY(pixel_angle);
    const auto use = object.value(kUseKey);
    return RigProfile{.name = object.value(QLatin1String("name")).toString(),
                      .rig = *rig,
                      .average_pixel_angle = *pixel_angle,
                      .use = use.isObject() ? std::optional(cameraUseFromJson(use.toObject())) : std::nullopt,
                      .calibration = recordOf(object),
                      .previous = earlierFromJson(object.value(kPreviousKey).toObject()),
                      .checks = checksFromJson(object.value(QLatin1String("checks")).toArray()),
                      .knock_sign = object.value(QLatin1String("knock_sign")).toString()};
}

core::Result<RigProfile> loadRigProfile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile, say("The rig profile cannot be read."),
                          say("Check that the file is there."), path + QStringLiteral(": ") + file.errorString());
    }
    return rigProfileFromJson(file.read(kLargestFile));
}

core::Result<void> saveRigProfile(const RigProfile& profile, const QString& path) {
    return writeWhole(path, rigProfileToJson(profile));
}

}  // namespace pmts::app
