#include "pmts/core/quantity_expression.hpp"

#include "support/matchers.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace pmts::core {
namespace {

using test::FailedWith;
using test::IsNearAngle;

TEST(QuantityExpressionTest, AddsAnglesOfDifferentUnits) {
    // 5' = 5/60 deg = 0.0925926 gon.
    EXPECT_THAT(*angleFromExpression(u"12.5 gon + 5'", AngleUnit::kGon),
                IsNearAngle(Angle::fromGon(12.5925926), Angle::fromCc(0.01)));
    EXPECT_THAT(*angleFromExpression(u"159°48'18\" - 12 30 15", AngleUnit::kDms),
                IsNearAngle(Angle::fromArcsec((159 * 3600 + 48 * 60 + 18) - (12 * 3600 + 30 * 60 + 15)),
                            Angle::fromCc(0.01)));
    EXPECT_THAT(*angleFromExpression(u"400 - 96,1684", AngleUnit::kGon),
                IsNearAngle(Angle::fromGon(303.8316), Angle::fromCc(0.001)));
}

TEST(QuantityExpressionTest, WorksOutLengths) {
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"2*(1.5+0.3)", LengthUnit::kMetre), 3.6);
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"2*(1.5+0.3)", LengthUnit::kFoot), 3.6 * 0.3048);
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"1.6 m - 120 mm", LengthUnit::kFoot), 1.48);
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"1 + 1 m", LengthUnit::kFoot), 1.3048);
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"3 m * (10 m / 5 m)", LengthUnit::kMetre), 6.0);
    EXPECT_DOUBLE_EQ(*lengthFromExpression(u"5.25 ft", LengthUnit::kMetre), 1.6002);
}

TEST(QuantityExpressionTest, GivesTheThesisExample) {
    // Thesis annexure I: 2*[9/(8-5)+6 OF (3*(7+4))]-10 = 392, OF being a multiplication.
    EXPECT_DOUBLE_EQ(*numberFromExpression(u"2*[9/(8-5)+6*(3*(7+4))]-10"), 392.0);
}

struct Sum {
    const char* text;
    double value;
};

class OrdinaryArithmeticTest : public testing::TestWithParam<Sum> {};

TEST_P(OrdinaryArithmeticTest, IsKept) {
    const auto value = numberFromExpression(QString::fromUtf8(GetParam().text));
    ASSERT_TRUE(value.has_value()) << value.error().sentence().toStdString();
    EXPECT_DOUBLE_EQ(*value, GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(MixedRuns, OrdinaryArithmeticTest,
                         testing::Values(Sum{"10-4+3", 9}, Sum{"10-(4+3)", 3}, Sum{"12/3*2", 8},
                                         Sum{"12/(3*2)", 2}, Sum{"2+3*4-6/2", 11}, Sum{"-3+5", 2},
                                         Sum{"2*-3", -6}, Sum{"2--3", 5}, Sum{"-(1+2)*3", -9},
                                         Sum{"8/4/2", 1}, Sum{"1e-3*2", 0.002}, Sum{"2e3-1", 1999},
                                         Sum{" ( 7 ) ", 7}, Sum{"2×3÷4", 1.5}, Sum{"5−2", 3}, Sum{"+4", 4}));

struct Slip {
    const char* text;
    int position;
};

class ExpressionSlipTest : public testing::TestWithParam<Slip> {};

TEST_P(ExpressionSlipTest, IsToldWithItsPosition) {
    const auto value = lengthFromExpression(QString::fromUtf8(GetParam().text), LengthUnit::kMetre);
    ASSERT_THAT(value, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(value.error().happened.contains(QStringLiteral("at character %1,").arg(GetParam().position)))
        << value.error().happened.toStdString();
}

INSTANTIATE_TEST_SUITE_P(EveryKind, ExpressionSlipTest,
                         testing::Values(Slip{"", 1}, Slip{"1+", 3}, Slip{"1 + * 3", 5},
                                         Slip{"2*(1.5+0.3", 11}, Slip{"1+2)", 4}, Slip{"(1+2]", 5},
                                         Slip{"1 + 2 gon", 5}, Slip{"2(3+4)", 2}, Slip{"(1)(2)", 4},
                                         Slip{"1/0", 2}, Slip{"1 m * 2 m", 5}, Slip{"2 / 4 m", 3},
                                         Slip{"6 m / 2 m", 1}, Slip{"1 m + 6 m / 2 m", 5}, Slip{"--3", 2},
                                         Slip{"()", 2}, Slip{"1 + abc", 5}, Slip{"1e308*10", 1}));

TEST(QuantityExpressionTest, BracketsWithoutEndAreRefusedNotFollowed) {
    EXPECT_THAT(numberFromExpression(QString(100000, u'(')), FailedWith(ErrorKind::kBadInput));
}

/// A random expression and its value by the machine's own arithmetic; brackets only where precedence needs
/// them.
struct Written {
    QString text;
    double value = 0.0;
    int rank = 3;  ///< 1 sum, 2 product, 3 number or bracket
};

Written bracketed(const Written& inner, bool needed) {
    return needed ? Written{u'(' + inner.text + u')', inner.value, 3} : inner;
}

Written randomExpression(std::mt19937& dice, int depth) {
    if (depth == 0 || dice() % 4 == 0) {
        const double value = static_cast<double>(1 + dice() % 999) / 8.0;
        return {QString::number(value, 'g', 17), value, 3};
    }
    const auto kind = dice() % 4;
    const int rank = kind < 2 ? 1 : 2;
    const auto left_plain = randomExpression(dice, depth - 1);
    const auto right_plain = randomExpression(dice, depth - 1);
    const auto left = bracketed(left_plain, left_plain.rank < rank);
    const auto right = bracketed(right_plain, right_plain.rank <= rank);
    const double value = kind == 0   ? left.value + right.value
                         : kind == 1 ? left.value - right.value
                         : kind == 2 ? left.value * right.value
                         : right.value == 0.0
                             ? std::numeric_limits<double>::quiet_NaN()  // refused, not infinite
                             : left.value / right.value;
    return {left.text + QChar(u"+-*/"[kind]) + right.text, value, rank};
}

TEST(QuantityExpressionTest, AgreesWithOrdinaryArithmeticOnRandomExpressions) {
    std::mt19937 dice(20150101);
    int compared = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto expected = randomExpression(dice, 5);
        if (!std::isfinite(expected.value)) {
            continue;
        }
        const auto value = numberFromExpression(expected.text);
        ASSERT_TRUE(value.has_value()) << expected.text.toStdString();
        ASSERT_EQ(*value, expected.value) << expected.text.toStdString();
        ++compared;
    }
    EXPECT_GT(compared, 4900);
}

}  // namespace
}  // namespace pmts::core
