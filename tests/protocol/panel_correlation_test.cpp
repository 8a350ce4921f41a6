#include "pmts/protocol/panel_correlation.hpp"

#include "pmts/protocol/line_talk.hpp"
#include "protocol/sampled_line.hpp"
#include "support/matchers.hpp"

#include <gtest/gtest.h>

namespace pmts::protocol {
namespace {

using pmts::test::FailedWith;

/// The block of the thesis; the panel showed 86.33.06 and 159.48.18 then.
std::vector<StreamValue> thesisValues() {
    const auto capture = captureFromSamples(test::samplesOf("A,166=96.16838\rA,165=177.56115\x04", {}), {});
    return streamValues(decodeLine(capture, Framing{.samples_per_bit = 16.0}));
}

TEST(PanelCorrelationTest, StreamTellsVariablesAndValues) {
    const auto values = thesisValues();
    ASSERT_EQ(values.size(), 2U);
    EXPECT_EQ(values[0].variable, 166);
    EXPECT_DOUBLE_EQ(values[1].value, 177.56115);
    EXPECT_EQ(values[0].unit, 'A');
    EXPECT_EQ(values[0].sample, 40U * 16U);
}

TEST(PanelCorrelationTest, VerticalAngleOfThePanelIsVariable166InGon) {
    const auto matches = correlated(QStringLiteral("86.33.06"), thesisValues());
    ASSERT_TRUE(matches && !matches->empty());
    EXPECT_EQ(matches->front().stream.variable, 166);
    EXPECT_EQ(matches->front().units, QStringLiteral("gon, shown as d.mm.ss"));
    EXPECT_EQ(matches->front().shown, QStringLiteral("86.33.06"));
    EXPECT_EQ(matches->front().score, 1.0);
}

TEST(PanelCorrelationTest, HorizontalAngleIsVariable165) {
    const auto matches = correlated(QStringLiteral("159.48.18"), thesisValues());
    ASSERT_TRUE(matches && !matches->empty());
    EXPECT_EQ(matches->front().stream.variable, 165);
}

TEST(PanelCorrelationTest, PanelInGonShowsTheNumberAsItStands) {
    const auto matches = correlated(QStringLiteral("96.1684"), thesisValues());
    ASSERT_TRUE(matches && !matches->empty());
    EXPECT_EQ(matches->front().units, QStringLiteral("as it stands"));
    EXPECT_NEAR(matches->front().off, -0.2, 1e-6);
}

TEST(PanelCorrelationTest, ReadingThatIsAStepOldFitsLess) {
    const auto matches = correlated(QStringLiteral("86.33.08"), thesisValues());
    ASSERT_TRUE(matches && !matches->empty());
    EXPECT_LT(matches->front().score, 0.5);
    EXPECT_GT(matches->front().score, 0.02);
}

TEST(PanelCorrelationTest, AnotherAngleFitsNothing) {
    const auto matches = correlated(QStringLiteral("12.00.00"), thesisValues());
    ASSERT_TRUE(matches);
    EXPECT_TRUE(matches->empty());
}

TEST(PanelCorrelationTest, TextThatIsNoNumberIsRefused) {
    EXPECT_THAT(correlated(QStringLiteral("86.75.06"), thesisValues()), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(correlated(QStringLiteral("HA?"), thesisValues()), FailedWith(core::ErrorKind::kBadInput));
}

/// from_chars and toDouble() both take these words; a first NaN would stay the nearest value for ever.
TEST(PanelCorrelationTest, NanAndInfAreNoNumbersOnEitherSide) {
    const auto values = streamValues(charactersOf("A,166=nan\rA,166=96.16838\rA,165=inf\rA,165=177.56115\rA,164=-nan\r"));
    ASSERT_EQ(values.size(), 2U);
    const auto matches = correlated(QStringLiteral("86.33.06"), values);
    ASSERT_TRUE(matches && !matches->empty());
    EXPECT_EQ(matches->front().stream.variable, 166);
    EXPECT_DOUBLE_EQ(matches->front().stream.value, 96.16838);
    for (const char* const typed : {"nan", "inf", "-inf"}) {
        EXPECT_THAT(correlated(QLatin1String(typed), values), FailedWith(core::ErrorKind::kBadInput)) << typed;
    }
}

TEST(PanelCorrelationTest, LabelOfAStationIsAVariableToo) {
    const auto values = streamValues(charactersOf("0\r\n7=10.2345\r\n8=101.1005\r\n>"));
    ASSERT_EQ(values.size(), 2U);
    EXPECT_EQ(values[1].unit, 'G');
    EXPECT_EQ(values[1].variable, 8);
    EXPECT_DOUBLE_EQ(values[1].value, 101.1005);
}

TEST(PanelCorrelationTest, RestOfALineBehindADoubtfulEndIsNoLabel) {
    auto characters = charactersOf("A,1\r5=177.56115\r7=10.2345\r");
    characters[3].framing_error = true;
    const auto values = streamValues(characters);
    ASSERT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0].variable, 7);
}

TEST(PanelCorrelationTest, DamagedValueIsLeftOut) {
    auto characters = decodeLine(captureFromSamples(test::samplesOf("A,166=96.16838\r", {}), {}),
                                 Framing{.samples_per_bit = 16.0});
    characters[8].margin = 0.1F;
    EXPECT_TRUE(streamValues(characters).empty());
}

}  // namespace
}  // namespace pmts::protocol
