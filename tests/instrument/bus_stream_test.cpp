#include "bus_stream.hpp"

#include "support/matchers.hpp"

#include <gtest/gtest.h>

namespace pmts::instrument {
namespace {

using namespace std::chrono_literals;

std::string block(double va_gon, double ha_gon) {
    return "A,166=" + QString::number(va_gon, 'f', 5).toStdString() + "\rA,165=" + QString::number(ha_gon, 'f', 5).toStdString();
}

TEST(BusStream, ThePublishedBlockIsVaAndHaInGon) {
    const auto pointing = pointingOfStream("A,166=96.16838\rA,165=177.56115");
    ASSERT_TRUE(pointing.has_value());
    EXPECT_DOUBLE_EQ(pointing->va.gon(), 96.16838);
    EXPECT_DOUBLE_EQ(pointing->ha.gon(), 177.56115);
}

TEST(BusStream, ADamagedBlockIsNoReading) {
    for (const char* damaged : {"A,166=96.1683\rA,165=177.56115", "A,166=96.16838", "A,166=96.16838\rA,166=96.16838",
                                "A,166=96.16838\rA,165=177.5611#", "A,166=96.16838A,165=177.56115", "A,166=961.6838\rA,165=1.00000",
                                "A,166=\rA,165=177.56115", "A,167=96.16838\rA,165=177.56115", "A,166=-6.16838\rA,165=177.56115",
                                "A,166=.16838\rA,165=nan", "A,.1234=", ""}) {
        EXPECT_FALSE(pointingOfStream(damaged).has_value()) << damaged;
    }
}

TEST(BusStream, TheSecondReadingThatAgreesIsBelieved) {
    BusStream stream;
    EXPECT_FALSE(stream.take(block(96.16838, 177.56115), 0s).has_value());
    EXPECT_TRUE(stream.take(block(96.16839, 177.56113), 300ms).has_value());
}

TEST(BusStream, AChangedDigitIsNotBelieved) {
    BusStream stream;
    (void)stream.take(block(96.16838, 177.56115), 0s);
    (void)stream.take(block(96.16838, 177.56115), 300ms);
    EXPECT_FALSE(stream.take(block(96.76838, 177.56115), 600ms).has_value());
    EXPECT_FALSE(stream.take(block(9.16838, 177.56115), 900ms).has_value());
    EXPECT_TRUE(stream.take(block(96.16838, 177.56115), 1200ms).has_value());
}

TEST(BusStream, ATurningInstrumentIsFollowedFromItsSecondReading) {
    BusStream stream;
    (void)stream.take(block(100.0, 399.0), 0s);
    (void)stream.take(block(100.0, 399.0), 300ms);
    int believed = 0;
    for (int i = 1; i <= 10; ++i) {
        believed += stream.take(block(100.0, std::fmod(399.0 + i * 1.5, 400.0)), 300ms * (i + 1)) ? 1 : 0;
    }
    EXPECT_EQ(believed, 9);
}

}  // namespace
}  // namespace pmts::instrument
