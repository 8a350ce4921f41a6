#include "pmts/geometry/ray.hpp"

#include "geometry/poses.hpp"
#include "pmts/geometry/frames.hpp"
#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

namespace pmts::geometry {
namespace {

using core::Angle;
using test::FailedWith;

TEST(RayTest, LineOfSightPassesThroughTheMeasuredPointInBothFaces) {
    test::RandomPoses poses(7);
    for (int i = 0; i < 100; ++i) {
        const PolarPoint observed{poses.eitherFace(), poses.uniform(0.5, 500)};
        EXPECT_LT(distanceToRay(lineOfSight(observed.pointing), stationFromPolar(observed)), 1e-10);
    }
}

TEST(RayTest, RayBesideTheTelescopeReachesTheSlopeDistance) {
    // 3-4-5: 3 m to the right of the axis and parallel to it, 5 m of slope distance are reached 4 m ahead.
    const Ray ray{{3, 0, 0}, {0, 1, 0}};
    const auto point = intersectSphere(ray, 5.0);
    ASSERT_TRUE(point.has_value());
    EXPECT_TRUE(point->isApprox(Eigen::Vector3d(3, 4, 0), 1e-12));
}

TEST(RayTest, ReachedPointIsOnTheRayAndAtTheDistance) {
    test::RandomPoses poses(8);
    for (int i = 0; i < 200; ++i) {
        const Ray ray{poses.inBox(0.3), directionFromPointing(poses.eitherFace())};
        const double sd_m = poses.uniform(1, 5000);
        const auto point = intersectSphere(ray, sd_m);
        ASSERT_TRUE(point.has_value());
        EXPECT_NEAR(point->norm(), sd_m, 1e-9);
        EXPECT_LT(distanceToRay(ray, *point), 1e-9);
    }
}

TEST(RayTest, CameraOutsideTheSphereSeesItsNearSideOrNothing) {
    const auto near = intersectSphere({{0, -3, 0}, {0, 1, 0}}, 1.0);
    ASSERT_TRUE(near.has_value());
    EXPECT_TRUE(near->isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));
    EXPECT_THAT(intersectSphere({{0, -3, 0}, {0, -1, 0}}, 1.0), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(intersectSphere({{3, 0, 0}, {0, 1, 0}}, 1.0), FailedWith(core::ErrorKind::kUndefined));
}

TEST(RayTest, DistanceThatIsNoLengthIsNeverReached) {
    const Ray ray{{0, 0, 0}, {0, 1, 0}};
    for (const double sd_m : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(intersectSphere(ray, sd_m), FailedWith(core::ErrorKind::kUndefined)) << sd_m;
    }
}

TEST(RayTest, PointBehindARayIsAsFarAsItsOrigin) {
    EXPECT_DOUBLE_EQ(distanceToRay({{0, 0, 0}, {0, 1, 0}}, {3, -4, 0}), 5.0);
    EXPECT_DOUBLE_EQ(distanceToRay({{0, 0, 0}, {0, 1, 0}}, {3, 4, 0}), 3.0);
}

}  // namespace
}  // namespace pmts::geometry
