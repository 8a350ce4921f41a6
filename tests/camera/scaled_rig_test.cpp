#include "pmts/camera/scaled_rig.hpp"

#include <gtest/gtest.h>

namespace pmts::camera {
namespace {

Rig webcam() {
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = 1400.0, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12, .k2 = 0.02});
    rig.width_px = 1280;
    rig.height_px = 720;
    return rig;
}

TEST(ScaledRigTest, PictureOfTheDoubleSizeShowsTheSameAtTheDoublePlace) {
    const Rig live = webcam();
    const Rig large = scaledRig(live, 2560, 1440);
    const Eigen::Vector3d ray(0.21, -0.14, 1.0);
    const Eigen::Vector2d at = *live.lens.pixelFromCamera(ray);
    const Eigen::Vector2d again = *large.lens.pixelFromCamera(ray);
    EXPECT_NEAR(again.x(), 2.0 * at.x() + 0.5, 1e-9);  // centre of a pixel 0 lies half a pixel inside
    EXPECT_NEAR(again.y(), 2.0 * at.y() + 0.5, 1e-9);
    EXPECT_EQ(large.width_px, 2560);
}

TEST(ScaledRigTest, NarrowerPictureIsCutEvenlyAtBothSides) {
    const Rig narrow = scaledRig(webcam(), 640, 480);
    // 720 rows become 480: scale 2/3, 853.33 columns of which 640 stay.
    EXPECT_NEAR(narrow.lens.focalLengthPx(), 1400.0 * 2.0 / 3.0, 1e-9);
    EXPECT_NEAR(narrow.lens.principalPoint().x(), 644.0 * 2.0 / 3.0 - (1280.0 * 2.0 / 3.0 - 640.0) / 2.0 - 0.5, 1e-9);
    EXPECT_NEAR(narrow.lens.principalPoint().y(), 358.0 * 2.0 / 3.0 - 0.5, 1e-9);
}

TEST(ScaledRigTest, DistortionTableScalesInPixelsNotInAngle) {
    Rig rig = webcam();
    rig.lens = Lens(RadialTableLens{.cx_px = 640, .cy_px = 360, .rows = {{0, 0}, {300, 0.2}, {700, 0.42}}});
    const Rig half = scaledRig(rig, 640, 360);
    const auto& rows = std::get<RadialTableLens>(half.lens.model()).rows;
    EXPECT_NEAR(rows[1].radius_px, 150.0, 1e-12);
    EXPECT_EQ(rows[1].angle_rad, 0.2);
}

TEST(ScaledRigTest, TheModeOfTheCalibrationIsLeftAsItIs) {
    EXPECT_EQ(std::get<BrownLens>(scaledRig(webcam(), 1280, 720).lens.model()), std::get<BrownLens>(webcam().lens.model()));
}

TEST(ScaledRigTest, FisheyeAndResidualTableScaleToo) {
    Rig rig = webcam();
    ResidualTable table{.left_px = -0.5, .top_px = -0.5, .step_x_px = 640, .step_y_px = 360, .columns = 3, .rows = 3, .nodes_px = {}};
    for (int i = 0; i < 9; ++i) {
        table.nodes_px.emplace_back(0.3 * i, -0.1 * i);
    }
    rig.lens = Lens(FisheyeLens{.f_px = 500, .cx_px = 640, .cy_px = 360, .k1 = 0.01}).withResiduals(table);
    const Eigen::Vector3d ray(0.21, -0.13, 1.0);
    const Eigen::Vector2d px = *rig.lens.pixelFromCamera(ray);
    const Eigen::Vector2d half_px = *scaledRig(rig, 640, 360).lens.pixelFromCamera(ray);
    EXPECT_LT((half_px - ((px + Eigen::Vector2d(0.5, 0.5)) / 2 - Eigen::Vector2d(0.5, 0.5))).norm(), 1e-6);
}

}  // namespace
}  // namespace pmts::camera
