#include "pmts/targeting/sun_position.hpp"

#include "support/matchers.hpp"

#include <QTimeZone>

namespace pmts::targeting {
namespace {

using core::Angle;
using test::IsNearAngle;

const Angle kPromised = Angle::fromDeg(0.02);

QDateTime utc(int year, int month, int day, int hour, int minute, int second = 0) {
    return QDateTime(QDate(year, month, day), QTime(hour, minute, second), QTimeZone::utc());
}

Place at(double latitude_deg, double longitude_deg) {
    return {Angle::fromDeg(latitude_deg), Angle::fromDeg(longitude_deg)};
}

TEST(SunPositionTest, AgreesWithTheWorkedExampleOfTheSolarPositionAlgorithm) {
    // NREL/TP-560-34302, appendix A.5: Golden, Colorado, 17 October 2003, 12:30:30 local time (UTC - 7 h).
    // Azimuth 194.34024, elevation before refraction 39.87205 degrees.
    const SunPosition sun = sunPosition(at(39.742476, -105.1786), utc(2003, 10, 17, 19, 30, 30));
    EXPECT_THAT(sun.azimuth, IsNearAngle(Angle::fromDeg(194.34024), kPromised));
    EXPECT_THAT(sun.zenith_angle, IsNearAngle(Angle::fromDeg(90 - 39.87205), kPromised));
}

TEST(SunPositionTest, DeclinationIsThatOfMeeussExample) {
    // Astronomical Algorithms, example 25.a: 13 October 1992, 0 h dynamical time (59 s before UTC midnight),
    // declination -7.78507 degrees. At the pole the zenith angle is 90 degrees less the declination.
    const SunPosition sun = sunPosition(at(90, 0), utc(1992, 10, 12, 23, 59, 1));
    EXPECT_THAT(sun.zenith_angle, IsNearAngle(Angle::fromDeg(97.78507), Angle::fromDeg(0.001)));
}

TEST(SunPositionTest, EquinoxAndSolsticeFallOnTheirPublishedTimes) {
    // 20 March 2024 03:06 and 20 June 2024 20:51 UTC (declination 23.44 degrees).
    EXPECT_THAT(sunPosition(at(90, 0), utc(2024, 3, 20, 3, 6)).zenith_angle,
                IsNearAngle(Angle::fromDeg(90), Angle::fromDeg(0.001)));
    EXPECT_THAT(sunPosition(at(90, 0), utc(2024, 6, 20, 20, 51)).zenith_angle,
                IsNearAngle(Angle::fromDeg(90 - 23.44), Angle::fromDeg(0.005)));
}

TEST(SunPositionTest, RisesInTheEastStandsInTheSouthAndSetsInTheWest) {
    const Place greenwich = at(51.4769, 0.0);
    EXPECT_NEAR(sunPosition(greenwich, utc(2024, 3, 20, 6, 7)).azimuth.deg(), 90, 1.0);
    EXPECT_NEAR(sunPosition(greenwich, utc(2024, 3, 20, 12, 7)).azimuth.deg(), 180, 1.0);
    EXPECT_NEAR(sunPosition(greenwich, utc(2024, 3, 20, 18, 7)).azimuth.deg(), 270, 1.0);
    EXPECT_GT(sunPosition(greenwich, utc(2024, 3, 20, 0, 7)).zenith_angle.deg(), 120);
}

TEST(SunPositionTest, SouthOfTheEquatorTheNoonSunStandsInTheNorth) {
    const SunPosition sun = sunPosition(at(-33.87, 151.21), utc(2024, 6, 21, 1, 57));
    EXPECT_NEAR(core::normalizedSigned(sun.azimuth).deg(), 0, 1.0);
    EXPECT_NEAR(sun.zenith_angle.deg(), 33.87 + 23.44, 0.05);
}

}  // namespace
}  // namespace pmts::targeting
