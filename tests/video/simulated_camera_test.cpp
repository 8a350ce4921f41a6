// The simulated camera's modes and controls: what is set reaches the painter.
#include "support.hpp"

#include <gmock/gmock.h>

namespace pmts::video {
namespace {

using testing::Contains;

class SimulatedCameraTest : public testing::Test {
protected:
    bool shows(const std::function<bool(const SimulatedExposure&)>& condition) {
        return until([&] {
            const std::lock_guard lock(mutex_);
            return setting_ && condition(*setting_);
        });
    }

    std::mutex mutex_;
    std::optional<SimulatedExposure> setting_;
    core::VideoGate gate_;
    std::unique_ptr<VideoSource> source_ = makeSimulatedSource(
        [this](core::Duration, const SimulatedExposure& setting) {
            const std::lock_guard lock(mutex_);
            setting_ = setting;
            camera::Frame frame;
            frame.image = cv::Mat(setting.size.height(), setting.size.width(), CV_8UC3, cv::Scalar::all(90));
            return frame;
        },
        gate_);
    Watcher seen_{*source_};
};

TEST_F(SimulatedCameraTest, OffersModesAndDrawsInTheChosenOne) {
    source_->start({.size = {1920, 1080}});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    EXPECT_EQ(seen_.newest->image.size(), cv::Size(1920, 1080));
    EXPECT_THAT(source_->report().formats, Contains(VideoFormat{{640, 480}, 30.0, QStringLiteral("BGR")}));
}

TEST_F(SimulatedCameraTest, ExposureGainAndFocusReachThePicture) {
    source_->setControls({{CameraControl::kExposure, false, 40.0}, {CameraControl::kGain, false, 2.0}, {CameraControl::kFocus, false, 50.0}});
    source_->start({});
    EXPECT_TRUE(shows([](const SimulatedExposure& setting) {
        return setting.exposure_ms == 40.0 && setting.gain == 2.0 && setting.out_of_focus == 12.0;
    }));
    source_->setControls({{CameraControl::kExposure, true, 0.0}, {CameraControl::kFocus, true, 0.0}});
    EXPECT_TRUE(shows([](const SimulatedExposure& setting) { return setting.exposure_ms == 10.0 && setting.out_of_focus == 0.0; }));
}

TEST_F(SimulatedCameraTest, PausedItShowsTheLastPicture) {
    source_->start({});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    source_->pause();
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kPaused; }));
    EXPECT_EQ(source_->newestFrame(), seen_.newest) << "the last picture stays";
}

}  // namespace
}  // namespace pmts::video
