#include "axis_errors.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

namespace pmts::simulator {
namespace {

using core::Angle;
using test::IsNearAngle;

const Angle kRounding = Angle::fromCc(1e-4);

geometry::Pointing steep() { return {Angle::fromGon(50), Angle::fromGon(60)}; }

TEST(AxisErrorsTest, CollimationGrowsWithTheSlope) {
    StationSettings errors;
    errors.collimation = Angle::fromMgon(10);
    const auto shown = circleReading(errors, steep(), true);
    // 10 mgon / sin(60 gon) = 10 mgon / 0.80901699
    EXPECT_THAT(shown.ha, IsNearAngle(Angle::fromGon(50.01236068), kRounding));
    EXPECT_THAT(shown.va, IsNearAngle(Angle::fromGon(60), kRounding));
}

TEST(AxisErrorsTest, MeanOfBothFacesIsFreeOfAxisErrors) {
    StationSettings errors;
    errors.collimation = Angle::fromMgon(10);
    errors.index_error = Angle::fromMgon(7);
    errors.trunnion_error = Angle::fromMgon(5);
    const auto one = circleReading(errors, steep(), true);
    const auto two = geometry::otherFace(circleReading(errors, geometry::otherFace(steep()), true));
    EXPECT_THAT((one.ha + two.ha) / 2.0, IsNearAngle(steep().ha, kRounding));
    EXPECT_THAT((one.va + two.va) / 2.0, IsNearAngle(steep().va, kRounding));
    EXPECT_GT(core::abs(one.va - two.va), Angle::fromMgon(13));
}

TEST(AxisErrorsTest, TiltShowsOnlyWithoutCompensator) {
    StationSettings errors;
    errors.tilt_north = Angle::fromMgon(20);
    const geometry::Pointing north{Angle{}, Angle::fromGon(90)};
    EXPECT_THAT(circleReading(errors, north, true).va, IsNearAngle(north.va, kRounding));
    EXPECT_THAT(circleReading(errors, north, false).va, IsNearAngle(Angle::fromGon(90.02), kRounding));
}

TEST(AxisErrorsTest, TruthIsFoundBackFromTheCircles) {
    StationSettings errors;
    errors.collimation = Angle::fromMgon(10);
    errors.index_error = Angle::fromMgon(-7);
    errors.trunnion_error = Angle::fromMgon(5);
    errors.tilt_east = Angle::fromMgon(30);
    for (const double va_gon : {20.0, 60.0, 100.0, 140.0, 260.0, 340.0}) {
        const geometry::Pointing truth{Angle::fromGon(123.4), Angle::fromGon(va_gon)};
        const auto found = trueFromReading(errors, circleReading(errors, truth, false), false);
        EXPECT_THAT(found.ha, IsNearAngle(truth.ha, Angle::fromCc(0.01))) << va_gon;
        EXPECT_THAT(found.va, IsNearAngle(truth.va, Angle::fromCc(0.01))) << va_gon;
    }
}

}  // namespace
}  // namespace pmts::simulator
