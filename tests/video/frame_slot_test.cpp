#include "frame_slot.hpp"

#include <gtest/gtest.h>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

camera::FramePtr frameNumber(std::uint64_t sequence) {
    camera::Frame frame;
    frame.sequence = sequence;
    return std::make_shared<const camera::Frame>(frame);
}

class FrameSlotTest : public testing::Test {
protected:
    bool put(std::uint64_t sequence, core::Duration at = 0ms) {
        return slot_.put(frameNumber(sequence), at, run_);
    }

    FrameSlot slot_;
    unsigned run_ = slot_.renew();
};

TEST_F(FrameSlotTest, NewestFrameReplacesTheOneNobodyTook) {
    (void)put(1);
    (void)put(2);
    EXPECT_EQ(slot_.take()->sequence, 2U);
    EXPECT_EQ(slot_.statistics(0ms).overtaken, 1U);
}

TEST_F(FrameSlotTest, TellsOnceUntilTheFrameWasTaken) {
    EXPECT_TRUE(put(1));
    EXPECT_FALSE(put(2));
    EXPECT_TRUE(slot_.noticeArrived());
    EXPECT_FALSE(put(3));
    (void)slot_.take();
    EXPECT_TRUE(put(4));
}

TEST_F(FrameSlotTest, NeverHasTwoNoticesUnderWayHoweverOftenOthersLook) {
    EXPECT_TRUE(put(1));
    (void)slot_.take();  // somebody else looks before the notice arrives
    EXPECT_FALSE(put(2));
    EXPECT_TRUE(slot_.noticeArrived());
    (void)slot_.take();
    EXPECT_TRUE(put(3));
}

TEST_F(FrameSlotTest, RefusesFramesOfAnEarlierRun) {
    const unsigned old = run_;
    run_ = slot_.renew();
    EXPECT_FALSE(slot_.put(frameNumber(1), 0ms, old));
    EXPECT_EQ(slot_.take(), nullptr);
}

TEST_F(FrameSlotTest, NoticeOfAnEarlierRunServesTheFirstFrameOfTheNext) {
    EXPECT_TRUE(put(1));
    run_ = slot_.renew();  // stopped and started again before the notice arrived
    EXPECT_FALSE(put(2));
    EXPECT_TRUE(slot_.noticeArrived());
    EXPECT_EQ(slot_.take()->sequence, 2U);
    EXPECT_TRUE(put(3));
}

TEST_F(FrameSlotTest, NoticeThatArrivesAfterStopFindsNothing) {
    EXPECT_TRUE(put(1));
    run_ = slot_.renew();
    EXPECT_FALSE(slot_.noticeArrived());
}

TEST_F(FrameSlotTest, MeasuresTheRateOfTheLastTwoSeconds) {
    for (int i = 0; i <= 90; ++i) {
        (void)put(static_cast<std::uint64_t>(i), i * 40ms);
    }
    EXPECT_NEAR(slot_.statistics(3600ms).measured_rate_hz, 25.0, 0.01);
    EXPECT_EQ(slot_.statistics(10s).measured_rate_hz, 0.0);  // it has stopped since
}

}  // namespace
}  // namespace pmts::video
