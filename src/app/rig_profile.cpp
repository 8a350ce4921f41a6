#include "pmts/app/rig_profile.hpp"

#include "pmts/camera/rig_json.hpp"
#include "pmts/simulator/simulated_rig.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace pmts::app {

namespace {

constexpr qint64 kLargestFile = 1 << 20;

const QString kPixelAngleKey = QStringLiteral("average_pixel_angle");

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

}  // namespace

RigProfile simulatedRigProfile() {
    return {.name = say("Simulated camera"), .rig = simulator::simulatedRig()};
}

QByteArray rigProfileToJson(const RigProfile& profile) {
    QJsonObject object{{"name", profile.name}, {"rig", camera::rigToJson(profile.rig)}};
    if (profile.average_pixel_angle) {
        object.insert(kPixelAngleKey, pixelAngleToJson(*profile.average_pixel_angle));
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
    return RigProfile{.name = object.value(QLatin1String("name")).toString(), .rig = *rig, .average_pixel_angle = *pixel_angle};
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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(rigProfileToJson(profile)) < 0 || !file.commit()) {
        return core::fail(core::ErrorKind::kFile, say("The rig profile cannot be written."), say("Choose another folder."),
                          path + QStringLiteral(": ") + file.errorString());
    }
    return {};
}

}  // namespace pmts::app
