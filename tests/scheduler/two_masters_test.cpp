#include "support/two_masters.hpp"

#include <gtest/gtest.h>

namespace pmts::test {
namespace {

constexpr std::uint64_t kTransactions = 10'000;

void expectNothingMixedUp(const TwoMastersCounts& counts) {
    EXPECT_EQ(counts.interleaved, 0U);
    EXPECT_EQ(counts.mangled, 0U);
    EXPECT_EQ(counts.lost, 0U);
    EXPECT_EQ(counts.misdirected, 0U);
}

class TwoMastersTest : public testing::TestWithParam<unsigned> {};

TEST_P(TwoMastersTest, NoTransactionIsInterleavedAndNoReplyLostOrMisdirected) {
    TwoMasters masters(GetParam(), {});
    ASSERT_TRUE(masters.run(kTransactions));

    expectNothingMixedUp(masters.counts());
    EXPECT_GT(masters.counts().computer, kTransactions / 4);
    EXPECT_GT(masters.counts().panel, kTransactions / 4);
    EXPECT_LT(masters.counts().longest_wait, std::chrono::seconds(1));  // a turn or two of the other side
}

TEST_P(TwoMastersTest, ASilentInstrumentDelaysButMixesNothingUp) {
    TwoMasters masters(GetParam(), {.silent = 0.02});
    ASSERT_TRUE(masters.run(kTransactions));

    expectNothingMixedUp(masters.counts());
    EXPECT_GT(masters.counts().silent, kTransactions / 100);
}

TEST_P(TwoMastersTest, APanelThatIsUnpluggedAtAnyMomentMixesNothingUp) {
    TwoMasters masters(GetParam(), {.unplugged = 0.05});
    ASSERT_TRUE(masters.run(kTransactions));

    expectNothingMixedUp(masters.counts());
}

TEST_P(TwoMastersTest, WhatNobodyAskedForMixesNothingUp) {
    TwoMasters masters(GetParam(), {.silent = 0.005, .unplugged = 0.01, .unsolicited = 0.1});
    ASSERT_TRUE(masters.run(kTransactions));

    expectNothingMixedUp(masters.counts());
    EXPECT_GT(masters.control().unsolicited, kTransactions / 50);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TwoMastersTest, testing::Values(1U, 20U, 300U));

}  // namespace
}  // namespace pmts::test
