#include "calibration/sweeps.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "support/matchers.hpp"

#include <algorithm>

namespace pmts::calibration {
namespace {

using namespace std::chrono_literals;
using core::Angle;

Eigen::Vector3d facadeSpot() { return geometry::stationFromPolar(test::spotAt(20, 97, 22)); }

TEST(SweepPlanTest, SixtyPointingsInBothFacesTakeLessThanThreeMinutes) {
    const auto plan = planSweep(simulator::simulatedRig(), facadeSpot());
    ASSERT_TRUE(plan.has_value());
    EXPECT_LE(plan->pointings.size(), 60U);
    EXPECT_GE(plan->pointings.size(), 50U);
    EXPECT_LE(plan->instrument_time, 180s);
    const auto in_face_two =
        std::count_if(plan->pointings.begin(), plan->pointings.end(), geometry::isFaceTwo);
    EXPECT_EQ(2 * static_cast<std::size_t>(in_face_two), plan->pointings.size());
}

TEST(SweepPlanTest, SpotIsBroughtToWhereItIsWantedAndReachesEveryCorner) {
    const camera::Rig rig = simulator::simulatedRig();
    const auto plan = planSweep(rig, facadeSpot());
    ASSERT_TRUE(plan.has_value());
    std::vector<double> nearest_px(4, 1e9);
    for (std::size_t i = 0; i < plan->pointings.size(); ++i) {
        const auto px = camera::pixelFromStation(rig, plan->pointings[i], facadeSpot());
        ASSERT_TRUE(px.has_value());
        EXPECT_LT((*px - plan->wanted_px[i]).norm(), 0.01);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Eigen::Vector2d at(corner % 2 ? 1279 : 0, corner / 2 ? 719 : 0);
            nearest_px[corner] = std::min(nearest_px[corner], (*px - at).norm());
        }
    }
    EXPECT_LT(*std::max_element(nearest_px.begin(), nearest_px.end()), 40);
}

TEST(SweepPlanTest, CameraOnTheHandleIsSweptAlongARowInFaceOne) {
    const auto plan = planSweep(simulator::simulatedRig({.mount = camera::MountKind::kHandle}), facadeSpot(),
                                {.most_pointings = 20});
    ASSERT_TRUE(plan.has_value());
    EXPECT_EQ(plan->pointings.size(), 20U);
    for (const geometry::Pointing& at : plan->pointings) {
        EXPECT_EQ(at.va, plan->pointings.front().va);
        EXPECT_FALSE(geometry::isFaceTwo(at));
    }
    EXPECT_GT(plan->wanted_px.back().x() - plan->wanted_px.front().x(), 1200);
}

TEST(SweepPlanTest, ScoutingBeginsInTheMiddleAndStaysInside) {
    const auto plan = planSweep(simulator::simulatedRig(), facadeSpot(), scouting(0));
    ASSERT_TRUE(plan.has_value());
    EXPECT_LT((plan->wanted_px.front() - Eigen::Vector2d(640, 360)).norm(), 1.0);
    for (const Eigen::Vector2d& px : plan->wanted_px) {
        EXPECT_LT((px - Eigen::Vector2d(640, 360)).norm(), 200);
    }
}

TEST(SweepPlanTest, SpotAboveTheInstrumentIsRefused) {
    EXPECT_THAT(planSweep(simulator::simulatedRig(), {0, 0, 30}),
                test::FailedWith(core::ErrorKind::kUndefined));
}

// The protocol page's motors: 50 gon/s, 100 gon/s2.
TEST(SweepPlanTest, MotorsAccelerateCruiseAndBrake) {
    EXPECT_EQ(turningTime(0, 50, 100), core::Duration{0});
    EXPECT_EQ(turningTime(4, 50, 100), 400ms);
    EXPECT_EQ(turningTime(200, 50, 100), 4500ms);
}

}  // namespace
}  // namespace pmts::calibration
