#include "driver_bench.hpp"

#include <random>

namespace pmts::end_to_end {
namespace {

struct Tally {
    int right = 0, failed = 0, wrong = 0;
    int turned = 0;
};

/// Turn, measure, compare with the truth, again and again, for `span` of the instrument's time.
Tally workOn(DriverBench& bench, core::Duration span) {
    Tally tally;
    std::mt19937 random(7);
    std::uniform_real_distribution ha_gon(-40.0, 130.0), va_gon(85.0, 115.0);
    const auto end = bench.clock.now() + span;
    while (bench.clock.now() < end) {
        if (!bench.turn(ha_gon(random), va_gon(random))) {
            ++tally.failed;
            continue;
        }
        ++tally.turned;
        const auto shot = bench.measure();
        if (!shot) {
            ++tally.failed;
        } else if (const auto right = bench.isRight(*shot)) {
            ++tally.right;
        } else {
            ++tally.wrong;
            ADD_FAILURE() << right.message();
        }
    }
    return tally;
}

transport::MemoryPairSettings lossy(double share, unsigned seed) {
    return {.baud = std::nullopt,
            .first_to_second = {.seed = seed, .lost = share, .garbled = 0.0},
            .second_to_first = {.seed = seed + 1000, .lost = share}};
}

class LossyLineTest : public testing::TestWithParam<unsigned> {};

TEST_P(LossyLineTest, AnHourWithFivePercentOfAllBytesLostGivesNoWrongPoint) {
    DriverBench bench(with(&StationSettings::seed, GetParam()), lossy(0.05, GetParam()));
    for (int i = 0; i < 20 && !bench.run(bench.driver.connectTo({})); ++i) {
    }
    const auto tally = workOn(bench, 1h);

    std::printf("seed %u: %d right, %d failed, %d wrong\n", GetParam(), tally.right, tally.failed,
                tally.wrong);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GE(tally.right, 30);
    EXPECT_FALSE(bench.driver.isBusy());
}

INSTANTIATE_TEST_SUITE_P(Seeds, LossyLineTest, testing::Values(1U, 2U));

TEST(LossyLine, GarbledAndDoubledBytesGiveNoWrongPoint) {
    transport::MemoryPairSettings line;
    line.first_to_second = {.seed = 3, .garbled = 0.01, .doubled = 0.01};
    line.second_to_first = {.seed = 4, .garbled = 0.01, .doubled = 0.01};
    DriverBench bench({}, line);
    for (int i = 0; i < 20 && !bench.run(bench.driver.connectTo({})); ++i) {
    }
    const auto tally = workOn(bench, 20min);

    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GE(tally.right, 20);
}

TEST(LossyLine, ASlowLineMakesNoDifference) {
    transport::MemoryPairSettings line;
    line.second_to_first = {.seed = 5, .late = 0.1, .late_by = 700ms};
    DriverBench bench({}, line);
    bench.connect();
    const auto tally = workOn(bench, 10min);

    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.failed, 0);
}

}  // namespace
}  // namespace pmts::end_to_end
