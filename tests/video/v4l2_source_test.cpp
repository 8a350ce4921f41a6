#include "support.hpp"
#include "worker_source.hpp"

#include <gmock/gmock.h>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

/// Impatient, so that silence and replugging take a test little time.
constexpr WorkerTimes kQuick{.silent_after = 400ms, .reopen_every = 50ms, .abandon_after = 5s};

class V4l2SourceTest : public testing::Test {
protected:
    V4l2SourceTest() { folder_.plug("video0", "card=Webcam"); }

    SourceAddress address() const {
        return {SourceKind::kV4l2, folder_.node("video0"), QStringLiteral("Webcam")};
    }

    CameraFolder folder_;
    core::VideoGate gate_;
    WorkerSource source_{address(), [this] { return makeV4l2Capture(address()); }, gate_, kQuick};
    Watcher seen_{source_};
};

TEST_F(V4l2SourceTest, ShowsTheCamerasPicture) {
    source_.start({});
    ASSERT_TRUE(until([&] { return seen_.newest && seen_.newest->sequence >= 2; }));
    EXPECT_EQ(seen_.newest->image.size(), cv::Size(1280, 720));
    // The square is 40 px wide, at 8 px times the frame's number, in the middle rows.
    const int left = static_cast<int>(seen_.newest->sequence * 8 % (1280 - 40));
    EXPECT_GT(seen_.newest->image.at<cv::Vec3b>(360, left + 20)[1], 200);
    EXPECT_LT(seen_.newest->image.at<cv::Vec3b>(100, left + 20)[1], 150);
}

TEST_F(V4l2SourceTest, GivesTheWantedLayoutAndSize) {
    source_.start({.size = {640, 480}, .pixel_format = QStringLiteral("NV12")});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    EXPECT_EQ(seen_.newest->image.size(), cv::Size(640, 480));
}

TEST_F(V4l2SourceTest, FramesLostInTheDriverAreCounted) {
    folder_.plug("video0", "card=Webcam\nskip=4");
    source_.start({});
    ASSERT_TRUE(until([&] { return source_.statistics().lost >= 2; }));
    EXPECT_EQ(source_.state(), SourceState::kRunning);
}

TEST_F(V4l2SourceTest, UnpluggedCameraIsLostAndRunsAgainWhenItIsBack) {
    source_.start({});
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));

    folder_.unplug("video0");
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    EXPECT_TRUE(until([&] { return seen_.hasProblemWith("Webcam is not connected."); }));

    folder_.plug("video0", "card=Webcam");
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
    EXPECT_EQ(seen_.problems.size(), 1U);  // one trouble, one sentence
}

TEST_F(V4l2SourceTest, CameraThatComesBackUnderAnotherNodeIsFoundByItsName) {
    source_.start({});
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
    folder_.unplug("video0");
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    folder_.plug("video0", "card=Some other camera");
    folder_.plug("video3", "card=Webcam");
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
}

TEST_F(V4l2SourceTest, AnotherCameraUnderTheOldNodeIsNotTakenForIt) {
    folder_.plug("video0", "card=Some other camera");
    source_.start({});
    ASSERT_TRUE(until([&] { return seen_.hasProblemWith("Webcam is not connected."); }));
    EXPECT_EQ(seen_.newest, nullptr);
}

TEST_F(V4l2SourceTest, MissingCameraIsASentence) {
    folder_.unplug("video0");
    source_.start({});
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    ASSERT_TRUE(until([&] { return seen_.hasProblemWith("Webcam is not connected. Plug it in"); }));
}

TEST_F(V4l2SourceTest, BusyCameraIsASentenceAndStartsWhenItIsFree) {
    folder_.plug("video0", "card=Webcam\nbusy=1");
    source_.start({});
    ASSERT_TRUE(until([&] { return seen_.hasProblemWith("Webcam is used by another program."); }));
    folder_.plug("video0", "card=Webcam");
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
}

TEST_F(V4l2SourceTest, ForbiddenCameraSaysWhichGroupIsMissing) {
    folder_.plug("video0", "card=Webcam\nforbidden=1");
    source_.start({});
    EXPECT_TRUE(until([&] { return seen_.hasProblemWith("group \"video\""); }));
}

TEST_F(V4l2SourceTest, StalledCameraIsSilentAndRunsAgainByItself) {
    source_.start({});
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
    folder_.plug("video0", "card=Webcam\nstall=1");
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kSilent; }));
    EXPECT_TRUE(until([&] { return seen_.hasProblemWith("Webcam has sent no picture for 0.4 s."); }));

    folder_.plug("video0", "card=Webcam");
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
}

TEST_F(V4l2SourceTest, StopReleasesTheDeviceForTheNextStart) {
    for (int i = 0; i < 3; ++i) {
        source_.start({});
        ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
        source_.stop();
    }
    EXPECT_TRUE(seen_.problems.empty());
}

}  // namespace
}  // namespace pmts::video
