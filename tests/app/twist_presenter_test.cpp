#include "pmts/app/lab/twist_presenter.hpp"

#include "app/lab_fixture.hpp"

namespace pmts::app {
namespace {

using testing::HasSubstr;

class TwistPresenterTest : public LabTest {
protected:
    static camera::Rig twistedBy(double gon) {
        camera::Rig rig = simulator::simulatedRig();
        rig.mount.twist = Angle::fromGon(gon);
        return rig;
    }
    void stepBefore(const camera::Rig& truth) {
        look(QStringLiteral("laboratory"), truth);
        connectInstrument();
        ASSERT_TRUE(turnTo(270, 100));
        twist.setActive(true);
        ASSERT_TRUE(watch([this] { return twist.twist().has_value(); }, 10)) << qPrintable(twist.step());
    }

    TwistPresenter twist{live, instrument, preferences, messages, Threading::kCallersThread};
};

TEST_F(TwistPresenterTest, TwistIsShownLiveWithTheWayToTurn) {
    stepBefore(twistedBy(0.8));

    EXPECT_THAT(*twist.twist(), test::IsNearAngle(Angle::fromGon(0.8), Angle::fromMgon(10)));
    EXPECT_EQ(twist.state(), DeviceState::kWarning);
    EXPECT_THAT(twist.step().toStdString(), HasSubstr("anticlockwise"));
    EXPECT_GT(twist.line().size(), 20U);
    lookWith(twistedBy(-0.5));  // turned too far
    showFrames(6);
    EXPECT_THAT(*twist.twist(), test::IsNearAngle(Angle::fromGon(-0.5), Angle::fromMgon(10)));
    EXPECT_THAT(twist.step().toStdString(), HasSubstr("camera clockwise"));
}

TEST_F(TwistPresenterTest, UprightCameraIsVerified) {
    stepBefore(twistedBy(0.0));
    EXPECT_EQ(twist.state(), DeviceState::kGood);

    twist.verify();
    ASSERT_TRUE(watch([this] { return !twist.isVerifying(); }, 40));

    EXPECT_THAT(twist.proofText().toStdString(), HasSubstr("Verified"));
    EXPECT_EQ(twist.state(), DeviceState::kGood);
}

// The profile still has 0.3 gon of twist from before the camera was turned upright.
TEST_F(TwistPresenterTest, VerifiedTwistIsTheRigsAndStaysGoodWhenTheLineLeavesThePicture) {
    stepBefore(twistedBy(0.0));
    twist.verify();
    ASSERT_TRUE(watch([this] { return !twist.isVerifying(); }, 40));
    camera->picture = [](core::Duration) { return cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(128)); };
    showFrames(4);

    EXPECT_THAT(live.model().rig().mount.twist, test::IsNearAngle(Angle(), Angle::fromMgon(10)));
    EXPECT_EQ(twist.state(), DeviceState::kGood);
}

TEST_F(TwistPresenterTest, TwistIsTakenIntoTheRigInstead) {
    stepBefore(twistedBy(1.4));

    twist.accept();

    EXPECT_THAT(live.model().rig().mount.twist, test::IsNearAngle(Angle::fromGon(1.4), Angle::fromMgon(10)));
    EXPECT_EQ(twist.state(), DeviceState::kGood);
}

TEST_F(TwistPresenterTest, PictureWithoutALineSaysSo) {
    look({}, twistedBy(0));
    camera->picture = [](core::Duration) { return cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(128)); };
    connectInstrument();
    twist.setActive(true);
    showFrames(6);

    EXPECT_EQ(twist.state(), DeviceState::kFailed);
    EXPECT_THAT(twist.step().toStdString(), HasSubstr("No plumb line"));
}

TEST_F(TwistPresenterTest, NothingIsLookedAtWhileTheStepIsClosed) {
    look(QStringLiteral("laboratory"), twistedBy(0.8));
    connectInstrument();
    ASSERT_TRUE(turnTo(270, 100));
    showFrames(6);

    EXPECT_FALSE(twist.twist().has_value());
}

}  // namespace
}  // namespace pmts::app
