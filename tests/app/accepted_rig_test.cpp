#include "field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

CalibrationRecord recordFor(const CameraUse& use) {
    return {.method = CalibrationMethod::kSelfCalibration,
            .utc = QDateTime(QDate(2026, 6, 1), QTime(8, 30), Qt::UTC),
            .rms_px = 0.041,
            .held_out_px = 0.047,
            .temperature_c = 21.5,
            .camera = use,
            .instrument = QStringLiteral("Geodimeter 5603"),
            .remark = {},
            .standard_deviations = {{QStringLiteral("f [px]"), 0.12}},
            .residuals = {{.px = {100, 50}, .residual_px = {0.03, -0.04}, .held_out = true}}};
}

CameraUse simulatedUse() { return {.source = video::SourceKind::kSimulated, .camera = {}, .size = {1280, 720}, .pixel_format = {}}; }

CameraUse webcamUse(QSize size = {1280, 720}) {
    return {.source = video::SourceKind::kV4l2, .camera = QStringLiteral("HD Pro Webcam"), .size = size,
            .pixel_format = QStringLiteral("MJPG"), .focus = 30.0};
}

camera::Rig rigWithHeight(double up_m) {
    camera::Rig rig = simulatedRigProfile().rig;
    rig.mount.offset_m.z() = up_m;
    return rig;
}

double upOf(const RigProfile& profile) { return profile.rig.mount.offset_m.z(); }

class AcceptedRigTest : public testing::Test {
protected:
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("settings.ini"));
    Preferences preferences{path};
};

TEST_F(AcceptedRigTest, RigOfTheSimulatedCameraIsUsedAndKeptOverARestart) {
    const double nominal_m = upOf(simulatedRigProfile());
    EXPECT_EQ(upOf(preferences.settings().rigOf(video::SourceKind::kSimulated)), nominal_m) << "first start";
    const QString name = preferences.acceptRig(rigWithHeight(0.077), recordFor(simulatedUse()));
    preferences.save();

    const Settings back = Settings::load(path);
    EXPECT_EQ(upOf(back.rigOf(video::SourceKind::kSimulated)), 0.077);
    EXPECT_EQ(upOf(back.chosenRig()), 0.077);
    ASSERT_TRUE(back.profileNamed(name));
    EXPECT_EQ(back.profileNamed(name)->previous->rig.mount.offset_m.z(), nominal_m);
}

TEST_F(AcceptedRigTest, RecordComesBackFromTheSettingsFileWhole) {
    const QString name = preferences.acceptRig(rigWithHeight(0.077), recordFor(webcamUse()));
    preferences.save();
    const Settings back = Settings::load(path);
    ASSERT_TRUE(back.profileNamed(name));
    const CalibrationRecord record = back.profileNamed(name)->calibration.value();
    EXPECT_EQ(record.method, CalibrationMethod::kSelfCalibration);
    EXPECT_EQ(record.utc, recordFor({}).utc);
    EXPECT_EQ(record.held_out_px, 0.047);
    EXPECT_EQ(record.temperature_c, 21.5);
    EXPECT_EQ(record.camera, webcamUse());
    EXPECT_EQ(record.standard_deviations.at(QStringLiteral("f [px]")), 0.12);
    ASSERT_EQ(record.residuals.size(), 1U);
    EXPECT_EQ(record.residuals[0].residual_px.y(), -0.04);
    EXPECT_TRUE(record.residuals[0].held_out);
}

TEST_F(AcceptedRigTest, SecondCalibrationOfTheSameModeReplacesTheFirstAndGoingBackExchangesThem) {
    const QString name = preferences.acceptRig(rigWithHeight(0.05), recordFor(webcamUse()));
    EXPECT_EQ(preferences.acceptRig(rigWithHeight(0.06), recordFor(webcamUse())), name);
    EXPECT_EQ(preferences.settings().rig_profiles.size(), 1U);
    EXPECT_EQ(upOf(*preferences.settings().profileNamed(name)), 0.06);

    QSignalSpy changed(&preferences, &Preferences::changed);
    EXPECT_TRUE(preferences.goBackToPreviousRig(name));
    EXPECT_EQ(changed.size(), 1);
    EXPECT_EQ(upOf(*preferences.settings().profileNamed(name)), 0.05);
    EXPECT_TRUE(preferences.goBackToPreviousRig(name));
    EXPECT_EQ(upOf(*preferences.settings().profileNamed(name)), 0.06) << "and forward again";
    EXPECT_FALSE(preferences.goBackToPreviousRig(QStringLiteral("Nobody")));
}

TEST_F(AcceptedRigTest, AnotherModeOfTheSameCameraGetsItsOwnProfile) {
    const QString wide = preferences.acceptRig(rigWithHeight(0.05), recordFor(webcamUse()));
    camera::Rig small = rigWithHeight(0.06);
    small.width_px = 640;
    small.height_px = 360;
    const QString narrow = preferences.acceptRig(small, recordFor(webcamUse({640, 360})));
    EXPECT_NE(wide, narrow);
    EXPECT_EQ(upOf(preferences.settings().rigFor(webcamUse()).profile), 0.05);
    EXPECT_EQ(upOf(preferences.settings().rigFor(webcamUse({640, 360})).profile), 0.06);
}

TEST_F(AcceptedRigTest, FailedCheckIsASignOfAKnockUntilOnePasses) {
    const QString name = preferences.acceptRig(rigWithHeight(0.05), recordFor(webcamUse()));
    RigCheck check{.utc = QDateTime::currentDateTimeUtc(), .pointings = 5, .rms_px = 4.2, .passed = false};
    preferences.keepCheck(name, check);
    EXPECT_FALSE(preferences.settings().profileNamed(name)->knock_sign.isEmpty());
    check.passed = true;
    preferences.keepCheck(name, check);
    EXPECT_TRUE(preferences.settings().profileNamed(name)->knock_sign.isEmpty());
    preferences.save();
    const auto checks = Settings::load(path).profileNamed(name)->checks;
    ASSERT_EQ(checks.size(), 2U);
    EXPECT_EQ(checks[0].rms_px, 4.2);
    EXPECT_TRUE(checks[1].passed);
}

TEST_F(AcceptedRigTest, ProfileOfAnOlderProgramIsStillRead) {
    const auto old = rigProfileFromJson(R"({"name": "Old", "rig": {"version": 1, "width_px": 640, "height_px": 480,
        "lens": {"model": "brown", "f_px": 784, "cx_px": 315, "cy_px": 240},
        "mount": {"kind": "handle", "offset_m": [0, 0.085, 0.052]}}})");
    ASSERT_TRUE(old.has_value());
    EXPECT_FALSE(old->calibration || old->previous || old->use);
    EXPECT_TRUE(old->checks.empty());
}

class AcceptedRigInTheFieldTest : public FieldTest {};

TEST_F(AcceptedRigInTheFieldTest, LiveViewOfTheSimulatedCameraAimsWithTheAcceptedRigAtOnce) {
    EXPECT_EQ(live.model().rig().mount.offset_m.z(), upOf(simulatedRigProfile()));
    const QString name = preferences.acceptRig(rigWithHeight(0.077), recordFor(simulatedUse()));
    EXPECT_EQ(live.model().rig().mount.offset_m.z(), 0.077);
    preferences.goBackToPreviousRig(name);
    EXPECT_EQ(live.model().rig().mount.offset_m.z(), upOf(simulatedRigProfile()));
}

}  // namespace
}  // namespace pmts::app
