#include "pmts/app/lab/self_calibration_presenter.hpp"

#include "app/drawn_field.hpp"
#include "calibration/sweeps.hpp"
#include "pmts/camera/scaled_rig.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "targeting/pictures.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

simulator::StationSettings quickStation() {
    simulator::StationSettings settings;
    settings.baud = 0;  // the way over the wire is not what is tested
    return settings;
}

/// A knocked camera in a small mode before a textured wall 15 m away, five pictures a second, through the whole desk.
class SelfCalibrationPresenterTest : public DrawnFieldTest {
protected:
    SelfCalibrationPresenterTest() : DrawnFieldTest(quickStation()) {}

    void SetUp() override {
        seeWall(test::naturalTexture({1400, 800}, 4), 28, 16, truth, {.blur_px = 0.6});
        beginShowing(200ms);
    }
    bool runs(core::Duration limit = 600s) {
        return until([this] { return !calibration.isBusy(); }, limit);
    }

    camera::Rig truth = camera::scaledRig(simulator::simulatedRig({.rig_error = 2}), 640, 360);
    SelfCalibrationPresenter calibration{live, instrument, preferences, messages, Threading::kCallersThread};
};

TEST_F(SelfCalibrationPresenterTest, OneClickAndOneButtonCalibrateAKnockedCameraAndRejectChangesNothing) {
    const camera::LensModel before = live.model().rig().lens.model();
    ASSERT_TRUE(calibration.pickSpot({320, 180}));
    calibration.calibrate();
    ASSERT_TRUE(calibration.isBusy());
    const core::Duration began = clock.now();
    ASSERT_TRUE(runs()) << calibration.progress().sentence.toStdString();
    ASSERT_EQ(calibration.phase(), SelfCalibrationPhase::kSolved) << newestBar(messages).toStdString();
    EXPECT_LE(clock.now() - began, 240s) << "moves, looks and one distance";
    EXPECT_LE(calibration.progress().of, 36) << "24 are left for a second spot";
    const auto& view = calibration.view();
    ASSERT_TRUE(view.has_value());
    EXPECT_GE(view->residuals.size(), 30U);
    EXPECT_EQ(calibration.state(), DeviceState::kGood) << view->quality.toStdString();
    EXPECT_EQ(view->verdict.join(u' ').count("One range cannot tell"), 1);
    calibration.reject();
    EXPECT_FALSE(calibration.view().has_value());
    EXPECT_EQ(live.model().rig().lens.model(), before);
}

TEST_F(SelfCalibrationPresenterTest, AcceptedCalibrationIsTheRigFromThenOnWithItsProof) {
    ASSERT_TRUE(calibration.pickSpot({320, 180}));
    calibration.calibrate();
    ASSERT_TRUE(runs());
    ASSERT_EQ(calibration.phase(), SelfCalibrationPhase::kSolved) << newestBar(messages).toStdString();
    QSignalSpy kept(&calibration, &SelfCalibrationPresenter::accepted);
    calibration.accept();
    ASSERT_EQ(kept.size(), 1);
    const auto& profiles = preferences.settings().rig_profiles;
    ASSERT_FALSE(profiles.empty());
    EXPECT_LE(test::frameError_px(truth, profiles.back().rig, 15.0), 0.5) << "seen at the range of the spot";
    ASSERT_TRUE(profiles.back().calibration.has_value());
    EXPECT_EQ(profiles.back().calibration->method, CalibrationMethod::kSelfCalibration);
    EXPECT_TRUE(profiles.back().calibration->held_out_px.has_value());
    EXPECT_FALSE(profiles.back().calibration->standard_deviations.empty());
    EXPECT_EQ(calibration.phase(), SelfCalibrationPhase::kPick);
}

TEST_F(SelfCalibrationPresenterTest, CancelEndsTheSweepAndKeepsTheSpot) {
    ASSERT_TRUE(calibration.pickSpot({320, 180}));
    calibration.calibrate();
    ASSERT_TRUE(until([this] { return calibration.progress().done >= 3; }, 60s));
    EXPECT_TRUE(calibration.progress().sentence.startsWith("Pointing")) << calibration.progress().sentence.toStdString();
    EXPECT_GT(calibration.progress().seconds_left, 30);
    calibration.cancel();
    ASSERT_TRUE(runs(30s));
    EXPECT_EQ(calibration.phase(), SelfCalibrationPhase::kReady);
    EXPECT_FALSE(calibration.view().has_value());
}

TEST_F(SelfCalibrationPresenterTest, AllSpotsTogetherTakeSixtyPointingsAtTheMost) {
    int pointings = 0;
    const QObject counter;
    QObject::connect(&instrument, &InstrumentDesk::sweepStepped, &counter, [&] { ++pointings; });
    ASSERT_TRUE(calibration.pickSpot({320, 180}));
    calibration.calibrate();
    ASSERT_TRUE(runs());
    ASSERT_TRUE(calibration.pickSpot({300, 170}));
    EXPECT_TRUE(calibration.hasRoomForASpot());
    calibration.calibrate(true);
    ASSERT_TRUE(runs());
    ASSERT_EQ(calibration.spots(), 2) << newestBar(messages).toStdString();
    EXPECT_GT(pointings, 52) << "none but a few are left";
    EXPECT_LE(pointings, 60);

    ASSERT_TRUE(calibration.pickSpot({340, 190}));
    QSignalSpy refused(&calibration, &SelfCalibrationPresenter::refused);
    calibration.calibrate(true);
    EXPECT_FALSE(calibration.isBusy());
    ASSERT_EQ(refused.size(), 1);
    EXPECT_TRUE(refused.front().front().toString().startsWith("The 60 pointings of this calibration are used"));
    EXPECT_EQ(calibration.spots(), 2);
    EXPECT_EQ(calibration.phase(), SelfCalibrationPhase::kSolved) << "what is found can still be accepted";

    ASSERT_TRUE(calibration.pickSpot({340, 190}));
    calibration.calibrate();
    EXPECT_TRUE(calibration.isBusy()) << "anew, with this spot alone";
    EXPECT_EQ(calibration.spots(), 0);
    calibration.cancel();
    ASSERT_TRUE(runs(30s));
}

TEST_F(SelfCalibrationPresenterTest, WithoutASpotOrAnInstrumentItSaysWhatIsMissing) {
    QSignalSpy refused(&calibration, &SelfCalibrationPresenter::refused);
    calibration.calibrate();
    EXPECT_EQ(refused.size(), 1);
    EXPECT_TRUE(calibration.step().startsWith("Click a sharp spot"));
    ASSERT_TRUE(calibration.pickSpot({300, 150}));
    instrument.disconnectInstrument();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kDisconnected; }));
    calibration.calibrate();
    EXPECT_TRUE(refused.back().first().toString().contains("not connected"));
}

TEST_F(SelfCalibrationPresenterTest, PickedSpotIsDrawnWhereTheNewestPictureShowsIt) {
    ASSERT_TRUE(calibration.pickSpot({320, 180}));
    const auto here = calibration.spotPx();
    ASSERT_TRUE(here.has_value());
    EXPECT_LT(std::hypot(here->x() - 320, here->y() - 180), 0.5);
    ASSERT_TRUE(turnTo(5, 100));
    pass(500ms);
    ASSERT_TRUE(calibration.spotPx().has_value());
    EXPECT_LT(calibration.spotPx()->x(), 280);
}

}  // namespace
}  // namespace pmts::app
