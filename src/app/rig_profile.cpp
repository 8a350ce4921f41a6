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

QString say(const char* text) { return QCoreApplication::translate("RigProfile", text); }

}  // namespace

RigProfile simulatedRigProfile() {
    return {.name = say("Simulated camera"), .rig = simulator::simulatedRig()};
}

QByteArray rigProfileToJson(const RigProfile& profile) {
    const QJsonObject object{{"name", profile.name}, {"rig", camera::rigToJson(profile.rig)}};
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
    return RigProfile{.name = object.value(QLatin1String("name")).toString(), .rig = *rig};
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
