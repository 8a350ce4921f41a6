#include "pmts/app/field/range_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pmts::app {
namespace {

using core::Angle;

const geometry::Pointing kWall{.ha = Angle::fromGon(50), .va = Angle::fromGon(100)};

TEST(RangeKeeperTest, BeforeTheFirstShotTheRangeIsAssumedAndSaysSo) {
    const RangeKeeper range(25.0);
    EXPECT_EQ(range.rangeAt(kWall).source, RangeSource::kAssumed);
    EXPECT_EQ(range.rangeAt(kWall).slope_distance_m, 25.0);
}

TEST(RangeKeeperTest, ShotIsMeasuredWhereItWasMadeAndLastShotElsewhere) {
    RangeKeeper range(25.0);
    range.addShot(kWall, 15.2);
    EXPECT_EQ(range.rangeAt(kWall).source, RangeSource::kMeasured);
    const geometry::Pointing elsewhere{.ha = Angle::fromGon(50.06), .va = Angle::fromGon(100)};  // 60 mgon
    EXPECT_EQ(range.rangeAt(elsewhere).source, RangeSource::kLastShot);
    EXPECT_EQ(range.rangeAt(elsewhere).slope_distance_m, 15.2);
}

TEST(RangeKeeperTest, WithoutAPointingAShotIsNeverCalledMeasuredHere) {
    RangeKeeper range(25.0);
    range.addShot(kWall, 15.2);
    EXPECT_EQ(range.rangeAt(std::nullopt).source, RangeSource::kLastShot);
}

/// A wall 20 m to the north.
const geometry::Plane kNorthWall{.normal = {0, -1, 0}, .offset_m = 20.0};

TEST(RangeKeeperTest, PlanePredictsTheRangeOfEveryPointingThatMeetsIt) {
    RangeKeeper range(25.0);
    range.addShot(kWall, 15.2);
    range.setPlane(kNorthWall);
    // 50 gon off the perpendicular the wall is root two times as far.
    const geometry::Pointing north_west{.ha = Angle::fromGon(350), .va = Angle::fromGon(100)};
    EXPECT_EQ(range.rangeAt(north_west).source, RangeSource::kPlane);
    EXPECT_NEAR(range.rangeAt(north_west).slope_distance_m, 28.284271, 1e-6);
    EXPECT_EQ(range.rangeAt(kWall).source, RangeSource::kMeasured) << "what was measured there counts more";
    const geometry::Pointing south{.ha = Angle::fromGon(200), .va = Angle::fromGon(100)};
    EXPECT_EQ(range.rangeAt(south).source, RangeSource::kLastShot) << "the plane is behind";
}

TEST(RangeKeeperTest, ClickMeetsThePlaneAlongItsOwnRay) {
    RangeKeeper range(25.0);
    range.setPlane(kNorthWall);
    const geometry::Ray beside{.origin_m = {0.1, 0.1, 0.1}, .direction = Eigen::Vector3d(3, 4, 0).normalized()};
    const auto along = range.rangeAlong(beside, kWall);
    EXPECT_EQ(along.source, RangeSource::kPlane);
    // It meets y = 20 at x = 0.1 + 19.9 * 3 / 4.
    EXPECT_NEAR(along.slope_distance_m, std::hypot(0.1 + 14.925, 20.0, 0.1), 1e-9);
    range.forgetAll();
    EXPECT_EQ(range.rangeAlong(beside, kWall).source, RangeSource::kAssumed);
}

}  // namespace
}  // namespace pmts::app
