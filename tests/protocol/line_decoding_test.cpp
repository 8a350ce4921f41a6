#include "pmts/protocol/line_decoding.hpp"

#include "character_decoder.hpp"

#include "protocol/sampled_line.hpp"

#include <QFile>
#include <gtest/gtest.h>

#include <algorithm>

namespace pmts::protocol {
namespace {

using test::samplesOf;
using test::Sampling;

constexpr std::string_view kBlock = "A,166=96.16838\rA,165=177.56115\x04";

QByteArray dataFile(const char* name) {
    QFile file(QStringLiteral(PMTS_TEST_DATA "/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

LineCapture sampled(std::string_view text, const Sampling& how, std::optional<double> rate = std::nullopt) {
    return captureFromSamples(samplesOf(text, how), rate);
}

std::string bytesOf(const std::vector<DecodedCharacter>& characters) {
    std::string bytes;
    for (const DecodedCharacter& character : characters) {
        bytes += static_cast<char>(character.value);
    }
    return bytes;
}

TEST(LineDecodingTest, CapturePrintedInTheThesisDecodesToTheKnownText) {
    const QByteArray file = dataFile("bus-capture.txt");
    const auto capture = captureFromRunText({file.data(), static_cast<std::size_t>(file.size())});
    ASSERT_TRUE(capture);
    const auto activities = lineActivities(*capture);
    const auto busy = std::ranges::find(activities, LineUse::kData, &LineActivity::use);
    ASSERT_NE(busy, activities.end());
    EXPECT_EQ(busy->line, 4);
    EXPECT_EQ(portKind(activities), PortKind::kSerial);
    const auto framings = findFraming(*capture, busy->line);
    ASSERT_FALSE(framings.empty());
    EXPECT_EQ(framings[0].framing.text(), QStringLiteral("8N1"));
    EXPECT_EQ(textOf(decodeLine(*capture, framings[0].framing)), "A,166=96.16838<CR>A,165=177.56115<EOT>");
}

TEST(LineDecodingTest, TenBitGroupsOfTheThesisAreTheSameCharacters) {
    LineCapture capture;
    capture.lines = 1;
    for (const char c : dataFile("bus-bits.txt")) {
        if (c == '0' || c == '1') {
            capture.append(c == '1' ? 1 : 0, 1);
        }
    }
    EXPECT_EQ(bytesOf(decodeLine(capture, Framing{})), kBlock);
}

struct SampledLine : testing::TestWithParam<Sampling> {};

TEST_P(SampledLine, FramingIsFoundAndTheTextRead) {
    const std::string text = std::string(kBlock) + std::string(kBlock);
    const LineCapture capture = sampled(text, GetParam());
    const auto framings = findFraming(capture, 0);
    ASSERT_FALSE(framings.empty());
    const Framing& best = framings[0].framing;
    EXPECT_NEAR(best.samples_per_bit, GetParam().samples_per_bit, 0.03 * GetParam().samples_per_bit);
    EXPECT_EQ(best.idle_high, GetParam().idle_high);
    EXPECT_EQ(best.least_significant_first, GetParam().least_first);
    EXPECT_EQ(best.text(), QStringLiteral("%1%2%3").arg(GetParam().data_bits).arg(QLatin1Char(GetParam().parity)).arg(1));
    EXPECT_EQ(bytesOf(decodeLine(capture, best)), text);
}

INSTANTIATE_TEST_SUITE_P(Framings, SampledLine,
                         testing::Values(Sampling{}, Sampling{.samples_per_bit = 8.68}, Sampling{.samples_per_bit = 4.34}, Sampling{.samples_per_bit = 104.17},
                                         Sampling{.idle_high = false}, Sampling{.data_bits = 7, .parity = 'E'},
                                         Sampling{.data_bits = 7, .parity = 'O'}, Sampling{.data_bits = 8, .parity = 'E'},
                                         Sampling{.least_first = false}));

TEST(LineDecodingTest, TwoPerCentFlippedSamplesDoNoHarmWhereABitHasSixteen) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const LineCapture capture = sampled(kBlock, {.flipped = 0.02, .seed = seed});
        const auto framings = findFraming(capture, 0);
        ASSERT_FALSE(framings.empty()) << seed;
        EXPECT_EQ(bytesOf(decodeLine(capture, framings[0].framing)), kBlock) << seed;
    }
}

TEST(LineDecodingTest, WithOneSampleForEachBitWrongCharactersAreMarkedWhereTheFrameShowsIt) {
    int wrong = 0, marked = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const LineCapture capture = sampled(kBlock, {.samples_per_bit = 1.0, .flipped = 0.02, .seed = seed});
        const auto characters = decodeLine(capture, Framing{});
        wrong += bytesOf(characters) != kBlock ? 1 : 0;
        marked += std::ranges::any_of(characters, [](const auto& c) { return !c.isSure(); }) ? 1 : 0;
    }
    EXPECT_GT(wrong, 30);   // there is nothing to vote with
    EXPECT_GT(marked, 10);  // but a stop bit that is missing is seen
}

TEST(LineDecodingTest, BitWithManyWrongSamplesIsMarked) {
    std::string samples = samplesOf("5", {.samples_per_bit = 20.0});
    for (std::size_t i = 0; i < 6; ++i) {
        samples[40 * 20 + 3 * 20 + 4 + 2 * i] ^= 1;  // six of the fourteen that vote for the third bit
    }
    const auto characters = decodeLine(captureFromSamples(samples, {}), Framing{.samples_per_bit = 20.0});
    ASSERT_EQ(characters.size(), 1U);
    EXPECT_EQ(characters[0].value, '5');
    EXPECT_FALSE(characters[0].isSure());
    EXPECT_EQ(textOf(characters), "[?5]");
}

TEST(LineDecodingTest, KnownSampleRateNamesTheBaud) {
    const auto framings = findFraming(sampled(kBlock, {.samples_per_bit = 1e6 / 9600}, 1e6), 0);
    ASSERT_FALSE(framings.empty());
    EXPECT_NEAR(framings[0].baud, 9600.0, 100.0);
}

TEST(LineDecodingTest, EveryRunIsDividedByTheShortest) {
    const LineCapture capture = sampled(kBlock, {.samples_per_bit = 9.0});
    const auto bits = dereplicated(capture);
    ASSERT_TRUE(bits);
    EXPECT_EQ(bytesOf(decodeLine(*bits, Framing{})), kBlock);
}

TEST(LineDecodingTest, QuietAndRarelySwitchedLinesCarryNoData) {
    LineCapture capture;
    capture.lines = 3;
    for (int i = 0; i < 400; ++i) {
        capture.append(0b100U | (i / 100 % 2 != 0 ? 0b010U : 0U) | static_cast<std::uint32_t>(i % 2), 3);
    }
    const auto activities = lineActivities(capture);
    EXPECT_EQ(activities[0].use, LineUse::kData);
    EXPECT_EQ(activities[1].use, LineUse::kSwitching);
    EXPECT_EQ(activities[2].use, LineUse::kConstant);
    EXPECT_EQ(activities[2].high_share, 1.0);
}

TEST(LineDecodingTest, LongLineIsReadInPiecesWithoutASeam) {
    std::string text;
    for (int i = 0; i < 2000; ++i) {
        text += kBlock;
    }
    const LineCapture clean = sampled(text, {.samples_per_bit = 1.0});
    ASSERT_GT(clean.runs.size(), 200'000U);
    EXPECT_EQ(bytesOf(decodeLine(clean, Framing{})), text);
    const LineCapture flipped = sampled(text, {.samples_per_bit = 8.0, .flipped = 0.02});
    const Framing framing{.samples_per_bit = 8.0};
    const auto characters = decodeLine(flipped, framing);
    const auto in_one = CharacterDecoder(runsOf(flipped, 0), framing).all();
    ASSERT_EQ(characters.size(), in_one.size());
    EXPECT_TRUE(std::ranges::equal(characters, in_one, {}, &DecodedCharacter::sample, &DecodedCharacter::sample));
    EXPECT_EQ(textOf(characters), textOf(in_one));
}

TEST(LineDecodingTest, DecodingEndsEarlyWhenToldTo) {
    std::string text;
    for (int i = 0; i < 2000; ++i) {
        text += kBlock;
    }
    int asked = 0;
    const auto characters =
        decodeLine(sampled(text, {.samples_per_bit = 1.0}), Framing{}, [&asked](double) { return ++asked < 3; });
    EXPECT_GT(characters.size(), 0U);
    EXPECT_LT(characters.size(), text.size());
}

TEST(LineDecodingTest, RepeatCountIsTheSamplesOfOneBit) {
    EXPECT_EQ(repeatCount(sampled(kBlock, {.samples_per_bit = 9.0})), 9U);
    EXPECT_EQ(repeatCount(sampled(kBlock, {.samples_per_bit = 4.34})), 4U);
    EXPECT_FALSE(repeatCount(LineCapture()).has_value());
}

TEST(LineDecodingTest, LineThatRestsHasNoFraming) { EXPECT_TRUE(findFraming(sampled("", {}), 0).empty()); }

}  // namespace
}  // namespace pmts::protocol
