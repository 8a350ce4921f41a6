#include "pmts/instrument/line_symptom.hpp"

#include <gtest/gtest.h>

namespace pmts::instrument {
namespace {

const std::string kAsked = "RG,79\r";

TEST(LineSymptomTest, TheAnswerOfTheProtocolPageIsAnInstrumentWithItsEndMark) {
    const auto evidence = judgeLine(kAsked, "79=62\r\n>");
    EXPECT_EQ(evidence.symptom, LineSymptom::kAnswer);
    EXPECT_EQ(evidence.label_79, 62);
    EXPECT_EQ(evidence.end_mark, '>');
    EXPECT_FALSE(evidence.echoes);
}

TEST(LineSymptomTest, ARefusalIsAnAnswerTooAlsoWithItsDevice) {
    EXPECT_EQ(judgeLine(kAsked, "20\r\n>").symptom, LineSymptom::kAnswer);
    EXPECT_EQ(judgeLine(kAsked, "30.1\r\n>").symptom, LineSymptom::kAnswer);
    EXPECT_EQ(judgeLine(kAsked, ">30.1\r\n>").symptom, LineSymptom::kAnswer) << "a stray mark is tolerated";
}

TEST(LineSymptomTest, AnotherEndMarkAndNoneAreSeen) {
    const auto none = judgeLine(kAsked, "79=0\r\n");
    EXPECT_EQ(none.symptom, LineSymptom::kAnswer);
    EXPECT_EQ(none.label_79, 0);
    EXPECT_FALSE(none.end_mark.has_value());
    EXPECT_EQ(judgeLine(kAsked, "79=4\r\n\x04").end_mark, '\x04');
}

TEST(LineSymptomTest, NothingIsSilence) { EXPECT_EQ(judgeLine(kAsked, "").symptom, LineSymptom::kSilent); }

TEST(LineSymptomTest, WhatWasSentAndNoMoreIsALoop) {
    const auto evidence = judgeLine(kAsked, "RG,79\r");
    EXPECT_EQ(evidence.symptom, LineSymptom::kEcho);
    EXPECT_TRUE(evidence.echoes);
}

TEST(LineSymptomTest, AnAnswerBehindAnEchoIsAnAnswer) {
    const auto evidence = judgeLine(kAsked, "RG,79\r79=62\r\n>");
    EXPECT_EQ(evidence.symptom, LineSymptom::kAnswer);
    EXPECT_TRUE(evidence.echoes);
}

TEST(LineSymptomTest, AModemAndAnotherDeviceAreNamed) {
    EXPECT_EQ(judgeLine("AT\r", "AT\r\r\nOK\r\n").symptom, LineSymptom::kModem);
    EXPECT_EQ(judgeLine(kAsked, "\r\nERROR\r\n").symptom, LineSymptom::kModem);
    EXPECT_EQ(judgeLine(kAsked, "$GPGGA,123519,4807.038,N\r\n").symptom, LineSymptom::kOtherDevice);
}

TEST(LineSymptomTest, BytesThatAreNoTextAreGarbled) {
    EXPECT_EQ(judgeLine(kAsked, "\x80\xf8\x06\xe6\x9e").symptom, LineSymptom::kGarbled);
    EXPECT_EQ(judgeLine(kAsked, "f").symptom, LineSymptom::kGarbled) << "one byte by chance is no text";
}

TEST(LineSymptomTest, ABlockThatIsNotTheAnswerCameUnasked) {
    EXPECT_EQ(judgeLine(kAsked, "7=10.2345\r\n8=101.1005\r\n>").symptom, LineSymptom::kUnasked);
}

/// The published block (protocol page 5.2).
TEST(LineSymptomTest, TheAngleStreamOfTheBusIsNamed) {
    const std::string block("A,166=96.16838\rA,165=177.56115\x04");
    EXPECT_EQ(judgeLine(kAsked, block).symptom, LineSymptom::kBusStream);
    EXPECT_EQ(judgeLine(kAsked, "65=177.56115\x04" + block + "A,166=96.1").symptom, LineSymptom::kBusStream)
        << "heard from the middle of a block to the middle of another";
    EXPECT_EQ(judgeLine(kAsked, "30.8\r\x04" + block).symptom, LineSymptom::kBusStream) << "it refused the question";
    EXPECT_FALSE(judgeLine(kAsked, block).isInstrument()) << "not the external interface";
    EXPECT_TRUE(judgeLine(kAsked, block).isOurs());
    EXPECT_EQ(judgeLine(kAsked, "A,166=96.16838\rA,1").symptom, LineSymptom::kOtherDevice) << "no whole block";
}

/// 7E1 as an 8N1 port reads it: the parity bit on top. `7` has five ones, `9` four, `=` five...
TEST(LineSymptomTest, TextUnderAParityBitTellsTheFraming) {
    std::string even, odd;
    for (const char c : std::string("79=62\r\n>")) {
        const bool has_odd_ones = __builtin_popcount(static_cast<unsigned>(c)) % 2 == 1;
        even += static_cast<char>(has_odd_ones ? c | 0x80 : c);
        odd += static_cast<char>(has_odd_ones ? c : c | 0x80);
    }
    EXPECT_EQ(judgeLine(kAsked, even).seven_bits_with, transport::Parity::kEven);
    EXPECT_EQ(judgeLine(kAsked, odd).seven_bits_with, transport::Parity::kOdd);
    EXPECT_FALSE(judgeLine(kAsked, even).isInstrument()) << "the settings are not found yet";
}

}  // namespace
}  // namespace pmts::instrument
