#include "pmts/core/virtual_clock.hpp"
#include "support.hpp"

#include <gmock/gmock.h>

#include <atomic>

namespace pmts::video {
namespace {

using testing::ElementsAre;

camera::Frame plainFrame() {
    camera::Frame frame;
    frame.image = cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(90));
    return frame;
}

class SimulatedSourceTest : public testing::Test {
protected:
    core::VideoGate gate_;
    std::atomic<int> painted_{0};
    std::unique_ptr<VideoSource> source_ = makeSimulatedSource(
        [this](core::Duration) {
            ++painted_;
            return plainFrame();
        },
        gate_);
    Watcher seen_{*source_};
};

TEST_F(SimulatedSourceTest, DeliversFramesWithTheirTimeAndNumber) {
    source_->start({});

    ASSERT_TRUE(until([&] { return seen_.newest && seen_.newest->sequence >= 3; }));

    EXPECT_EQ(source_->state(), SourceState::kRunning);
    EXPECT_THAT(seen_.states, ElementsAre(SourceState::kStarting, SourceState::kRunning));
    EXPECT_LT(now() - seen_.newest->captured_at, std::chrono::seconds(5));
    EXPECT_EQ(source_->address().kind, SourceKind::kSimulated);
}

TEST_F(SimulatedSourceTest, FramesAreAThirtiethOfASecondApart) {
    source_->start({.rate_hz = 30.0});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    const camera::FramePtr first = seen_.newest;
    ASSERT_TRUE(until([&] { return seen_.newest->sequence >= first->sequence + 5; }));
    const double apart_s =
        std::chrono::duration<double>(seen_.newest->captured_at - first->captured_at).count();
    EXPECT_NEAR(apart_s, static_cast<double>(seen_.newest->sequence - first->sequence) / 30.0, 1e-6);
}

TEST_F(SimulatedSourceTest, ClosedGateDropsFramesUnpaintedAndCountsThem) {
    source_->start({.rate_hz = 120.0});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    const core::VirtualClock clock;
    {
        const core::VideoGate::Pause pause(gate_, clock);
        ASSERT_TRUE(until([&] { return gate_.statistics().frames_dropped >= 1; }));
        const int painted = painted_;  // a frame admitted before the gate closed is done by now
        ASSERT_TRUE(until([&] { return gate_.statistics().frames_dropped >= 10; }));
        EXPECT_EQ(painted_, painted);
    }
    const std::uint64_t before = seen_.newest->sequence;
    ASSERT_TRUE(until([&] { return seen_.newest->sequence > before + 3; }));
    EXPECT_EQ(source_->state(), SourceState::kRunning);
}

TEST_F(SimulatedSourceTest, ReceiverThatLagsFindsTheNewestAndNoBacklog) {
    seen_.takes_frames = false;
    source_->start({.rate_hz = 120.0});
    ASSERT_TRUE(until([&] { return source_->statistics().delivered >= 20; }));

    EXPECT_EQ(seen_.notices, 1);  // told once, until it takes the frame
    EXPECT_GE(source_->newestFrame()->sequence, 19U);
    EXPECT_GE(source_->statistics().overtaken, 19U);
    seen_.takes_frames = true;
    ASSERT_TRUE(until([&] { return seen_.notices > 5; }));
}

TEST_F(SimulatedSourceTest, StopReturnsAtOnceAndNothingFollows) {
    source_->start({.rate_hz = 120.0});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    source_->stop();
    EXPECT_EQ(source_->state(), SourceState::kStopped);
    EXPECT_EQ(source_->newestFrame(), nullptr);
    const int notices = seen_.notices;
    source_->start({});
    source_->stop();
    QCoreApplication::processEvents();
    EXPECT_EQ(seen_.notices, notices);
}

TEST_F(SimulatedSourceTest, StartsAgainAfterStop) {
    source_->start({});
    source_->stop();
    source_->start({});
    EXPECT_TRUE(until([&] { return seen_.newest != nullptr; }));
}

TEST_F(SimulatedSourceTest, ChangesItsRateWhileRunning) {
    source_->start({.rate_hz = 10.0});
    ASSERT_TRUE(until([&] { return seen_.newest != nullptr; }));
    source_->start({.rate_hz = 60.0});
    ASSERT_TRUE(until([&] { return source_->statistics().measured_rate_hz > 30.0; }));
}

TEST(SimulatedSourceFaultTest, PainterThatThrowsIsATroubleAndNoCrash) {
    core::VideoGate gate;
    const auto source = makeSimulatedSource(
        [](core::Duration) -> camera::Frame { throw std::runtime_error("texture lost"); }, gate);
    const Watcher seen(*source);
    source->start({});
    ASSERT_TRUE(until([&] { return seen.hasProblemWith("could not be read"); }));
    EXPECT_EQ(source->state(), SourceState::kLost);
}

TEST(MakeVideoSourceTest, SimulatedAddressNeedsAPainter) {
    core::VideoGate gate;
    EXPECT_THROW((void)makeVideoSource({SourceKind::kSimulated, {}, {}}, gate), std::logic_error);
}

}  // namespace
}  // namespace pmts::video
