// Modes, controls, pause and stills of the V4L2 worker, on a virtual camera.
#include "support.hpp"
#include "v4l2_capture.hpp"
#include "worker_source.hpp"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

constexpr WorkerTimes kQuick{.silent_after = 400ms, .reopen_every = 50ms, .abandon_after = 5s};

std::optional<CameraControlState> find(const DeviceReport& report, CameraControl control) {
    for (const CameraControlState& state : report.controls) {
        if (state.range.control == control) {
            return state;
        }
    }
    return std::nullopt;
}

class V4l2ModesTest : public testing::Test {
protected:
    V4l2ModesTest() {
        folder_.plug("video0", "card=Webcam");
        QObject::connect(&source_, &VideoSource::stillTaken, &seen_, [this](const FullStill& still) { still_ = still; });
        QObject::connect(&source_, &VideoSource::stillFailed, &seen_, [this](const core::Error&) { still_failed_ = true; });
    }

    SourceAddress address() const {
        return {SourceKind::kV4l2, folder_.node("video0"), QStringLiteral("Webcam")};
    }
    bool runs(const VideoFormat& wanted = {}) {
        source_.start(wanted);
        return until([&] { return source_.state() == SourceState::kRunning && !source_.report().formats.empty(); });
    }
    ControlValue valueNow(CameraControl control) const {
        return find(source_.report(), control).value_or(CameraControlState{}).value;
    }

    CameraFolder folder_;
    core::VideoGate gate_;
    WorkerSource source_{address(), [this] { return makeV4l2Capture(address()); }, gate_, kQuick};
    Watcher seen_{source_};
    std::optional<FullStill> still_;
    bool still_failed_ = false;
};

TEST_F(V4l2ModesTest, ListNamesCamerasAndLeavesOutTheirMetadataNodes) {
    folder_.plug("video1", "card=Webcam\nmetadata=1");
    folder_.plug("video10", "card=Telescope camera");
    const std::vector<SourceAddress> cameras = v4l2Cameras(folder_.path());
    ASSERT_EQ(cameras.size(), 2U);
    EXPECT_EQ(cameras[0].name, QStringLiteral("Webcam"));
    EXPECT_EQ(cameras[1].name, QStringLiteral("Telescope camera"));
}

TEST_F(V4l2ModesTest, ReportsSizesRatesAndPixelFormats) {
    ASSERT_TRUE(runs());
    const DeviceReport report = source_.report();
    EXPECT_THAT(report.formats, Contains(VideoFormat{{1920, 1080}, 15.0, QStringLiteral("NV12")}));
    EXPECT_THAT(report.formats, Contains(VideoFormat{{640, 480}, 30.0, QStringLiteral("YUYV")}));
    EXPECT_EQ(report.format, (VideoFormat{{1280, 720}, 30.0, QStringLiteral("YUYV")}));
}

TEST_F(V4l2ModesTest, RunsAtTheRateThatWasChosen) {
    const auto begun_at = std::chrono::steady_clock::now();
    ASSERT_TRUE(runs({.size = {640, 480}, .rate_hz = 15.0}));
    EXPECT_EQ(source_.report().format.rate_hz, 15.0);
    ASSERT_TRUE(until([&] { return source_.statistics().delivered >= 12; }));
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_at;
    EXPECT_LE(static_cast<double>(source_.statistics().delivered), 15.0 * passed.count() + 1.0)
        << "a busy machine may lose pictures, none makes more of them";
}

TEST_F(V4l2ModesTest, MotionJpegIsDecodedToTheSamePicture) {
    QTemporaryDir pictures;
    cv::Mat picture(1080, 1920, CV_8UC3, cv::Scalar(40, 90, 200));
    cv::imwrite(pictures.filePath(QStringLiteral("0.jpg")).toStdString(), picture);
    folder_.plug("video0", "card=Webcam\njpeg=" + pictures.path().toUtf8());
    ASSERT_TRUE(runs({.size = {1920, 1080}, .pixel_format = QStringLiteral("MJPG")}));
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    ASSERT_EQ(seen_.newest->image.size(), cv::Size(1920, 1080));
    EXPECT_LT(cv::norm(seen_.newest->image, picture, cv::NORM_INF), 4.0);
}

TEST_F(V4l2ModesTest, ControlsComeWithRangeStepUsualValueAndAutomatic) {
    ASSERT_TRUE(runs());
    const auto exposure = find(source_.report(), CameraControl::kExposure);
    ASSERT_TRUE(exposure);
    EXPECT_NEAR(exposure->range.minimum, 0.3, 1e-9);  // 3 x 0.1 ms
    EXPECT_NEAR(exposure->range.maximum, 204.7, 1e-9);
    EXPECT_NEAR(exposure->range.usual, 25.0, 1e-9);
    EXPECT_TRUE(exposure->range.has_auto);
    EXPECT_TRUE(exposure->value.automatic);
    EXPECT_FALSE(find(source_.report(), CameraControl::kGain)->range.has_auto);
    EXPECT_EQ(find(source_.report(), CameraControl::kFocus)->range.step, 5.0);
    EXPECT_FALSE(find(source_.report(), CameraControl::kZoom)) << "the camera has no zoom: none is offered";
}

TEST_F(V4l2ModesTest, CameraWithoutControlsOffersNone) {
    folder_.plug("video0", "card=Webcam\nbare=1");
    ASSERT_TRUE(runs());
    EXPECT_TRUE(source_.report().controls.empty());
}

TEST_F(V4l2ModesTest, ManualValueIsSetOnTheNearestStepWithinTheRange) {
    ASSERT_TRUE(runs());
    source_.setControls({{CameraControl::kFocus, false, 63.0}, {CameraControl::kExposure, false, 500.0}});
    ASSERT_TRUE(until([&] { return valueNow(CameraControl::kFocus).value == 65.0; }));
    EXPECT_FALSE(valueNow(CameraControl::kFocus).automatic);
    EXPECT_NEAR(valueNow(CameraControl::kExposure).value, 204.7, 1e-9);
    EXPECT_TRUE(seen_.problems.empty());
}

TEST_F(V4l2ModesTest, LockKeepsWhatTheAutomaticHasChosen) {
    ASSERT_TRUE(runs());
    source_.setControls({{.control = CameraControl::kExposure, .hold = true}});
    ASSERT_TRUE(until([&] { return !valueNow(CameraControl::kExposure).automatic; }));
    EXPECT_NEAR(valueNow(CameraControl::kExposure).value, 25.0, 1e-9);

    source_.setControls({{CameraControl::kExposure, true, 0.0}});
    EXPECT_TRUE(until([&] { return valueNow(CameraControl::kExposure).automatic; }));
}

TEST_F(V4l2ModesTest, ReplugBringsTheControlsBack) {
    ASSERT_TRUE(runs());
    source_.setControls({{CameraControl::kGain, false, 77.0}});
    ASSERT_TRUE(until([&] { return valueNow(CameraControl::kGain).value == 77.0; }));
    folder_.unplug("video0");
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    folder_.plug("video3", "card=Webcam");  // a node that knows nothing of what was set before
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
    EXPECT_EQ(valueNow(CameraControl::kGain).value, 77.0);
    auto device = makeV4l2Capture({SourceKind::kV4l2, folder_.node("video3"), QStringLiteral("Webcam")});
    ASSERT_TRUE(device->open({}).has_value());
    EXPECT_EQ(find(device->report(), CameraControl::kGain)->value.value, 77.0) << "in the camera, not only in our books";
}

TEST_F(V4l2ModesTest, PauseKeepsTheDeviceAndDeliversNothing) {
    ASSERT_TRUE(runs());
    source_.pause();
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kPaused; }));
    const std::uint64_t delivered = source_.statistics().delivered;
    folder_.plug("video0", "card=Webcam\nbusy=1");  // would fail if the device had been let go
    source_.resume();
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
    EXPECT_LE(delivered, source_.statistics().delivered);
    EXPECT_EQ(source_.statistics().lost, 0U) << "what was not wanted is not lost";
    EXPECT_TRUE(seen_.problems.empty());
}

TEST_F(V4l2ModesTest, CameraUnpluggedWhilePausedIsPausedAgainWhenItIsBack) {
    ASSERT_TRUE(runs());
    source_.pause();
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kPaused; }));
    folder_.unplug("video0");
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    folder_.plug("video0", "card=Webcam");
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kPaused; }));
}

TEST_F(V4l2ModesTest, FullStillComesInTheLargeModeAndTheLiveViewGoesOn) {
    ASSERT_TRUE(runs({.size = {640, 480}}));
    source_.takeStill({.size = {1920, 1080}, .rate_hz = 15.0});
    ASSERT_TRUE(until([&] { return still_.has_value(); }));
    EXPECT_EQ(still_->frame->image.size(), cv::Size(1920, 1080));
    EXPECT_GT(still_->took, 0ms);
    const std::uint64_t delivered = source_.statistics().delivered;
    ASSERT_TRUE(until([&] { return source_.statistics().delivered > delivered + 2; }));
    EXPECT_EQ(seen_.newest->image.size(), cv::Size(640, 480));
    EXPECT_EQ(source_.report().format.size, QSize(640, 480));
    EXPECT_THAT(seen_.states, Not(Contains(SourceState::kLost)));
}

TEST_F(V4l2ModesTest, StillOfACameraThatIsUnpluggedMeanwhileFailsOnce) {
    ASSERT_TRUE(runs());
    folder_.plug("video0", "card=Webcam\nstall=1");
    folder_.unplug("video0");
    source_.takeStill({.size = {1920, 1080}});
    ASSERT_TRUE(until([&] { return source_.state() == SourceState::kLost; }));
    folder_.plug("video0", "card=Webcam");
    EXPECT_TRUE(until([&] { return still_failed_ || still_.has_value(); }));
    EXPECT_TRUE(until([&] { return source_.state() == SourceState::kRunning; }));
}

}  // namespace
}  // namespace pmts::video
