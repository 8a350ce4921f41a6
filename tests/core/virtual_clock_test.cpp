#include "pmts/core/virtual_clock.hpp"

#include "pmts/core/task.hpp"
#include "support/matchers.hpp"

namespace pmts::core {
namespace {

using namespace std::chrono_literals;

TEST(VirtualClockTest, RunsTimersInOrderOfTheirTime) {
    VirtualClock clock;
    std::vector<int> order;
    const auto late = clock.callAfter(20ms, [&] { order.push_back(2); });
    const auto early = clock.callAfter(10ms, [&] { order.push_back(1); });
    clock.advance(15ms);
    EXPECT_THAT(order, testing::ElementsAre(1));
    clock.advance(15ms);
    EXPECT_THAT(order, testing::ElementsAre(1, 2));
    EXPECT_EQ(clock.now(), 30ms);
}

TEST(VirtualClockTest, CancelledTimerNeverRuns) {
    VirtualClock clock;
    bool ran = false;
    auto timer = clock.callAfter(10ms, [&] { ran = true; });
    timer.cancel();
    clock.advance(1s);
    EXPECT_FALSE(ran);
}

TEST(VirtualClockTest, TimerMaySetAnotherTimer) {
    VirtualClock clock;
    Duration second_ran{0};
    Timer inner;
    const auto outer = clock.callAfter(10ms, [&] { inner = clock.callAfter(5ms, [&] { second_ran = clock.now(); }); });
    clock.advance(1h);
    EXPECT_EQ(second_ran, 15ms);
}

TEST(VirtualClockTest, AChainOfPostedActionsTakesNoTime) {
    VirtualClock clock;
    int links = 0;
    std::function<void()> link = [&] {
        if (++links < 20) {
            post(link);
        }
    };
    Duration chain_ended{0};
    const auto first = clock.callAfter(10ms, [&] { post(link); });
    const auto next = clock.callAfter(11ms, [&] { chain_ended = Duration(links); });
    clock.advance(20ms);

    EXPECT_EQ(chain_ended, Duration(20));  // all links ran before the clock went on to 11 ms
}

TEST(VirtualClockTest, UtcMovesWithTheClock) {
    VirtualClock clock;
    const QDateTime before = clock.utcNow();
    clock.advance(72h);
    EXPECT_EQ(before.secsTo(clock.utcNow()), 72 * 3600);
}

}  // namespace
}  // namespace pmts::core
