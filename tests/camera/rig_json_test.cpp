#include "pmts/camera/rig_json.hpp"

#include "support/matchers.hpp"

#include <QJsonArray>
#include <QJsonDocument>

namespace pmts::camera {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;

Rig handleRig() {
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = 762.1,
                              .cx_px = 318.3,
                              .cy_px = 236.7,
                              .k1 = -0.31,
                              .k2 = 0.1,
                              .k3 = 1.0 / 3,
                              .p1 = 1e-4,
                              .p2 = -2e-4});
    rig.mount = {.kind = MountKind::kHandle,
                 .offset_m = {0.001, 0.125, -0.035},
                 .yaw = Angle::fromGon(0.1),
                 .pitch = Angle::fromGon(1.7),
                 .twist = Angle::fromGon(-0.3)};
    rig.width_px = 640;
    rig.height_px = 480;
    return rig;
}

/// Through the text of a file and back.
QJsonObject throughText(const QJsonObject& json) {
    return QJsonDocument::fromJson(QJsonDocument(json).toJson()).object();
}

QJsonObject with(QJsonObject json, const char* part, const char* name, const QJsonValue& value) {
    QJsonObject inner = json.value(QLatin1String(part)).toObject();
    inner.insert(QLatin1String(name), value);
    json.insert(QLatin1String(part), inner);
    return json;
}

TEST(RigJsonTest, RigComesBackBitByBit) {
    const auto rig = rigFromJson(throughText(rigToJson(handleRig())));
    ASSERT_TRUE(rig.has_value());
    EXPECT_EQ(std::get<BrownLens>(rig->lens.model()), std::get<BrownLens>(handleRig().lens.model()));
    EXPECT_EQ(rig->mount.kind, MountKind::kHandle);
    EXPECT_EQ(rig->mount.offset_m, handleRig().mount.offset_m);
    EXPECT_EQ(rig->mount.yaw, handleRig().mount.yaw);
    EXPECT_EQ(rig->mount.pitch, handleRig().mount.pitch);
    EXPECT_EQ(rig->mount.twist, handleRig().mount.twist);
    EXPECT_EQ(rig->width_px, 640);
    EXPECT_EQ(rig->height_px, 480);
}

TEST(RigJsonTest, DistortionTableComesBackBitByBit) {
    Rig rig;
    rig.lens = Lens(RadialTableLens{
        .cx_px = 315, .cy_px = 240, .rows = {{0, 0}, {30, 0.0394}, {60, 0.07871}, {400, 0.47}}});
    const auto again = rigFromJson(throughText(rigToJson(rig)));
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(std::get<RadialTableLens>(again->lens.model()), std::get<RadialTableLens>(rig.lens.model()));
    EXPECT_EQ(again->mount.kind, MountKind::kTelescope);
}

TEST(RigJsonTest, RationalLensWithItsResidualsAndFisheyeComeBackBitByBit) {
    Rig rig;
    rig.lens = Lens(RationalLens{.f_px = 900.5, .cx_px = 641, .cy_px = 359, .k1 = 0.2, .k4 = 0.5, .k6 = 1.0 / 7})
                   .withResiduals(ResidualTable{.left_px = 10,
                                                .top_px = 20,
                                                .step_x_px = 600,
                                                .step_y_px = 300,
                                                .columns = 2,
                                                .rows = 2,
                                                .nodes_px = {{0.1, 0.2}, {0, 0}, {-1.0 / 3, 0}, {0, 0.5}}});
    const auto again = rigFromJson(throughText(rigToJson(rig)));
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->lens.model(), rig.lens.model());
    EXPECT_EQ(again->lens.residuals(), rig.lens.residuals());

    rig.lens = Lens(FisheyeLens{.f_px = 500.25, .cx_px = 640, .cy_px = 360, .k1 = -0.02, .k4 = 1e-4});
    const auto fisheye = rigFromJson(throughText(rigToJson(rig)));
    ASSERT_TRUE(fisheye.has_value());
    EXPECT_EQ(fisheye->lens.model(), rig.lens.model());
    EXPECT_FALSE(fisheye->lens.residuals().has_value());
}

TEST(RigJsonTest, ResidualsThatFoldThePictureAreRefused) {
    Rig rig;
    rig.lens = Lens(BrownLens{}).withResiduals(
        ResidualTable{.columns = 2, .rows = 2, .nodes_px = {{0, 0}, {1, 0}, {0, 0}, {0, 0}}});
    QJsonObject json = rigToJson(rig);
    QJsonObject residuals = json["lens"].toObject()["residuals"].toObject();
    residuals["nodes_px"] = QJsonArray{QJsonArray{0, 0}, QJsonArray{90, 0}, QJsonArray{0, 0}, QJsonArray{0, 0}};
    const auto folded = rigFromJson(with(json, "lens", "residuals", residuals));
    ASSERT_THAT(folded, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(folded.error().happened.contains("residuals"));
}

TEST(RigJsonTest, FileWrittenByHandNeedsOnlyTheEssentials) {
    const QByteArray file = R"({"version": 1, "width_px": 1280, "height_px": 720,
        "lens": {"model": "brown", "f_px": 1500, "cx_px": 640, "cy_px": 360},
        "mount": {"kind": "telescope", "offset_m": [0, 0.05, 0.12]}})";
    const auto rig = rigFromJson(QJsonDocument::fromJson(file).object());
    ASSERT_TRUE(rig.has_value());
    EXPECT_DOUBLE_EQ(rig->lens.focalLengthPx(), 1500);
    EXPECT_EQ(rig->mount.offset_m, Eigen::Vector3d(0, 0.05, 0.12));
    EXPECT_EQ(rig->mount.twist, Angle());
}

TEST(RigJsonTest, SentenceNamesTheEntryThatIsWrong) {
    const QJsonObject good = rigToJson(handleRig());
    const auto refusedBecauseOf = [&](const char* part, const char* name, const QJsonValue& value) {
        const auto rig = rigFromJson(with(good, part, name, value));
        return rig ? QString() : rig.error().happened;
    };
    EXPECT_TRUE(refusedBecauseOf("lens", "f_px", "wide").contains("f_px"));
    EXPECT_TRUE(refusedBecauseOf("lens", "f_px", -700).contains("f_px"));
    EXPECT_TRUE(refusedBecauseOf("lens", "model", "pinhole").contains("model"));
    EXPECT_TRUE(refusedBecauseOf("mount", "kind", "tripod").contains("kind"));
    EXPECT_TRUE(refusedBecauseOf("mount", "offset_m", QJsonArray{0.1, 0.2}).contains("offset_m"));
    EXPECT_TRUE(refusedBecauseOf("mount", "pitch_gon", QJsonValue::Null).contains("pitch_gon"));
}

TEST(RigJsonTest, DescriptionThatIsNoRigIsRefused) {
    EXPECT_THAT(rigFromJson({}), FailedWith(ErrorKind::kBadInput));
    QJsonObject newer = rigToJson(handleRig());
    newer.insert("version", kRigJsonVersion + 1);
    EXPECT_THAT(rigFromJson(newer), FailedWith(ErrorKind::kBadInput));
    newer.insert("version", 0);
    EXPECT_THAT(rigFromJson(newer), FailedWith(ErrorKind::kBadInput));
    QJsonObject flat = rigToJson(handleRig());
    flat.insert("width_px", 0);
    EXPECT_THAT(rigFromJson(flat), FailedWith(ErrorKind::kBadInput));
}

TEST(RigJsonTest, TableThatFallsIsRefused) {
    const QJsonObject lens{
        {"model", "radial_table"},
        {"cx_px", 0},
        {"cy_px", 0},
        {"rows", QJsonArray{QJsonArray{0, 0}, QJsonArray{30, 0.04}, QJsonArray{60, 0.03}}}};
    QJsonObject json = rigToJson(handleRig());
    json.insert("lens", lens);
    const auto rig = rigFromJson(json);
    ASSERT_THAT(rig, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(rig.error().happened.contains("rows"));
}

}  // namespace
}  // namespace pmts::camera
