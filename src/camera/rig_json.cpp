#include "pmts/camera/rig_json.hpp"

#include <QCoreApplication>
#include <QJsonArray>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace pmts::camera {
namespace {

QString text(const char* sentence) { return QCoreApplication::translate("RigJson", sentence); }

/// Reads entries and keeps the name of the first one that cannot be used.
class Reader {
public:
    double number(const QJsonObject& from, const char* name) {
        return checked(from.value(QLatin1String(name)), name);
    }

    double numberOr(const QJsonObject& from, const char* name, double absent) {
        return from.contains(QLatin1String(name)) ? number(from, name) : absent;
    }

    int size_px(const QJsonObject& from, const char* name) {
        const double size = number(from, name);
        if (!(size >= 1 && size <= 100000)) {
            refuse(name);
            return 1;
        }
        return static_cast<int>(size);
    }

    QJsonObject object(const QJsonObject& from, const char* name) {
        if (!from.value(QLatin1String(name)).isObject()) {
            refuse(name);
        }
        return from.value(QLatin1String(name)).toObject();
    }

    double checked(const QJsonValue& value, const char* name) {
        if (!value.isDouble() || !std::isfinite(value.toDouble())) {
            refuse(name);
        }
        return value.toDouble();
    }

    void refuse(const char* name) {
        if (refused_.isEmpty()) {
            refused_ = QLatin1String(name);
        }
    }

    [[nodiscard]] const QString& refused() const { return refused_; }

private:
    QString refused_;
};

/// How a lens with a focal length is called in the file, and its distortion: every entry that may be absent, then 0.
template <class Model>
struct Form;

template <>
struct Form<BrownLens> {
    static constexpr const char* kName = "brown";
    static constexpr std::pair<const char*, double BrownLens::*> kDistortion[] = {
        {"k1", &BrownLens::k1}, {"k2", &BrownLens::k2}, {"k3", &BrownLens::k3}, {"p1", &BrownLens::p1}, {"p2", &BrownLens::p2}};
};

template <>
struct Form<RationalLens> {
    static constexpr const char* kName = "rational";
    static constexpr std::pair<const char*, double RationalLens::*> kDistortion[] = {
        {"k1", &RationalLens::k1}, {"k2", &RationalLens::k2}, {"k3", &RationalLens::k3}, {"k4", &RationalLens::k4},
        {"k5", &RationalLens::k5}, {"k6", &RationalLens::k6}, {"p1", &RationalLens::p1}, {"p2", &RationalLens::p2}};
};

template <>
struct Form<FisheyeLens> {
    static constexpr const char* kName = "fisheye";
    static constexpr std::pair<const char*, double FisheyeLens::*> kDistortion[] = {
        {"k1", &FisheyeLens::k1}, {"k2", &FisheyeLens::k2}, {"k3", &FisheyeLens::k3}, {"k4", &FisheyeLens::k4}};
};

template <class Model>
QJsonObject lensToJson(const Model& lens) {
    QJsonObject json{{"model", Form<Model>::kName}, {"f_px", lens.f_px}, {"cx_px", lens.cx_px}, {"cy_px", lens.cy_px}};
    for (const auto& [name, value] : Form<Model>::kDistortion) {
        json.insert(QLatin1String(name), lens.*value);
    }
    return json;
}

template <class Model>
Model lensFromJson(const QJsonObject& json, Reader& read) {
    Model lens;
    lens.f_px = read.number(json, "f_px");
    lens.cx_px = read.number(json, "cx_px");
    lens.cy_px = read.number(json, "cy_px");
    for (const auto& [name, value] : Form<Model>::kDistortion) {
        lens.*value = read.numberOr(json, name, 0);
    }
    return lens;
}

QJsonObject lensToJson(const RadialTableLens& lens) {
    QJsonArray rows;
    for (const RadialTableLens::Row& row : lens.rows) {
        rows.append(QJsonArray{row.radius_px, row.angle_rad});
    }
    return {{"model", "radial_table"}, {"cx_px", lens.cx_px}, {"cy_px", lens.cy_px}, {"rows", rows}};
}

QJsonObject tableToJson(const ResidualTable& table) {
    QJsonArray nodes;
    for (const Eigen::Vector2d& node : table.nodes_px) {
        nodes.append(QJsonArray{node.x(), node.y()});
    }
    return {{"left_px", table.left_px},
            {"top_px", table.top_px},
            {"step_x_px", table.step_x_px},
            {"step_y_px", table.step_y_px},
            {"columns", table.columns},
            {"rows", table.rows},
            {"nodes_px", nodes}};
}

ResidualTable residualsFromJson(const QJsonObject& json, Reader& read) {
    ResidualTable table{.left_px = read.number(json, "left_px"),
                        .top_px = read.number(json, "top_px"),
                        .step_x_px = read.number(json, "step_x_px"),
                        .step_y_px = read.number(json, "step_y_px"),
                        .columns = read.size_px(json, "columns"),
                        .rows = read.size_px(json, "rows"),
                        .nodes_px = {}};
    const QJsonArray nodes = json.value(QLatin1String("nodes_px")).toArray();
    for (const auto& node : nodes) {
        table.nodes_px.emplace_back(read.checked(node.toArray().at(0), "nodes_px"),
                                    read.checked(node.toArray().at(1), "nodes_px"));
    }
    return table;
}

Lens withResidualsFromJson(const Lens& lens, const QJsonObject& json, Reader& read) {
    if (!json.contains(QLatin1String("residuals"))) {
        return lens;
    }
    try {
        return lens.withResiduals(residualsFromJson(read.object(json, "residuals"), read));
    } catch (const std::logic_error&) {  // numbers, but not those of a flat and complete grid
        read.refuse("residuals");
    }
    return lens;
}

RadialTableLens tableFromJson(const QJsonObject& json, Reader& read) {
    RadialTableLens lens{
        .cx_px = read.number(json, "cx_px"), .cy_px = read.number(json, "cy_px"), .rows = {}};
    const QJsonArray rows = json.value(QLatin1String("rows")).toArray();
    for (const auto& row : rows) {
        lens.rows.push_back({.radius_px = read.checked(row.toArray().at(0), "rows"),
                             .angle_rad = read.checked(row.toArray().at(1), "rows")});
    }
    return lens;
}

Lens lensFromJson(const QJsonObject& json, Reader& read) {
    const QString model = json.value(QLatin1String("model")).toString();
    try {
        if (model == QLatin1String(Form<BrownLens>::kName)) {
            return Lens(lensFromJson<BrownLens>(json, read));
        }
        if (model == QLatin1String("radial_table")) {
            return Lens(tableFromJson(json, read));
        }
        if (model == QLatin1String(Form<RationalLens>::kName)) {
            return Lens(lensFromJson<RationalLens>(json, read));
        }
        if (model == QLatin1String(Form<FisheyeLens>::kName)) {
            return Lens(lensFromJson<FisheyeLens>(json, read));
        }
        read.refuse("model");
    } catch (const std::logic_error&) {  // numbers, but not those of a lens
        read.refuse(model == QLatin1String("radial_table") ? "rows" : "f_px");
    }
    return {};
}

Mount mountFromJson(const QJsonObject& json, Reader& read) {
    Mount mount{.yaw = core::Angle::fromGon(read.numberOr(json, "yaw_gon", 0)),
                .pitch = core::Angle::fromGon(read.numberOr(json, "pitch_gon", 0)),
                .twist = core::Angle::fromGon(read.numberOr(json, "twist_gon", 0))};
    const QString kind = json.value(QLatin1String("kind")).toString();
    mount.kind = kind == QLatin1String("handle") ? MountKind::kHandle : MountKind::kTelescope;
    if (kind != QLatin1String("handle") && kind != QLatin1String("telescope")) {
        read.refuse("kind");
    }
    const QJsonArray offset_m = json.value(QLatin1String("offset_m")).toArray();
    for (int axis = 0; axis < 3; ++axis) {
        mount.offset_m[axis] = read.checked(offset_m.at(axis), "offset_m");
    }
    return mount;
}

}  // namespace

QJsonObject rigToJson(const Rig& rig) {
    const Mount& mount = rig.mount;
    const QJsonObject mount_json{
        {"kind", mount.kind == MountKind::kHandle ? "handle" : "telescope"},
        {"offset_m", QJsonArray{mount.offset_m.x(), mount.offset_m.y(), mount.offset_m.z()}},
        {"yaw_gon", mount.yaw.gon()},
        {"pitch_gon", mount.pitch.gon()},
        {"twist_gon", mount.twist.gon()}};
    QJsonObject lens_json = std::visit([](const auto& lens) { return lensToJson(lens); }, rig.lens.model());
    if (rig.lens.residuals()) {
        lens_json.insert(QLatin1String("residuals"), tableToJson(*rig.lens.residuals()));
    }
    return {{"version", kRigJsonVersion},
            {"width_px", rig.width_px},
            {"height_px", rig.height_px},
            {"lens", lens_json},
            {"mount", mount_json}};
}

core::Result<Rig> rigFromJson(const QJsonObject& json) {
    Reader read;
    const double version = read.number(json, "version");
    if (version > kRigJsonVersion) {
        return core::fail(core::ErrorKind::kBadInput,
                          text("The camera description was written by a newer program."),
                          text("Update the program, or calibrate the camera again."),
                          QStringLiteral("version %1").arg(version));
    }
    if (version < 1) {
        read.refuse("version");
    }
    const QJsonObject lens_json = read.object(json, "lens");
    const Rig rig{.lens = withResidualsFromJson(lensFromJson(lens_json, read), lens_json, read),
                  .mount = mountFromJson(read.object(json, "mount"), read),
                  .width_px = read.size_px(json, "width_px"),
                  .height_px = read.size_px(json, "height_px")};
    if (!read.refused().isEmpty()) {
        return core::fail(core::ErrorKind::kBadInput,
                          text("The camera description has no usable entry \"%1\".").arg(read.refused()),
                          text("Correct that entry, or calibrate the camera again."));
    }
    return rig;
}

}  // namespace pmts::camera
