#include "worker_source.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "support.hpp"

#include <gmock/gmock.h>

#include <semaphore>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

constexpr WorkerTimes kQuick{.silent_after = 200ms, .reopen_every = 20ms, .abandon_after = 400ms};

/// A device whose next() the test can hold, as a driver does that never comes back.
struct StuckDriver {
    std::atomic<bool> stuck{false};
    std::atomic<int> opened{0};
    std::atomic<int> alive{0};
    std::binary_semaphore release{0};
};

class StuckDevice final : public CaptureDevice {
public:
    explicit StuckDevice(std::shared_ptr<StuckDriver> driver) : driver_(std::move(driver)) {
        ++driver_->alive;
    }
    ~StuckDevice() override { --driver_->alive; }

    core::Result<void> open(const VideoFormat&) override {
        ++driver_->opened;
        return {};
    }
    core::Result<std::optional<Shot>> next(core::Duration) override {
        if (driver_->stuck.exchange(false)) {
            driver_->release.acquire();
        }
        std::this_thread::sleep_for(5ms);  // the pace of the camera
        return Shot{sequence_++, now()};
    }
    camera::Frame picture() override {
        camera::Frame frame;
        frame.image = cv::Mat(4, 4, CV_8UC3, cv::Scalar::all(1));
        return frame;
    }
    void close() override {}

private:
    std::shared_ptr<StuckDriver> driver_;
    std::uint64_t sequence_ = 0;
};

class WorkerSourceTest : public testing::Test {
protected:
    std::shared_ptr<StuckDriver> driver_ = std::make_shared<StuckDriver>();
    core::VideoGate gate_;
    std::unique_ptr<WorkerSource> source_ = std::make_unique<WorkerSource>(
        SourceAddress{SourceKind::kV4l2, QStringLiteral("/dev/video0"), QStringLiteral("Webcam")},
        [driver = driver_] { return std::make_unique<StuckDevice>(driver); }, gate_, kQuick);
};

TEST_F(WorkerSourceTest, WorkerStuckInADriverIsReplaced) {
    source_->start({});
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kRunning; }));
    driver_->stuck = true;
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kSilent; }));
    EXPECT_TRUE(until([&] { return source_->state() == SourceState::kRunning; }));
    EXPECT_EQ(driver_->opened, 2);
    driver_->release.release();
}

TEST_F(WorkerSourceTest, DestructorDoesNotWaitForAWorkerStuckInADriver) {
    source_->start({});
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kRunning; }));
    driver_->stuck = true;
    ASSERT_TRUE(until([&] { return !driver_->stuck; }));

    const core::Duration before = now();
    source_.reset();

    EXPECT_LT(now() - before, 2s);
    driver_->release.release();  // it comes back late and finds nobody
    EXPECT_TRUE(until([&] { return driver_->alive == 0; }));
}

TEST_F(WorkerSourceTest, ClosedGateDoesNotMakeTheSourceSilent) {
    source_->start({});
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kRunning; }));
    const core::VirtualClock clock;
    const core::VideoGate::Pause pause(gate_, clock);
    ASSERT_TRUE(
        until([&] { return gate_.statistics().frames_dropped >= 100; }));  // more than 500 ms of frames
    EXPECT_EQ(source_->state(), SourceState::kRunning);
}

}  // namespace
}  // namespace pmts::video
