#include "worker_source.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "support.hpp"

#include <gmock/gmock.h>

#include <semaphore>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

constexpr WorkerTimes kQuick{.silent_after = 200ms, .reopen_every = 20ms, .abandon_after = 400ms};

/// A camera that takes a picture when the test presses its shutter, and whose next() the test can hold, as a driver
/// does that never comes back.
struct StuckDriver {
    std::counting_semaphore<> shutter{0};
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
    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        if (driver_->stuck.exchange(false)) {
            driver_->release.acquire();
        }
        if (!driver_->shutter.try_acquire_for(limit)) {
            return std::nullopt;
        }
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
    /// Takes pictures until it is so.
    bool untilWithPictures(const std::function<bool()>& so) {
        return until([&] {
            driver_->shutter.release();
            return so();
        });
    }
    bool runs() {
        return untilWithPictures([&] { return source_->state() == SourceState::kRunning; });
    }

    std::shared_ptr<StuckDriver> driver_ = std::make_shared<StuckDriver>();
    core::VideoGate gate_;
    std::unique_ptr<WorkerSource> source_ = std::make_unique<WorkerSource>(
        SourceAddress{SourceKind::kV4l2, QStringLiteral("/dev/video0"), QStringLiteral("Webcam")},
        [driver = driver_] { return std::make_unique<StuckDevice>(driver); }, gate_, kQuick);
};

TEST_F(WorkerSourceTest, WorkerStuckInADriverIsReplaced) {
    source_->start({});
    ASSERT_TRUE(runs());
    driver_->stuck = true;
    ASSERT_TRUE(untilWithPictures([&] { return !driver_->stuck; }));
    ASSERT_TRUE(until([&] { return source_->state() == SourceState::kSilent; }));
    EXPECT_TRUE(runs());
    EXPECT_GE(driver_->opened, 2) << "on a busy machine the new worker may seem silent, too";
    driver_->release.release();
}

TEST_F(WorkerSourceTest, DestructorDoesNotWaitForAWorkerStuckInADriver) {
    source_->start({});
    ASSERT_TRUE(runs());
    driver_->stuck = true;
    ASSERT_TRUE(untilWithPictures([&] { return !driver_->stuck; }));

    const core::Duration before = now();
    source_.reset();

    EXPECT_LT(now() - before, 2s);
    driver_->release.release();  // it comes back late and finds nobody
    EXPECT_TRUE(until([&] { return driver_->alive == 0; }));
}

TEST_F(WorkerSourceTest, ClosedGateDoesNotMakeTheSourceSilent) {
    source_->start({});
    ASSERT_TRUE(runs());
    const core::VirtualClock clock;
    const core::VideoGate::Pause pause(gate_, clock);
    const core::Duration closed_at = now();
    ASSERT_TRUE(untilWithPictures([&] { return now() - closed_at > 2 * kQuick.silent_after; }));
    EXPECT_GT(gate_.statistics().frames_dropped, 0U);
    EXPECT_EQ(source_->state(), SourceState::kRunning);
}

}  // namespace
}  // namespace pmts::video
