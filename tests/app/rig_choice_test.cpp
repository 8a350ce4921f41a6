#include "pmts/app/lab/rig_choice.hpp"

#include <gtest/gtest.h>

namespace pmts::app {
namespace {

CameraUse webcam(QSize size = {1280, 720}, std::optional<double> focus = 30.0) {
    return {.source = video::SourceKind::kV4l2, .camera = QStringLiteral("HD Pro Webcam"), .size = size,
            .pixel_format = QStringLiteral("MJPG"), .focus = focus};
}

RigProfile profileFor(const CameraUse& use, const char* name) {
    RigProfile profile = simulatedRigProfile();
    profile.name = QLatin1String(name);
    profile.use = use;
    profile.rig.width_px = use.size.width();
    profile.rig.height_px = use.size.height();
    return profile;
}

TEST(RigChoiceTest, ProfileOfTheCameraModeAndFocusIsPickedWhateverWasChosen) {
    const std::vector<RigProfile> profiles{profileFor(webcam({1280, 720}, 0.0), "far"), profileFor(webcam(), "near"),
                                           profileFor(webcam({640, 360}), "small")};
    const RigChoice choice = pickRig(profiles, QStringLiteral("far"), true, webcam());
    EXPECT_EQ(choice.profile.name, QStringLiteral("near"));
    EXPECT_EQ(choice.fitness, RigFitness::kFits);
    EXPECT_FALSE(choice.deservesWarning());
    EXPECT_TRUE(choice.sentence.contains(QStringLiteral("near")));
}

TEST(RigChoiceTest, OtherFocusIsUsedWithAWarning) {
    const RigChoice choice = pickRig({profileFor(webcam(), "near")}, {}, true, webcam({1280, 720}, 80.0));
    EXPECT_EQ(choice.fitness, RigFitness::kOtherFocus);
    EXPECT_TRUE(choice.deservesWarning());
}

TEST(RigChoiceTest, FocusThatNobodyKnowsFits) {
    EXPECT_EQ(pickRig({profileFor(webcam(), "near")}, {}, true, webcam({1280, 720}, {})).fitness, RigFitness::kFits);
}

TEST(RigChoiceTest, OtherSizeIsScaledAndSaidSo) {
    const RigChoice choice = pickRig({profileFor(webcam(), "near")}, {}, true, webcam({640, 360}));
    EXPECT_EQ(choice.fitness, RigFitness::kScaled);
    EXPECT_EQ(choice.profile.rig.width_px, 640);
    EXPECT_NEAR(choice.profile.rig.lens.focalLengthPx(), 700.0, 1e-9);
    EXPECT_TRUE(choice.deservesWarning());
    EXPECT_EQ(pickRig({profileFor(webcam(), "near")}, {}, true, webcam({640, 480})).fitness, RigFitness::kOtherShape);
}

TEST(RigChoiceTest, NewerCalibrationWinsAmongEquals) {
    std::vector<RigProfile> profiles{profileFor(webcam(), "new"), profileFor(webcam(), "old")};
    profiles[0].calibration = CalibrationRecord{.utc = QDateTime(QDate(2026, 6, 2), QTime(9, 0), Qt::UTC)};
    profiles[1].calibration = CalibrationRecord{.utc = QDateTime(QDate(2026, 6, 1), QTime(9, 0), Qt::UTC)};
    EXPECT_EQ(pickRig(profiles, {}, true, webcam()).profile.name, QStringLiteral("new"));
    EXPECT_EQ(pickRig(profiles, QStringLiteral("old"), true, webcam()).profile.name, QStringLiteral("old")) << "chosen";
}

TEST(RigChoiceTest, CameraWithoutAProfileIsAWarning) {
    CameraUse other = webcam();
    other.camera = QStringLiteral("Microscope");
    const RigChoice choice = pickRig({profileFor(webcam(), "near")}, QStringLiteral("near"), true, other);
    EXPECT_EQ(choice.fitness, RigFitness::kOtherCamera);
    EXPECT_TRUE(choice.deservesWarning());
}

TEST(RigChoiceTest, ChoiceByHandIsKeptWhenTheProgramMayNotPick) {
    const std::vector<RigProfile> profiles{profileFor(webcam({1280, 720}, 0.0), "far"), profileFor(webcam(), "near")};
    const RigChoice choice = pickRig(profiles, QStringLiteral("far"), false, webcam());
    EXPECT_EQ(choice.profile.name, QStringLiteral("far"));
    EXPECT_TRUE(choice.deservesWarning());
}

TEST(RigChoiceTest, ProfileChosenForARealCameraIsNotUsedForTheSimulatedOne) {
    const RigChoice choice = pickRig({profileFor(webcam(), "near")}, QStringLiteral("near"), true, CameraUse{});
    EXPECT_EQ(choice.fitness, RigFitness::kNominal);
    EXPECT_FALSE(choice.deservesWarning());
}

TEST(RigChoiceTest, NameThatIsTakenGetsANumber) {
    EXPECT_EQ(freeProfileName({}, webcam()), QStringLiteral("HD Pro Webcam 1280x720"));
    EXPECT_EQ(freeProfileName({profileFor(webcam(), "HD Pro Webcam 1280x720")}, webcam()), QStringLiteral("HD Pro Webcam 1280x720 2"));
}

}  // namespace
}  // namespace pmts::app
