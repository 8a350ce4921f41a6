#include "pmts/core/video_gate.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "support/matchers.hpp"

namespace pmts::core {
namespace {

using namespace std::chrono_literals;

TEST(VideoGateTest, IsClosedWhileAnyPauseIsHeldAndCountsThem) {
    VirtualClock clock;
    VideoGate gate;
    {
        const VideoGate::Pause first(gate, clock);
        clock.advance(200ms);
        {
            const VideoGate::Pause second(gate, clock);
            clock.advance(100ms);
        }
        EXPECT_FALSE(gate.isOpen());
    }
    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(gate.statistics().pauses, 2U);
    EXPECT_EQ(gate.statistics().longest, 300ms);
    EXPECT_EQ(gate.statistics().total, 400ms);
}

TEST(VideoGateTest, OpensAgainWhenTheHolderThrows) {
    VirtualClock clock;
    VideoGate gate;
    try {
        const VideoGate::Pause pause(gate, clock);
        throw std::runtime_error("link lost");
    } catch (const std::runtime_error&) {
    }
    EXPECT_TRUE(gate.isOpen());
}

}  // namespace
}  // namespace pmts::core
