#include "pmts/app/line/signal_index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pmts::app {
namespace {

protocol::LineCapture noise(std::size_t runs) {
    protocol::LineCapture capture;
    capture.lines = 3;
    std::mt19937 random(5);
    for (std::size_t i = 0; i < runs; ++i) {
        capture.append(random() % 8, 1 + random() % 5);
    }
    return capture;
}

/// Sample by sample.
SignalIndex::Levels walked(const protocol::LineCapture& capture, std::uint64_t from, std::uint64_t to) {
    SignalIndex::Levels sum;
    std::uint64_t at = 0;
    for (const auto& run : capture.runs) {
        for (std::uint32_t i = 0; i < run.samples; ++i, ++at) {
            if (at >= from && at < to) {
                sum.high |= run.levels;
                sum.low |= ~run.levels;
            }
        }
    }
    return sum;
}

TEST(SignalIndexTest, EverySpanIsWhatAWalkAlongTheSamplesSees) {
    const auto capture = noise(3000);
    const SignalIndex index(capture);
    EXPECT_EQ(index.samples(), capture.samples());
    std::mt19937 random(6);
    for (int i = 0; i < 200; ++i) {
        const std::uint64_t from = random() % index.samples();
        const std::uint64_t to = from + 1 + random() % (i % 2 == 0 ? 6U : 9000U);
        const auto seen = index.between(from, to);
        const auto truth = walked(capture, from, to);
        EXPECT_EQ(seen.high & 7U, truth.high & 7U) << from << ' ' << to;
        EXPECT_EQ(seen.low & 7U, truth.low & 7U) << from << ' ' << to;
    }
}

TEST(SignalIndexTest, NothingIsBehindTheEnd) {
    const auto capture = noise(10);
    const SignalIndex index(capture);
    EXPECT_EQ(index.between(index.samples(), index.samples() + 9).high, 0U);
    EXPECT_EQ(SignalIndex(protocol::LineCapture()).samples(), 0U);
    EXPECT_EQ(SignalIndex(protocol::LineCapture()).between(0, 5).low, 0U);
}

}  // namespace
}  // namespace pmts::app
