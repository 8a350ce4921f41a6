#include "pmts/simulator/simulated_rig.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace pmts::simulator {
namespace {

double angle_gon(const camera::Lens& lens, double radius_px) {
    const auto ray = lens.cameraFromPixel(lens.principalPoint() + Eigen::Vector2d(radius_px, 0));
    return std::atan2(ray->x(), ray->z()) * 200.0 / std::numbers::pi;
}

// The thesis's figures: 1.48121 gon behind the line at pixel 290; 0.083719 gon a pixel at the centre,
// 0.066547 at the edge.
TEST(SimulatedRigTest, ThesisCameraBendsAsItsFiguresSay) {
    const camera::Lens lens = thesisLens();
    EXPECT_NEAR(290 * 0.083719 - angle_gon(lens, 290), 1.48121, 1e-5);
    EXPECT_NEAR((angle_gon(lens, 20) - angle_gon(lens, 0)) / 20, 0.083719, 5e-5);
    EXPECT_NEAR(angle_gon(lens, 290) - angle_gon(lens, 289), 0.066547, 4e-4);  // the kink there is rounded
    const camera::Rig rig = simulatedRig({.lens = CameraLens::kThesis});
    EXPECT_EQ(rig.width_px, 640);
    EXPECT_TRUE(rig.lens.cameraFromPixel({639, 479}).has_value());
}

TEST(SimulatedRigTest, EveryLensSeesSomethingInEveryCorner) {
    for (const char* name : {"brown", "rational", "fisheye", "thesis"}) {
        const auto lens = cameraLensFromText(QLatin1String(name));
        ASSERT_TRUE(lens.has_value());
        const camera::Rig rig = simulatedRig({.lens = *lens});
        for (const Eigen::Vector2d& px :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(rig.width_px - 1, 0),
              Eigen::Vector2d(0, rig.height_px - 1), Eigen::Vector2d(rig.width_px - 1, rig.height_px - 1)}) {
            const auto ray = rig.lens.cameraFromPixel(px);
            ASSERT_TRUE(ray.has_value()) << name;
            EXPECT_LT((*rig.lens.pixelFromCamera(*ray) - px).norm(), 1e-6) << name;
        }
    }
    EXPECT_FALSE(cameraLensFromText("wide").has_value());
}

TEST(SimulatedRigTest, KnockedCameraIsElsewhereAndTheSameForTheSameSeed) {
    const camera::Mount straight = simulatedRig().mount;
    const camera::Mount knocked = simulatedRig({.mount = camera::MountKind::kHandle, .rig_error = 4}).mount;
    EXPECT_EQ(knocked.kind, camera::MountKind::kHandle);
    EXPECT_GT((knocked.offset_m - straight.offset_m).norm(), 1e-4);
    EXPECT_LT((knocked.offset_m - straight.offset_m).lpNorm<Eigen::Infinity>(), 0.008);
    EXPECT_NE(knocked.yaw, straight.yaw);
    EXPECT_EQ(knocked.offset_m, simulatedRig({.rig_error = 4}).mount.offset_m);
    EXPECT_NE(knocked.offset_m, simulatedRig({.rig_error = 5}).mount.offset_m);
}

}  // namespace
}  // namespace pmts::simulator
