#include "pmts/targeting/pointing_guard.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

#include <QTimeZone>

namespace pmts::targeting {
namespace {

using core::Angle;
using core::ErrorKind;
using geometry::Pointing;
using test::FailedWith;
using test::IsNearAngle;

Pointing pointing(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

/// A clock that stands at one moment.
class StandingClock final : public core::Clock {
public:
    explicit StandingClock(QDateTime utc) : utc_(std::move(utc)) {}
    core::Duration now() const override { return core::Duration(0); }
    QDateTime utcNow() const override { return utc_; }
    core::Timer callAfter(core::Duration, std::function<void()>) override { return {}; }

private:
    QDateTime utc_;
};

/// Greenwich at noon of the spring equinox: the Sun in the south (200 gon), 51.5 degrees (57.2 gon) from the
/// zenith.
struct PointingGuardTest : testing::Test {
    StandingClock noon{QDateTime(QDate(2024, 3, 20), QTime(12, 7), QTimeZone::utc())};
    StandingClock midnight{QDateTime(QDate(2024, 3, 20), QTime(0, 7), QTimeZone::utc())};
    PointingGuardSettings watching{
        .limits = {},
        .sun = SunGuard{.place = {Angle::fromDeg(51.4769), Angle()}, .azimuth_of_zero = Angle()},
        .most_wound = {}};
};

TEST_F(PointingGuardTest, TargetNearTheSunIsRefusedWithItsDistance) {
    const PointingGuard guard(noon, watching);
    const auto refusal = guard.check(pointing(100, 100), pointing(200, 60));
    ASSERT_THAT(refusal, FailedWith(ErrorKind::kLimit));
    EXPECT_TRUE(refusal.error().happened.contains("Sun"));
    EXPECT_FALSE(refusal.error().remedy.isEmpty());
    EXPECT_TRUE(guard.check(pointing(100, 100), pointing(100, 60)));
}

TEST_F(PointingGuardTest, FaceTwoLooksAtTheSameSun) {
    const PointingGuard guard(noon, watching);
    const Pointing sun_in_face_two = geometry::otherFace(pointing(200, 60));
    EXPECT_THAT(guard.check(pointing(300, 300), sun_in_face_two), FailedWith(ErrorKind::kLimit));
}

TEST_F(PointingGuardTest, WayAcrossTheSunIsRefusedToo) {
    const PointingGuard guard(noon, watching);
    const auto refusal = guard.check(pointing(150, 57), pointing(250, 57));
    ASSERT_THAT(refusal, FailedWith(ErrorKind::kLimit));
    EXPECT_EQ(refusal.error().detail, "sun on the way");
    EXPECT_TRUE(guard.check(pointing(150, 57), pointing(150, 100)));
    EXPECT_TRUE(guard.check(pointing(150, 100), pointing(250, 100)));
    EXPECT_TRUE(guard.check(pointing(250, 100), pointing(250, 57)));
}

TEST_F(PointingGuardTest, TelescopeTheSunHasCaughtMayLeave) {
    const PointingGuard guard(noon, watching);
    EXPECT_THAT(guard.checkStanding(pointing(205, 60)), FailedWith(ErrorKind::kLimit));
    EXPECT_TRUE(guard.check(pointing(205, 60), pointing(240, 60)));
    EXPECT_THAT(guard.check(pointing(205, 60), pointing(200, 57)), FailedWith(ErrorKind::kLimit));
}

TEST_F(PointingGuardTest, OrientationTurnsTheSunWithTheCircle) {
    PointingGuardSettings turned = watching;
    turned.sun->azimuth_of_zero = Angle::fromGon(50);
    const PointingGuard guard(noon, turned);
    EXPECT_THAT(guard.check(pointing(100, 100), pointing(150, 60)), FailedWith(ErrorKind::kLimit));
    EXPECT_TRUE(guard.check(pointing(200, 100), pointing(200, 60)));
}

TEST_F(PointingGuardTest, SunBelowTheHorizonBarsNothing) {
    const PointingGuard guard(midnight, watching);
    EXPECT_TRUE(guard.check(pointing(100, 100), pointing(0, 100)));
}

TEST_F(PointingGuardTest, GuardWithoutAPlaceSaysThatItSleeps) {
    EXPECT_FALSE(PointingGuard(noon).sunSleeps().isEmpty());
    EXPECT_TRUE(PointingGuard(noon, watching).sunSleeps().isEmpty());
}

TEST_F(PointingGuardTest, TargetsOutsideTheMotionLimitsAreRefusedEachWithItsReason) {
    const PointingGuard guard(midnight,
                              {.limits = {.highest = Angle::fromGon(20),
                                          .lowest = Angle::fromGon(140),
                                          .face_two_allowed = false,
                                          .ha_sector = std::pair(Angle::fromGon(350), Angle::fromGon(50))},
                               .sun = {},
                               .most_wound = {}});
    const Pointing home = pointing(0, 100);
    EXPECT_EQ(guard.check(home, pointing(0, 10)).error().detail, "high");
    EXPECT_EQ(guard.check(home, pointing(0, 150)).error().detail, "low");
    EXPECT_EQ(guard.check(home, pointing(0, 300)).error().detail, "face");
    EXPECT_EQ(guard.check(home, pointing(60, 100)).error().detail, "sector");
    EXPECT_TRUE(guard.check(home, pointing(390, 100)));
    EXPECT_TRUE(guard.check(home, pointing(50, 20)));
}

TEST_F(PointingGuardTest, LimitsOfTheZenithAngleHoldInFaceTwo) {
    PointingGuardSettings settings;
    settings.limits.highest = Angle::fromGon(20);
    const PointingGuard guard(midnight, settings);
    EXPECT_THAT(guard.check(pointing(0, 100), pointing(0, 390)), FailedWith(ErrorKind::kLimit));
    EXPECT_TRUE(guard.check(pointing(0, 100), pointing(0, 370)));
}

TEST_F(PointingGuardTest, CableIsWoundByEveryTurnAndTheTurnTooMuchIsRefused) {
    PointingGuard guard(midnight, {.limits = {}, .sun = {}, .most_wound = Angle::fromGon(500)});
    for (const double ha_gon : {0.0, 150.0, 300.0, 50.0, 90.0}) {  // 490 gon clockwise
        guard.follow(pointing(ha_gon, 100));
    }
    EXPECT_THAT(*guard.wound(), IsNearAngle(Angle::fromGon(490), Angle::fromCc(1)));
    const auto refusal = guard.check(pointing(90, 100), pointing(110, 100));
    ASSERT_THAT(refusal, FailedWith(ErrorKind::kLimit));
    EXPECT_EQ(refusal.error().detail, "cable");
    EXPECT_TRUE(guard.check(pointing(90, 100), pointing(70, 100)));
    EXPECT_TRUE(guard.check(pointing(90, 100), pointing(100, 100)));
}

TEST_F(PointingGuardTest, LongWayReachesTheTargetAndUnwindsTheCable) {
    PointingGuard guard(midnight, {.limits = {}, .sun = {}, .most_wound = Angle::fromGon(500)});
    for (const double ha_gon : {0.0, 150.0, 300.0, 50.0, 90.0}) {
        guard.follow(pointing(ha_gon, 100));
    }
    Pointing at = pointing(90, 100);
    for (const Pointing& leg : PointingGuard::longWay(at, pointing(110, 90))) {
        EXPECT_TRUE(guard.check(at, leg));
        guard.follow(leg);
        at = leg;
    }
    EXPECT_EQ(at, pointing(110, 90));
    EXPECT_THAT(*guard.wound(), IsNearAngle(Angle::fromGon(110), Angle::fromCc(1)));
    EXPECT_LT(std::abs(guard.wound()->gon() - 110), 1e-6);
}

TEST_F(PointingGuardTest, CableThatIsWoundTooFarMayAlwaysBeUnwound) {
    PointingGuard guard(midnight, {.limits = {}, .sun = {}, .most_wound = Angle::fromGon(100)});
    guard.follow(pointing(0, 100));
    guard.follow(pointing(150, 100));  // by hand
    EXPECT_TRUE(guard.check(pointing(150, 100), pointing(60, 100)));
    guard.unwound();
    EXPECT_TRUE(guard.check(pointing(150, 100), pointing(240, 100)));
}

}  // namespace
}  // namespace pmts::targeting
