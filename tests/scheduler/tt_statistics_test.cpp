#include "pmts/scheduler/tt_statistics.hpp"

#include <gtest/gtest.h>

namespace pmts::scheduler {
namespace {

using namespace std::chrono_literals;

TEST(TtStatistics, KeepsTheInitialLimitUntilEnoughIsKnown) {
    TtStatistics statistics;
    for (int i = 0; i < 7; ++i) {
        statistics.add("STD", 5s);
    }
    EXPECT_EQ(statistics.limit("STD", 9s, 30s), 9s);
    statistics.add("STD", 5s);

    EXPECT_EQ(statistics.limit("STD", 9s, 30s), 5s);
}

TEST(TtStatistics, OneSlowShotDoesNotSetTheLimitForEver) {
    TtStatistics statistics;
    for (int i = 0; i < 99; ++i) {
        statistics.add("STD", 5s);
    }
    statistics.add("STD", 28s);

    EXPECT_EQ(statistics.limit("STD", 9s, 30s), 5s);
    EXPECT_EQ(statistics.quantile("STD", 1.0), 28s);
}

TEST(TtStatistics, TheLimitNeverPassesItsCap) {
    TtStatistics statistics;
    for (int i = 0; i < 20; ++i) {
        statistics.add("D-bar", 40s);
    }
    EXPECT_EQ(statistics.limit("D-bar", 9s, 30s), 30s);
}

TEST(TtStatistics, OldTimesLeaveTheWindow) {
    TtStatistics statistics({.quantile = 0.5, .window = 10, .least_sample = 1});
    for (int i = 0; i < 10; ++i) {
        statistics.add("STD", 7s);
    }
    for (int i = 0; i < 10; ++i) {
        statistics.add("STD", 2s);
    }
    EXPECT_EQ(statistics.count("STD"), 10U);
    EXPECT_EQ(statistics.limit("STD", 9s, 30s), 2s);
}

TEST(TtStatistics, KeysAreLearnedApart) {
    TtStatistics statistics({.quantile = 1.0, .window = 10, .least_sample = 1});
    statistics.add("STD", 5s);
    statistics.add("TRK", 400ms);

    EXPECT_EQ(statistics.quantile("TRK", 1.0), 400ms);
    EXPECT_FALSE(statistics.quantile("FSTD", 1.0).has_value());
}

}  // namespace
}  // namespace pmts::scheduler
