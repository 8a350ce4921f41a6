#include "pmts/app/settings/unit_format.hpp"

#include "support/matchers.hpp"

namespace pmts::app {
namespace {

using core::Angle;

TEST(UnitFormatTest, AnglesAreShownInEveryUnitOfTheInstrument) {
    const Angle angle = Angle::fromGon(177.5612);  // the thesis's target, 159 deg 48' 18"
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kGon}.angle(angle), QStringLiteral("177.5612 gon"));
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kDms}.angle(angle), QStringLiteral("159°48'18\""));
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kMil}.angle(angle), QStringLiteral("2840.979 mil"));
}

TEST(UnitFormatTest, DirectionIsNeverNegative) {
    EXPECT_EQ(UnitFormat{}.direction(Angle::fromGon(-0.5)), QStringLiteral("399.5000 gon"));
}

TEST(UnitFormatTest, DirectionJustBelowAWholeTurnIsShownAsZero) {
    const Angle almost = Angle::fromGon(399.99998);
    EXPECT_EQ(UnitFormat{}.direction(almost), QStringLiteral("0.0000 gon"));
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kDms}.direction(almost), QStringLiteral("0°00'00\""));
    EXPECT_EQ(UnitFormat{}.directionNumber(almost), QStringLiteral("0.0000"));
    EXPECT_EQ(UnitFormat{}.directionNumber(Angle::fromGon(-0.5)), QStringLiteral("399.5000"));
}

TEST(UnitFormatTest, LengthsAreShownInMetresAndInternationalFeet) {
    EXPECT_EQ(UnitFormat{}.length(1.6), QStringLiteral("1.600 m"));
    EXPECT_EQ((UnitFormat{.length_unit = core::LengthUnit::kFoot}.length(1.6)), QStringLiteral("5.249 ft"));
}

TEST(UnitFormatTest, ResidualsAreShownInSmallUnits) {
    const Angle residual = Angle::fromGon(0.0012);  // 3.9 arc seconds
    EXPECT_EQ(UnitFormat{}.smallAngle(residual), QStringLiteral("1.2 mgon"));
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kDms}.smallAngle(residual), QStringLiteral("3.9\""));
    EXPECT_EQ(UnitFormat{.angle_unit = core::AngleUnit::kMil}.smallAngle(residual), QStringLiteral("0.019 mil"));
}

TEST(UnitFormatTest, PrecisionOfMillimetresHasADecimalUntilTen) {
    EXPECT_EQ(UnitFormat{}.precision(0.0021), QStringLiteral("± 2.1 mm"));
    EXPECT_EQ(UnitFormat{}.precision(0.0123), QStringLiteral("± 12 mm"));
}

TEST(UnitFormatTest, AnyUnitAndArithmeticIsUnderstoodWhateverIsShown) {
    const UnitFormat feet{.angle_unit = core::AngleUnit::kDegree, .length_unit = core::LengthUnit::kFoot};
    EXPECT_NEAR(feet.parseLengthM(u"10").value(), 3.048, 1e-12);
    EXPECT_NEAR(feet.parseLengthM(u"1.5 m + 10 cm").value(), 1.6, 1e-12);
    EXPECT_NEAR(feet.parseAngle(u"90")->gon(), 100.0, 1e-12);
    EXPECT_NEAR(feet.parseAngle(u"12.5 gon")->gon(), 12.5, 1e-12);
    EXPECT_NEAR(feet.parseAngle(u"5'")->arcsec(), 300.0, 1e-9);
}

TEST(UnitFormatTest, TextThatIsNoQuantityIsNamedInTheError) {
    const auto length = UnitFormat{}.parseLengthM(u"tall");
    ASSERT_THAT(length, test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_TRUE(length.error().sentence().contains(QStringLiteral("tall")));
}

}  // namespace
}  // namespace pmts::app
