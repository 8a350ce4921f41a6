#include "pmts/app/rig_profile.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include <cmath>

namespace pmts::app {

namespace {

QString say(const char* text) { return QCoreApplication::translate("RigProfile", text); }

QJsonObject lensObject(const camera::Lens& lens) {
    if (const auto* brown = std::get_if<camera::BrownLens>(&lens.model())) {
        return {{"model", "brown"},     {"f_px", brown->f_px}, {"cx_px", brown->cx_px}, {"cy_px", brown->cy_px},
                {"k1", brown->k1},      {"k2", brown->k2},     {"k3", brown->k3},       {"p1", brown->p1},
                {"p2", brown->p2}};
    }
    const auto& table = std::get<camera::RadialTableLens>(lens.model());
    QJsonArray rows;
    for (const auto& row : table.rows) {
        rows.append(QJsonArray{row.radius_px, row.angle_rad});
    }
    return {{"model", "radial_table"}, {"cx_px", table.cx_px}, {"cy_px", table.cy_px}, {"radius_px_angle_rad", rows}};
}

/// Reads numbers out of an object and remembers the first that is missing.
class Reader {
public:
    explicit Reader(QJsonObject object) : object_(std::move(object)) {}

    double number(const char* key) {
        const QJsonValue value = object_.value(QLatin1String(key));
        if (!value.isDouble() && missing_.isEmpty()) {
            missing_ = QLatin1String(key);
        }
        return value.toDouble();
    }
    [[nodiscard]] const QString& missing() const { return missing_; }
    [[nodiscard]] const QJsonObject& object() const { return object_; }

private:
    QJsonObject object_;
    QString missing_;
};

core::Result<camera::Lens> brownLens(Reader& read) {
    const camera::BrownLens lens{.f_px = read.number("f_px"), .cx_px = read.number("cx_px"), .cy_px = read.number("cy_px"),
                                 .k1 = read.number("k1"), .k2 = read.number("k2"), .k3 = read.number("k3"),
                                 .p1 = read.number("p1"), .p2 = read.number("p2")};
    if (read.missing().isEmpty() && !(lens.f_px > 0.0)) {
        return core::fail(core::ErrorKind::kBadInput, say("The focal length of the rig profile is not positive."),
                          say("Enter the focal length in pixels."));
    }
    return camera::Lens(lens);
}

core::Result<camera::Lens> tableLens(Reader& read) {
    camera::RadialTableLens lens{.cx_px = read.number("cx_px"), .cy_px = read.number("cy_px"), .rows = {}};
    const QJsonArray rows = read.object().value(QLatin1String("radius_px_angle_rad")).toArray();
    for (const auto& row : rows) {
        lens.rows.push_back({.radius_px = row.toArray().at(0).toDouble(), .angle_rad = row.toArray().at(1).toDouble()});
    }
    try {
        return camera::Lens(std::move(lens));
    } catch (const std::logic_error& error) {
        return core::fail(core::ErrorKind::kBadInput, say("The lens table of the rig profile does not increase."),
                          say("Check its rows: radius and angle start at 0 and grow."), QString::fromUtf8(error.what()));
    }
}

core::Result<camera::Lens> lensFrom(Reader& read) {
    const QString model = read.object().value(QLatin1String("model")).toString();
    if (model == QLatin1String("brown")) {
        return brownLens(read);
    }
    if (model == QLatin1String("radial_table")) {
        return tableLens(read);
    }
    return core::fail(core::ErrorKind::kBadInput, say("The rig profile names no lens model PMTS knows."),
                      say("Use brown or radial_table."), model);
}

QJsonObject mountObject(const camera::Mount& mount) {
    return {{"kind", mount.kind == camera::MountKind::kHandle ? "handle" : "telescope"},
            {"right_m", mount.offset_m.x()},
            {"forward_m", mount.offset_m.y()},
            {"up_m", mount.offset_m.z()},
            {"yaw_gon", mount.yaw.gon()},
            {"pitch_gon", mount.pitch.gon()},
            {"twist_gon", mount.twist.gon()}};
}

camera::Mount mountFrom(Reader& read) {
    camera::Mount mount;
    mount.kind = read.object().value(QLatin1String("kind")).toString() == QLatin1String("handle")
                     ? camera::MountKind::kHandle
                     : camera::MountKind::kTelescope;
    mount.offset_m = {read.number("right_m"), read.number("forward_m"), read.number("up_m")};
    mount.yaw = core::Angle::fromGon(read.number("yaw_gon"));
    mount.pitch = core::Angle::fromGon(read.number("pitch_gon"));
    mount.twist = core::Angle::fromGon(read.number("twist_gon"));
    return mount;
}

core::Error missingField(const QString& field) {
    return core::Error{.kind = core::ErrorKind::kBadInput,
                       .happened = say("The rig profile lacks the number “%1”.").arg(field),
                       .remedy = say("Export a profile from PMTS to see all fields."),
                       .info_code = std::nullopt,
                       .detail = {}};
}

}  // namespace

QByteArray rigProfileToJson(const RigProfile& profile) {
    const QJsonObject object{{"pmts_rig", 1},
                             {"name", profile.name},
                             {"width_px", profile.rig.width_px},
                             {"height_px", profile.rig.height_px},
                             {"lens", lensObject(profile.rig.lens)},
                             {"mount", mountObject(profile.rig.mount)}};
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

core::Result<RigProfile> rigProfileFromJson(const QByteArray& json) {
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (!object.contains(QLatin1String("pmts_rig"))) {
        return core::fail(core::ErrorKind::kBadInput, say("This is not a rig profile."),
                          say("Choose a file that PMTS exported."));
    }
    Reader top(object);
    Reader lens_reader(object.value(QLatin1String("lens")).toObject());
    Reader mount_reader(object.value(QLatin1String("mount")).toObject());
    RigProfile profile{.name = object.value(QLatin1String("name")).toString(), .rig = {}};
    profile.rig.width_px = static_cast<int>(top.number("width_px"));
    profile.rig.height_px = static_cast<int>(top.number("height_px"));
    profile.rig.mount = mountFrom(mount_reader);
    auto lens = lensFrom(lens_reader);
    for (const Reader* reader : {&top, &lens_reader, &mount_reader}) {
        if (!reader->missing().isEmpty()) {
            return tl::unexpected(missingField(reader->missing()));
        }
    }
    if (!lens) {
        return tl::unexpected(lens.error());
    }
    profile.rig.lens = *lens;
    return profile;
}

core::Result<RigProfile> loadRigProfile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile, say("The rig profile cannot be read."),
                          say("Check that the file is there."), path + QStringLiteral(": ") + file.errorString());
    }
    return rigProfileFromJson(file.read(1 << 20));
}

core::Result<void> saveRigProfile(const RigProfile& profile, const QString& path) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(rigProfileToJson(profile)) < 0 || !file.commit()) {
        return core::fail(core::ErrorKind::kFile, say("The rig profile cannot be written."),
                          say("Choose another folder."), path + QStringLiteral(": ") + file.errorString());
    }
    return {};
}

}  // namespace pmts::app
