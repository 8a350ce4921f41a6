#include "pmts/geometry/polar.hpp"
#include "pmts/survey/point.hpp"
#include "support/matchers.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace pmts::survey {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;

/// Protocol page, section 6, DEMO1.JOB: station 100, and what its two points were observed as.
Station demoStation() {
    return {
        .name = QStringLiteral("100"), .e_m = 2000.0, .n_m = 1000.0, .h_m = 50.0, .instrument_height_m = 1.5};
}

Observation observed(double ha_gon, double va_gon, double sd_m, double target_height_m) {
    Observation observation;
    observation.pointing = {.ha = Angle::fromGon(ha_gon), .va = Angle::fromGon(va_gon)};
    observation.slope_distance_m = sd_m;
    observation.target_height_m = target_height_m;
    return observation;
}

void expectNear(const core::Result<Coordinates>& found, double e_m, double n_m, double h_m) {
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->e_m, e_m, 0.001);
    EXPECT_NEAR(found->n_m, n_m, 0.001);
    EXPECT_NEAR(found->h_m, h_m, 0.001);
}

TEST(CoordinatesTest, AgreeWithTheJobExampleOfTheProtocolPage) {
    expectNear(coordinatesOf(demoStation(), observed(75.0, 98.5, 25.0, 1.6), {}), 2023.091, 1009.564, 50.489);
    expectNear(coordinatesOf(demoStation(), observed(310.25, 104.125, 41.337, 1.6), {}), 1959.283, 1006.613,
               47.223);
}

TEST(CoordinatesTest, AreTheSameFromBothFaces) {
    expectNear(coordinatesOf(demoStation(), observed(275.0, 301.5, 25.0, 1.6), {}), 2023.091, 1009.564,
               50.489);
}

TEST(CoordinatesTest, OrientationIsAddedToTheCircleReading) {
    Station station = demoStation();
    station.orientation = Angle::fromGon(50.0);
    expectNear(coordinatesOf(station, observed(25.0, 98.5, 25.0, 1.6), {}), 2023.091, 1009.564, 50.489);
}

TEST(CoordinatesTest, DoNotFollowTheThesissEquations) {
    // Thesis eq. 4.1-4.3 take 22/7 for pi: at HA 100 gon and 100 m the point would lie 63 mm north (protocol
    // page 4.3), and its E is what everybody else calls N.
    const auto east = coordinatesOf({.e_m = 0, .n_m = 0, .h_m = 0}, observed(100.0, 100.0, 100.0, 0.0), {});
    expectNear(east, 100.0, 0.0, 0.0);
    EXPECT_NEAR(100.0 * std::cos(100.0 * 11 / 700), -0.063, 0.001);
}

TEST(CoordinatesTest, AnAbsurdPointHasNone) {
    Observation absurd = observed(75, 98.5, 25, 0);
    absurd.slope_distance_m.reset();
    absurd.absurd_reason = QStringLiteral("no echo within 7 s");
    const auto outcome = coordinatesOf(demoStation(), absurd, {});
    ASSERT_THAT(outcome, FailedWith(ErrorKind::kAbsurdPoint));
    EXPECT_TRUE(outcome.error().happened.contains(QStringLiteral("no echo within 7 s")));
    EXPECT_THAT(coordinatesOf(demoStation(), observed(75, 98.5, 0.0, 0), {}),
                FailedWith(ErrorKind::kAbsurdPoint));
    EXPECT_THAT(
        coordinatesOf(demoStation(), observed(75, 98.5, std::numeric_limits<double>::quiet_NaN(), 0), {}),
        FailedWith(ErrorKind::kAbsurdPoint));
}

TEST(CoordinatesTest, PrecisionOfALevelShotToTheEastIsDistanceAlongAndAngleAcross) {
    // By hand: along, sqrt(3^2 + (3 ppm of 100 m = 0.3)^2) = 3.015 mm; across, 100 m x 10 cc = 1.571 mm;
    // in space sqrt(3.015^2 + 2 x 1.571^2) = 3.745 mm.
    const auto found = coordinatesOf(demoStation(), observed(100.0, 100.0, 100.0, 0.0), {});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->sigma_e_m, 0.003015, 1e-6);
    EXPECT_NEAR(found->sigma_n_m, 0.001571, 1e-6);
    EXPECT_NEAR(found->sigma_h_m, 0.001571, 1e-6);
    EXPECT_NEAR(found->sigma3dM(), 0.003745, 1e-6);
}

TEST(CoordinatesTest, PrecisionOfAPlumbShotIsDistanceInHeight) {
    const auto found = coordinatesOf(demoStation(), observed(0.0, 0.0, 100.0, 0.0), {});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->sigma_h_m, 0.003015, 1e-6);
    EXPECT_NEAR(found->sigma_n_m, 0.001571, 1e-6);  // the tilt's error leans the line to the north
    EXPECT_NEAR(found->sigma_e_m, 0.0, 1e-9);
}

struct Spread {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
};

/// Shoots the same point again and again with seeded Gaussian errors: the spread of E, N, H.
Eigen::Vector3d spreadOfShots(const Station& station, const Observation& truth,
                              const InstrumentAccuracy& accuracy) {
    std::mt19937 dice(1848);
    std::normal_distribution<double> normal;
    const double sigma_sd_m =
        std::hypot(accuracy.distance_m, accuracy.distance_ppm * 1e-6 * *truth.slope_distance_m);
    const Coordinates exact = *coordinatesOf(station, truth, accuracy);
    constexpr int kShots = 100000;
    Spread spread;
    for (int i = 0; i < kShots; ++i) {
        Observation shot = truth;
        shot.pointing.ha += accuracy.angle * normal(dice);
        shot.pointing.va += accuracy.angle * normal(dice);
        *shot.slope_distance_m += sigma_sd_m * normal(dice);
        const Coordinates found = *coordinatesOf(station, shot, accuracy);
        const Eigen::Vector3d off{found.e_m - exact.e_m, found.n_m - exact.n_m, found.h_m - exact.h_m};
        spread.mean += off / kShots;
        spread.squares += off.cwiseAbs2() / kShots;
    }
    return (spread.squares - spread.mean.cwiseAbs2()).cwiseSqrt();
}

TEST(CoordinatesTest, PrecisionAgreesWithTheSpreadOfManyShots) {
    Station station = demoStation();
    station.orientation = Angle::fromGon(123.4);
    const InstrumentAccuracy accuracy{.angle = Angle::fromCc(15), .distance_m = 0.005, .distance_ppm = 5};
    const Observation steep = observed(222.0, 61.0, 812.0, 1.3);
    const Eigen::Vector3d spread_m = spreadOfShots(station, steep, accuracy);
    const Coordinates found = *coordinatesOf(station, steep, accuracy);
    // 100,000 shots know a sigma to 0.22 %: four times that.
    EXPECT_NEAR(found.sigma_e_m / spread_m.x(), 1.0, 0.009);
    EXPECT_NEAR(found.sigma_n_m / spread_m.y(), 1.0, 0.009);
    EXPECT_NEAR(found.sigma_h_m / spread_m.z(), 1.0, 0.009);
}

TEST(StationFrameTest, GivesBackTheReadingsOfTheJobExample) {
    // The same outside numbers as above, backwards: E, N, H printed to the millimetre, so 25 m know angles to
    // 50 cc.
    Station station = demoStation();
    station.orientation = Angle::fromGon(50.0);
    const auto polar =
        geometry::polarFromStation(stationFrameFromGround(station, 2023.091, 1009.564, 50.489, 1.6));
    ASSERT_TRUE(polar.has_value());
    EXPECT_THAT(polar->pointing.ha, IsNearAngle(Angle::fromGon(25.0), Angle::fromCc(25)));
    EXPECT_THAT(polar->pointing.va, IsNearAngle(Angle::fromGon(98.5), Angle::fromCc(25)));
    EXPECT_NEAR(polar->slope_distance_m, 25.0, 0.001);
}

TEST(StationFrameTest, IsTheInverseOfTheCoordinates) {
    std::mt19937 dice(7);
    std::uniform_real_distribution<double> turn_gon(0.0, 400.0), zenith_gon(20.0, 180.0),
        range_m(2.0, 2000.0);
    for (int i = 0; i < 200; ++i) {
        Station station = demoStation();
        station.orientation = Angle::fromGon(turn_gon(dice));
        const Observation shot = observed(turn_gon(dice), zenith_gon(dice), range_m(dice), 1.6);
        const Coordinates found = *coordinatesOf(station, shot, {});
        const Eigen::Vector3d again = stationFrameFromGround(station, found.e_m, found.n_m, found.h_m, 1.6);
        const Eigen::Vector3d expected = geometry::stationFromPolar(
            {.pointing = shot.pointing, .slope_distance_m = *shot.slope_distance_m});
        ASSERT_NEAR((again - expected).norm(), 0.0, 1e-8);
    }
}

}  // namespace
}  // namespace pmts::survey
