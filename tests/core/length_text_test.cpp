#include "pmts/core/length_text.hpp"

#include "support/matchers.hpp"

namespace pmts::core {
namespace {

using test::FailedWith;

TEST(LengthTextTest, ShowsMetresAndInternationalFeet) {
    EXPECT_EQ(lengthText(1.6, LengthUnit::kMetre, 3), QStringLiteral("1.600 m"));
    // 1 international mile = 5280 ft = 1609.344 m.
    EXPECT_EQ(lengthText(1609.344, LengthUnit::kFoot, 2), QStringLiteral("5280.00 ft"));
    EXPECT_EQ(lengthNumber(-0.3048, LengthUnit::kFoot, 1), QStringLiteral("-1.0"));
}

TEST(LengthTextTest, WhatRoundsToZeroHasNoSign) {
    EXPECT_EQ(lengthText(-0.0004, LengthUnit::kMetre, 3), QStringLiteral("0.000 m"));
    EXPECT_EQ(lengthText(-0.0, LengthUnit::kFoot, 0), QStringLiteral("0 ft"));
    EXPECT_EQ(lengthText(-0.0006, LengthUnit::kMetre, 3), QStringLiteral("-0.001 m"));
}

struct Typed {
    const char* text;
    LengthUnit unit;
    double length_m;
};

class TypedLengthTest : public testing::TestWithParam<Typed> {};

TEST_P(TypedLengthTest, IsUnderstood) {
    const auto length_m = lengthFromText(QString::fromUtf8(GetParam().text), GetParam().unit);
    ASSERT_TRUE(length_m.has_value());
    EXPECT_NEAR(*length_m, GetParam().length_m, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    EveryWay, TypedLengthTest,
    testing::Values(Typed{"1.6", LengthUnit::kMetre, 1.6}, Typed{"1,6", LengthUnit::kMetre, 1.6},
                    Typed{"1.6 m", LengthUnit::kFoot, 1.6}, Typed{" 5.25 ft ", LengthUnit::kMetre, 1.6002},
                    Typed{"5.25", LengthUnit::kFoot, 1.6002}, Typed{"120 mm", LengthUnit::kMetre, 0.12},
                    Typed{"12cm", LengthUnit::kMetre, 0.12}, Typed{"-.5", LengthUnit::kMetre, -0.5},
                    Typed{"0.3 KM", LengthUnit::kMetre, 300}, Typed{"10 in", LengthUnit::kMetre, 0.254},
                    Typed{"−2 m", LengthUnit::kMetre, -2}, Typed{"2.", LengthUnit::kMetre, 2}));

TEST(LengthTextTest, RefusesWhatIsNotALength) {
    for (const char* text :
         {"", "m", "1.6 gon", "1.2.3", "1 2", "--1", "1.6 m m", "5'3\"", "1e3", "nan", "inf"}) {
        EXPECT_THAT(lengthFromText(QString::fromUtf8(text), LengthUnit::kMetre),
                    FailedWith(ErrorKind::kBadInput))
            << text;
    }
}

TEST(LengthTextTest, WhatIsShownIsReadBackToTheLastDecimal) {
    for (const double length_m : {0.0, 1.6, -12.345, 1234.567, 41.2503}) {
        for (const auto unit : {LengthUnit::kMetre, LengthUnit::kFoot}) {
            const auto again = lengthFromText(lengthText(length_m, unit, 3), LengthUnit::kMetre);
            ASSERT_TRUE(again.has_value());
            EXPECT_NEAR(*again, length_m, 0.0005);
        }
    }
}

}  // namespace
}  // namespace pmts::core
