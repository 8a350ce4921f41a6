#include "pmts/simulator/line_framing.hpp"

#include <gtest/gtest.h>

namespace pmts::simulator {
namespace {

LineFraming framing(const char* text) { return *LineFraming::fromText(QString::fromLatin1(text)); }

TEST(LineFramingTest, TextsAreReadAndWritten) {
    const auto line = framing("4800-7e1");
    EXPECT_EQ(line.baud, 4800);
    EXPECT_EQ(line.data_bits, 7);
    EXPECT_EQ(line.parity, WireParity::kEven);
    EXPECT_EQ(line.text(), QStringLiteral("4800-7E1"));
    for (const char* const wrong : {"4800", "4800-9N1", "4800-8N3", "x-8N1", "999999-8N1", "0-8N1", "00-8N1", "000000-7E1", "49-8N1"}) {
        EXPECT_FALSE(LineFraming::fromText(QString::fromLatin1(wrong)).has_value()) << wrong;
    }
    EXPECT_TRUE(LineFraming::fromText(QStringLiteral("50-8N1")).has_value());
}

TEST(LineFramingTest, TheSameSettingOnBothEndsLosesNothing) {
    for (const char* const text : {"9600-8N1", "300-7E1", "19200-8O2"}) {
        EXPECT_EQ(heardAs("RG,79\r", framing(text), framing(text)), "RG,79\r");
    }
}

/// 0x55 sent at half the speed: every bit lasts two of the receiver's. The wave is 00 11 00 11 00 11 00 11 00 11.
TEST(LineFramingTest, HalfTheSpeedDoublesEveryBit) {
    // Frame one: start 0, data 0,1,1,0,0,1,1,0 (least first) = 0x66, stop would be 0: dropped. The rest of the wave holds
    // 0 1 1 0 0 1 1 1 1 1... from the next edge: start 0, data 0,1,1,0,0,1,1,1 = 0xE6, stop 1.
    EXPECT_EQ(heardAs("\x55", framing("4800-8N1"), framing("9600-8N1")), "\xE6");
}

TEST(LineFramingTest, SevenBitsWithEvenParityReadAsEightAreTextUnderATopBit) {
    // '7' = 0x37 has five ones: the parity bit is set.
    EXPECT_EQ(heardAs("7", framing("9600-7E1"), framing("9600-8N1")), "\xB7");
    EXPECT_EQ(heardAs("9", framing("9600-7E1"), framing("9600-8N1")), "9");
}

TEST(LineFramingTest, AWrongParityIsDropped) {
    EXPECT_EQ(heardAs("7", framing("9600-8E1"), framing("9600-8O1")), "");
    EXPECT_EQ(heardAs("RG", framing("9600-7E1"), framing("9600-7O1")), "");
}

TEST(LineFramingTest, TwoStopBitsAreHeardByAReceiverThatWantsOne) {
    EXPECT_EQ(heardAs("RG,79\r", framing("9600-8N2"), framing("9600-8N1")), "RG,79\r");
}

TEST(LineFramingTest, ADifferentSpeedNeverReadsTheQuestionRight) {
    for (const int sent : {300, 1200, 2400, 4800, 9600, 19200}) {
        for (const int heard : {300, 1200, 2400, 4800, 9600, 19200}) {
            const bool right = heardAs("RG,79\r", {.baud = sent}, {.baud = heard}) == "RG,79\r";
            EXPECT_EQ(right, sent == heard) << sent << " heard at " << heard;
        }
    }
}

}  // namespace
}  // namespace pmts::simulator
