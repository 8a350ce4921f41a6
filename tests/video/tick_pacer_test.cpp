#include "tick_pacer.hpp"

#include "capture_device.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

TEST(TickPacerTest, TicksAreDueAtMultiplesOfThePeriodHoweverLateTheyAreRead) {
    TickPacer pacer;
    pacer.start(100.0);
    std::vector<Tick> ticks;
    while (ticks.size() < 5) {
        if (const auto tick = pacer.wait(1s)) {
            ticks.push_back(*tick);
        }
    }
    for (const Tick& tick : ticks) {
        EXPECT_EQ(tick.due - ticks[0].due, 10ms * static_cast<int>(tick.number - ticks[0].number));
    }
}

TEST(TickPacerTest, GivesBackTheTurnWhenNothingIsDueInTime) {
    TickPacer pacer;
    pacer.start(0.1);
    ASSERT_TRUE(pacer.wait(1s).has_value());  // the first is due at once
    EXPECT_FALSE(pacer.wait(1ms).has_value());
}

TEST(TickPacerTest, InterruptEndsTheWait) {
    TickPacer pacer;
    pacer.start(0.1);
    (void)pacer.wait(1s);
    std::thread other([&] { pacer.interrupt(); });
    const core::Duration before = now();
    EXPECT_FALSE(pacer.wait(10s).has_value());
    EXPECT_LT(now() - before, 5s);
    other.join();
}

TEST(TickPacerTest, SkipsWhatIsMoreThanFourTicksLate) {
    TickPacer pacer;
    pacer.start(240.0);
    const core::Duration start = now();
    while (now() - start < 60ms) {
        std::this_thread::yield();
    }
    const auto tick = pacer.wait(1s);
    ASSERT_TRUE(tick.has_value());
    EXPECT_GE(tick->number, 10U);
}

}  // namespace
}  // namespace pmts::video
