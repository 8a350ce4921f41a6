#include "pmts/geometry/plane.hpp"

#include "geometry/poses.hpp"
#include "pmts/geometry/frames.hpp"
#include "support/matchers.hpp"

namespace pmts::geometry {
namespace {

using test::FailedWith;

TEST(PlaneTest, ThreePointsGiveThePlaneOfSchoolGeometry) {
    // Intercepts 2, 4 and 4 m on the axes: 2x + y + z = 4, at 4 / sqrt(6) from the origin.
    const auto fit = fitPlane({{2, 0, 0}, {0, 4, 0}, {0, 0, 4}});
    ASSERT_TRUE(fit.has_value());
    EXPECT_TRUE(fit->plane.normal.isApprox(Eigen::Vector3d(-2, -1, -1) / std::sqrt(6.0), 1e-12));
    EXPECT_NEAR(fit->plane.offset_m, 4 / std::sqrt(6.0), 1e-12);
    EXPECT_DOUBLE_EQ(fit->rms_m, 0.0);
}

TEST(PlaneTest, NormalPointsTowardsTheStation) {
    test::RandomPoses poses(9);
    for (int i = 0; i < 50; ++i) {
        const auto fit = fitPlane({poses.inBox(20), poses.inBox(20), poses.inBox(20)});
        ASSERT_TRUE(fit.has_value());
        EXPECT_GE(signedDistance(fit->plane, Eigen::Vector3d::Zero()), 0.0);
        EXPECT_NEAR(fit->plane.normal.norm(), 1.0, 1e-12);
    }
}

TEST(PlaneTest, FitReportsTheBumpsOfAWall) {
    // A square wall at y = 10 whose corners stand 2 mm in and out by turns: the mean plane keeps y = 10.
    const auto fit = fitPlane({{-1, 10.002, -1}, {1, 9.998, -1}, {1, 10.002, 1}, {-1, 9.998, 1}});
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->plane.offset_m, 10.0, 1e-9);
    EXPECT_NEAR(fit->largest_m, 0.002, 1e-9);
    EXPECT_NEAR(fit->rms_m, 0.004, 1e-9);  // four residuals of 2 mm, one redundant point
    EXPECT_NEAR(fit->residuals_m[0], -0.002, 1e-9);
}

TEST(PlaneTest, PointsOfAPlaneHaveNoResidualWhereverItStands) {
    test::RandomPoses poses(10);
    for (int i = 0; i < 50; ++i) {
        const Eigen::Matrix3d turned = stationFromTelescope(poses.eitherFace());
        const Eigen::Vector3d shift = poses.inBox(100);
        std::vector<Eigen::Vector3d> points;
        for (int k = 0; k < 8; ++k) {
            points.emplace_back(turned * Eigen::Vector3d(poses.uniform(-5, 5), 0, poses.uniform(-5, 5)) +
                                shift);
        }
        const auto fit = fitPlane(points);
        ASSERT_TRUE(fit.has_value());
        EXPECT_LT(fit->largest_m, 1e-10);
        EXPECT_NEAR(std::abs(fit->plane.normal.dot(turned.col(1))), 1.0, 1e-9);
    }
}

TEST(PlaneTest, PointsOnOneLineOrTooFewMakeNoPlane) {
    EXPECT_THAT(fitPlane({{0, 1, 0}, {0, 2, 0}}), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(fitPlane({{0, 1, 0}, {0, 2, 0}, {0, 3, 0}}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(fitPlane({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), FailedWith(core::ErrorKind::kUndefined));
}

TEST(PlaneTest, LineOfSightMeetsTheWallItLooksAt) {
    const Plane wall{{0, -1, 0}, 10.0};
    const auto hit = intersect({{0, 0, 0}, Eigen::Vector3d(1, 1, 0).normalized()}, wall);
    ASSERT_TRUE(hit.has_value());
    EXPECT_TRUE(hit->isApprox(Eigen::Vector3d(10, 10, 0), 1e-12));
}

TEST(PlaneTest, WallBehindOrAlongTheLineOfSightIsNotMet) {
    const Plane wall{{0, -1, 0}, 10.0};
    EXPECT_THAT(intersect({{0, 0, 0}, {0, -1, 0}}, wall), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(intersect({{0, 0, 0}, {1, 0, 0}}, wall), FailedWith(core::ErrorKind::kUndefined));
}

}  // namespace
}  // namespace pmts::geometry
