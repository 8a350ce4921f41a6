#include "geometry/poses.hpp"
#include "pmts/camera/rig.hpp"
#include "pmts/geometry/ray.hpp"
#include "support/matchers.hpp"

#include <string>

namespace pmts::camera {
namespace {

using core::Angle;
using geometry::Pointing;

/// The thesis's eq. 5.1-5.32: eight cases of zero and non-zero offsets, X' and Z', forward and inverse,
/// written out as printed. Its (Xo, Yo, Zo) is the image plane's centre; X' and Z' are metres on the sensor,
/// f in metres too.
struct ThesisCamera {
    double f_m = 0.0045;
    Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector2d image_m(const Eigen::Vector3d& p) const {
        const double reduced = f_m / (p.y() - offset_m.y() - f_m);
        return {reduced * (p.x() - offset_m.x()), reduced * (p.z() - offset_m.z())};
    }
    [[nodiscard]] Eigen::Vector3d object(const Eigen::Vector2d& image, double y_m) const {
        const double enlarged = (y_m - offset_m.y() - f_m) / f_m;
        return {enlarged * image.x() + offset_m.x(), y_m, enlarged * image.y() + offset_m.z()};
    }
};

constexpr double kPixelPitch_m = 6e-6;
constexpr double kCx_px = 315;
constexpr double kCy_px = 240;

/// The same camera as a case of the general model. The relation between the two: our centre is the centre of
/// projection, which is one f in front of the thesis's image plane, so Yo = Yo(thesis) + f; f_px = f / pixel
/// pitch; u = cx + X' / pitch, v = cy - Z' / pitch, because v grows downwards.
Rig generalRig(const ThesisCamera& thesis) {
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = thesis.f_m / kPixelPitch_m, .cx_px = kCx_px, .cy_px = kCy_px});
    rig.mount.offset_m = thesis.offset_m + Eigen::Vector3d(0, thesis.f_m, 0);
    return rig;
}

Eigen::Vector2d pixelFromImage(const Eigen::Vector2d& image_m) {
    return {kCx_px + image_m.x() / kPixelPitch_m, kCy_px - image_m.y() / kPixelPitch_m};
}

struct OffsetCase {
    std::string name;
    Eigen::Vector3d offset_m;
};

class ThesisProjectionTest : public testing::TestWithParam<OffsetCase> {
protected:
    const ThesisCamera thesis{.offset_m = GetParam().offset_m};
    const Rig rig = generalRig(thesis);
    const Pointing ahead{Angle::fromGon(0), Angle::fromGon(100)};  // station axes and camera axes agree
};

TEST_P(ThesisProjectionTest, ForwardEquationsAreACaseOfTheGeneralModel) {
    test::RandomPoses poses(41);
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d p_station = poses.inBox(2) + Eigen::Vector3d(0, 8, 0);
        const auto px = pixelFromStation(rig, ahead, p_station);
        ASSERT_TRUE(px.has_value());
        EXPECT_LT((*px - pixelFromImage(thesis.image_m(p_station))).norm(), 1e-9);
    }
}

TEST_P(ThesisProjectionTest, InverseEquationsAreACaseOfTheGeneralModel) {
    test::RandomPoses poses(42);
    const CameraPose pose = cameraPose(rig.mount, ahead);
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d image_m(poses.uniform(-0.0018, 0.0018), poses.uniform(-0.0014, 0.0014));
        const Eigen::Vector3d p_thesis = thesis.object(image_m, poses.uniform(4, 60));
        const auto ray_camera = rig.lens.cameraFromPixel(pixelFromImage(image_m));
        ASSERT_TRUE(ray_camera.has_value());
        const geometry::Ray ray{pose.centre_station_m, pose.station_from_camera * *ray_camera};
        EXPECT_LT(geometry::distanceToRay(ray, p_thesis), 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Offsets, ThesisProjectionTest,
    testing::Values(OffsetCase{"None", {0, 0, 0}}, OffsetCase{"OnlyX", {0.06, 0, 0}},
                    OffsetCase{"OnlyY", {0, 0.085, 0}}, OffsetCase{"OnlyZ", {0, 0, 0.052}},
                    OffsetCase{"ZeroX", {0, 0.085, 0.052}}, OffsetCase{"ZeroY", {0.06, 0, 0.052}},
                    OffsetCase{"ZeroZ", {0.06, 0.085, 0}}, OffsetCase{"All", {0.06, 0.085, 0.052}}),
    [](const auto& tested) { return tested.param.name; });

TEST(ThesisPixelFormTest, PixelEquationsOfTheReferenceHoldWithoutTheMetricFocalLength) {
    // u = cx + f_px (X - Xo) / (Y - Yo), v = cy - f_px (Z - Zo) / (Y - Yo) with f = 784 px (PMTS reference,
    // section 5).
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = 784, .cx_px = 315, .cy_px = 240});
    rig.mount.offset_m = {0.06, 0.085, 0.052};
    const auto px = pixelFromStation(rig, {Angle::fromGon(0), Angle::fromGon(100)}, {1.06, 8.085, 0.552});
    ASSERT_TRUE(px.has_value());
    EXPECT_TRUE(px->isApprox(Eigen::Vector2d(315 + 98, 240 - 49), 1e-12));
}

TEST(ThesisPixelFormTest, TakingTheImagePlaneForTheCentreCostsAThirdOfAPixelAtFiveMetres) {
    // Why the relation matters: the same Yo read as the centre of projection shifts the edge of the picture
    // by 315 px * 4.5 mm / 5 m = 0.28 px.
    const ThesisCamera thesis{};
    Rig rig = generalRig(thesis);
    rig.mount.offset_m = thesis.offset_m;
    const Eigen::Vector3d p_station(2.1, 5, 0);
    const auto px = pixelFromStation(rig, {Angle::fromGon(0), Angle::fromGon(100)}, p_station);
    EXPECT_NEAR(pixelFromImage(thesis.image_m(p_station)).x() - px->x(), 0.28, 0.01);
}

}  // namespace
}  // namespace pmts::camera
