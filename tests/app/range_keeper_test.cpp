#include "pmts/app/range_keeper.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pmts::app
