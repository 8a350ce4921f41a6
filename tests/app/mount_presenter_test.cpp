#include "pmts/app/lab/mount_presenter.hpp"

#include "app/lab_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

using camera::MountKind;
using testing::HasSubstr;

class MountPresenterTest : public LabTest {
protected:
    bool check(MountKind truth) {
        look({}, simulator::simulatedRig({.mount = truth}));
        connectInstrument();
        EXPECT_TRUE(turnTo(0, 99));
        showFrames(3);
        mount.start();
        return watch([this] { return !mount.isBusy(); });
    }

    MountPresenter mount{live, instrument, preferences, messages, Threading::kCallersThread};
};

TEST_F(MountPresenterTest, CameraOnTheTelescopeIsFoundAndTheTelescopeComesBack) {
    ASSERT_TRUE(check(MountKind::kTelescope));

    ASSERT_TRUE(mount.check().has_value()) << qPrintable(mount.step());
    EXPECT_EQ(mount.check()->kind, MountKind::kTelescope);
    EXPECT_EQ(mount.state(), DeviceState::kGood);
    EXPECT_THAT(instrument.track().newest()->pointing.va, test::IsNearAngle(Angle::fromGon(99), Angle::fromMgon(3)));
}

TEST_F(MountPresenterTest, CameraOnTheHandleIsFoundAndTakenIntoTheRig) {
    ASSERT_TRUE(check(MountKind::kHandle));
    ASSERT_TRUE(mount.check().has_value()) << qPrintable(mount.step());
    EXPECT_EQ(mount.check()->kind, MountKind::kHandle);
    EXPECT_EQ(mount.state(), DeviceState::kWarning);  // the profile says telescope

    mount.accept(MountKind::kHandle);

    EXPECT_EQ(live.model().rig().mount.kind, MountKind::kHandle);
    EXPECT_EQ(mount.state(), DeviceState::kGood);
}

TEST_F(MountPresenterTest, BlankPictureIsRefusedWithASentence) {
    connectInstrument();
    camera->picture = [](core::Duration) { return cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(20)); };
    showFrames();
    mount.start();
    ASSERT_TRUE(watch([this] { return !mount.isBusy(); }));

    EXPECT_EQ(mount.state(), DeviceState::kFailed);
    EXPECT_THAT(mount.step().toStdString(), HasSubstr("too little to follow"));
}

TEST_F(MountPresenterTest, WithoutInstrumentNothingStarts) {
    camera->show(clock.now());
    mount.start();

    EXPECT_FALSE(mount.isBusy());
    EXPECT_THAT(mount.step().toStdString(), HasSubstr("connect"));
}

TEST_F(MountPresenterTest, CancelEndsTheCheck) {
    connectInstrument();
    showFrames();
    mount.start();
    mount.cancel();

    EXPECT_FALSE(mount.isBusy());
    EXPECT_THAT(mount.step().toStdString(), HasSubstr("cancelled"));
}

TEST_F(MountPresenterTest, CancelStopsItsOwnTurnAndNothingThatOthersAskedFor) {
    connectInstrument();
    ASSERT_TRUE(turnTo(0, 99));
    showFrames();
    mount.start();
    showFrames(1);
    ASSERT_TRUE(instrument.isBusy()) << "it turns";
    QSignalSpy read(&instrument, &InstrumentDesk::labelRead);
    instrument.readLabel(22);
    mount.cancel();
    pass(10s);

    EXPECT_EQ(read.count(), 1);
    EXPECT_FALSE(instrument.isBusy());
}

}  // namespace
}  // namespace pmts::app
