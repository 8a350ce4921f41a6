#include "pmts/geometry/frames.hpp"

#include "geometry/poses.hpp"
#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

#include <Eigen/LU>

namespace pmts::geometry {
namespace {

using core::Angle;
using test::FailedWith;

Pointing pointing(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

TEST(FramesTest, AlidadeTurnedToTheEastHasItsRightHandSouth) {
    const Eigen::Matrix3d station_from_alidade = stationFromAlidade(Angle::fromGon(100));
    EXPECT_TRUE(station_from_alidade.col(0).isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));  // right: south
    EXPECT_TRUE(station_from_alidade.col(1).isApprox(Eigen::Vector3d(1, 0, 0), 1e-12));   // forward: east
    EXPECT_TRUE(station_from_alidade.col(2).isApprox(Eigen::Vector3d(0, 0, 1), 1e-12));
}

TEST(FramesTest, TelescopeRaisedByFiftyGonTipsItsTopBackwards) {
    const Eigen::Matrix3d station_from_telescope = stationFromTelescope(pointing(0, 50));
    const double h = 0.70710678118655;
    EXPECT_TRUE(station_from_telescope.col(0).isApprox(Eigen::Vector3d(1, 0, 0), 1e-12));
    EXPECT_TRUE(station_from_telescope.col(1).isApprox(Eigen::Vector3d(0, h, h), 1e-12));
    EXPECT_TRUE(station_from_telescope.col(2).isApprox(Eigen::Vector3d(0, -h, h), 1e-12));
}

TEST(FramesTest, PlungedTelescopeLooksTheSameWayButStandsOnItsHead) {
    const Eigen::Matrix3d face_one = stationFromTelescope(pointing(20, 90));
    const Eigen::Matrix3d face_two = stationFromTelescope(otherFace(pointing(20, 90)));
    EXPECT_TRUE(face_two.col(1).isApprox(face_one.col(1), 1e-12));
    EXPECT_TRUE(face_two.col(0).isApprox(-face_one.col(0), 1e-12));
    EXPECT_TRUE(face_two.col(2).isApprox(-face_one.col(2), 1e-12));
}

TEST(FramesTest, LineOfSightIsTheForwardAxisAtEveryPointing) {
    test::RandomPoses poses(5);
    for (int i = 0; i < 200; ++i) {
        const Pointing at = poses.eitherFace();
        const Eigen::Matrix3d station_from_telescope = stationFromTelescope(at);
        EXPECT_NEAR(station_from_telescope.determinant(), 1.0, 1e-12);
        EXPECT_TRUE((station_from_telescope.transpose() * station_from_telescope).isIdentity(1e-12));
        EXPECT_LT((station_from_telescope.col(1) - stationFromPolar({at, 1.0})).norm(), 1e-12);
        EXPECT_NEAR(station_from_telescope.col(0).z(), 0.0, 1e-12);  // the trunnion axis is level
    }
}

TEST(FramesTest, DirectionGoesBackToItsPointing) {
    test::RandomPoses poses(6);
    for (int i = 0; i < 200; ++i) {
        const Pointing at = poses.faceOne();
        const auto again = pointingFromDirection(3.5 * directionFromPointing(at));
        ASSERT_TRUE(again.has_value());
        EXPECT_LT(separation(at, *again).cc(), 0.001);
    }
}

TEST(FramesTest, PlumbLineHasNoPointing) {
    EXPECT_THAT(pointingFromDirection({0, 0, 1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(pointingFromDirection({1e-10, 0, -1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(pointingFromDirection(Eigen::Vector3d::Zero()), FailedWith(core::ErrorKind::kUndefined));
}

}  // namespace
}  // namespace pmts::geometry
