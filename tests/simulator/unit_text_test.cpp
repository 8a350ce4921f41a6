#include "unit_text.hpp"

#include "support/matchers.hpp"

#include <clocale>

namespace pmts::simulator {
namespace {

using core::Angle;

// Protocol page 4.2: 177.56115 gon.
TEST(UnitTextTest, WritesAngleInEachUnitAsTheManualDoes) {
    const Angle angle = Angle::fromGon(177.56115);
    EXPECT_EQ(angleText(angle + Angle::fromCc(0.01), AngleText::kGon, 4), "177.5612");
    EXPECT_EQ(angleText(angle, AngleText::kDms, 4), "159.4818");
    EXPECT_EQ(angleText(angle, AngleText::kDegree, 4), "159.8050");
    EXPECT_EQ(angleText(angle, AngleText::kMil, 4), "2840.978");
}

TEST(UnitTextTest, SecondsCarryIntoTheMinute) {
    EXPECT_EQ(angleText(Angle::fromArcsec(59.6), AngleText::kDms, 4), "0.0100");
    EXPECT_EQ(angleText(Angle::fromDeg(10) - Angle::fromArcsec(0.4), AngleText::kDms, 4), "10.0000");
}

TEST(UnitTextTest, FullTurnIsWrittenZero) {
    EXPECT_EQ(angleText(Angle::fromGon(399.99996), AngleText::kGon, 4), "0.0000");
    EXPECT_EQ(angleText(Angle::fromArcsec(-0.2), AngleText::kDms, 4), "0.0000");
    EXPECT_EQ(angleText(Angle::fromGon(-1), AngleText::kGon, 4), "399.0000");
}

TEST(UnitTextTest, ReadsDmsAsDigitsNotDecimals) {
    EXPECT_NEAR(angleFrom("159.4818", AngleText::kDms)->arcsec(), 159 * 3600 + 48 * 60 + 18, 1e-9);
    EXPECT_NEAR(angleFrom("12.5", AngleText::kDms)->deg(), 12.0 + 50.0 / 60.0, 1e-12);
    EXPECT_NEAR(angleFrom("1.000059", AngleText::kDms)->arcsec(), 3600.59, 1e-9);
    EXPECT_FALSE(angleFrom("12.6100", AngleText::kDms).has_value());
    EXPECT_FALSE(angleFrom("12.0060", AngleText::kDms).has_value());
}

TEST(UnitTextTest, UnitDigitsAreReadFromTheRight) {
    const auto units = unitDigits("3214", 1);  // the manual: mil, metre, Fahrenheit, inHg
    ASSERT_TRUE(units.has_value());
    EXPECT_EQ(units->angle, AngleText::kMil);
    EXPECT_EQ(units->length, LengthText::kMetre);
    EXPECT_EQ(units->temperature, TemperatureText::kFahrenheit);
    EXPECT_EQ(units->pressure, PressureText::kInHg);
    EXPECT_FALSE(unitDigits("1115", 1).has_value());
    EXPECT_FALSE(unitDigits("111", 1).has_value());
}

TEST(UnitTextTest, PressureDigitOneMeansMmHgWhenToldSo) {
    EXPECT_EQ(unitDigits("1111", 2)->pressure, PressureText::kMmHg);
    EXPECT_NEAR(pressureMeant(760.0, PressureText::kMmHg), 1013.25, 0.01);
    EXPECT_NEAR(pressureShown(1013.25, PressureText::kInHg), 29.92, 0.005);
}

TEST(UnitTextTest, NumbersKeepThePointInACommaLocale) {
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    std::setlocale(LC_NUMERIC, "fr_FR.UTF-8");  // changes nothing where the locale is not installed
    EXPECT_EQ(fixedText(12.5, 3), "12.500");
    EXPECT_EQ(plainNumber("12.5"), 12.5);
    std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(UnitTextTest, OnlyPlainDecimalsAreNumbers) {
    EXPECT_EQ(plainNumber("-0.5"), -0.5);
    EXPECT_EQ(plainNumber("+7"), 7.0);
    for (const char* text : {"", "-", ".", "1e3", "12,5", "1 2", "0x10", "1.2.3", "nan"}) {
        EXPECT_FALSE(plainNumber(text).has_value()) << text;
    }
    EXPECT_EQ(fixedText(-0.0001, 3), "0.000");
}

}  // namespace
}  // namespace pmts::simulator
