#include "pmts/core/angle.hpp"

#include "support/matchers.hpp"

namespace pmts::core {
namespace {

TEST(AngleTest, ConvertsBetweenAllUnitsOfTheField) {
    // 177.56115 gon is 159 deg 48' 18.1" on the panel (thesis 3.5.3) and 2840.978 mil (protocol page 4.2).
    const Angle ha = Angle::fromGon(177.56115);
    EXPECT_NEAR(ha.deg(), 159.0 + 48.0 / 60 + 18.126 / 3600, 1e-9);
    EXPECT_NEAR(ha.mil(), 2840.978, 0.0005);
    EXPECT_NEAR(Angle::fromGon(200).rad(), std::numbers::pi, 1e-15);
    EXPECT_DOUBLE_EQ(Angle::fromCc(1).gon(), 0.0001);
    EXPECT_NEAR(Angle::fromArcsec(0.324).cc(), 1.0, 1e-12);
}

TEST(AngleTest, NormalizedStaysBelowAFullTurn) {
    EXPECT_DOUBLE_EQ(normalized(Angle::fromGon(-10)).gon(), 390.0);
    EXPECT_DOUBLE_EQ(normalized(Angle::fromGon(400)).gon(), 0.0);
    EXPECT_LT(normalized(Angle::fromGon(-1e-20)).gon(), 400.0);
}

TEST(AngleTest, SignedDifferenceTakesTheShortWayRound) {
    EXPECT_DOUBLE_EQ(normalizedSigned(Angle::fromGon(1) - Angle::fromGon(399)).gon(), 2.0);
    EXPECT_DOUBLE_EQ(normalizedSigned(Angle::fromGon(200)).gon(), 200.0);
    EXPECT_DOUBLE_EQ(normalizedSigned(Angle::fromGon(-200)).gon(), 200.0);
}

}  // namespace
}  // namespace pmts::core
