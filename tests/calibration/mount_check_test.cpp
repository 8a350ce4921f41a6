#include "pmts/calibration/mount_check.hpp"

#include "pmts/simulator/scene_camera.hpp"
#include "support/matchers.hpp"

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::Angle;
using core::ErrorKind;
using test::FailedWith;

camera::Rig rigOn(MountKind kind, double f_px = 1400) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = f_px, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12});
    rig.mount = {.kind = kind, .offset_m = {0.012, 0.085, 0.052}, .yaw = {}, .pitch = Angle::fromGon(-0.2), .twist = {}};
    return rig;
}

geometry::Pointing at(double va_gon) { return {Angle::fromGon(0), Angle::fromGon(va_gon)}; }

class MountCheckTest : public testing::Test {
protected:
    [[nodiscard]] cv::Mat seen(const camera::Rig& rig, double va_gon) const {
        auto truth = std::make_shared<simulator::TruePointing>();
        truth->place(at(va_gon));
        return simulator::SceneCamera(square_, truth, rig, {}).draw({}).image.clone();
    }
    /// With a rig the user believes in: a telescope camera whose lens is 8 % off.
    [[nodiscard]] core::Result<MountCheck> check(const camera::Rig& truth, double tilt_gon) const {
        return mountFromMotion(seen(truth, 98), at(98), seen(truth, 98 + tilt_gon), at(98 + tilt_gon),
                               rigOn(MountKind::kTelescope, 1512));
    }

    std::shared_ptr<const simulator::Scene> square_ = std::make_shared<const simulator::Scene>(simulator::Scene::townSquare(1));
};

TEST_F(MountCheckTest, PictureThatMovesByTheTiltIsATelescopeCameras) {
    for (const double tilt_gon : {3.0, -3.0}) {
        const auto verdict = check(rigOn(MountKind::kTelescope), tilt_gon);

        ASSERT_TRUE(verdict.has_value()) << testing::PrintToString(verdict.error());
        EXPECT_EQ(verdict->kind, MountKind::kTelescope);
        EXPECT_GT(verdict->confidence, 0.9);
        EXPECT_NEAR(verdict->moved_px, 1400 * std::tan(0.0471), 4);
    }
}

TEST_F(MountCheckTest, PictureThatStaysIsAHandleCameras) {
    const auto verdict = check(rigOn(MountKind::kHandle), 3.0);

    ASSERT_TRUE(verdict.has_value()) << testing::PrintToString(verdict.error());
    EXPECT_EQ(verdict->kind, MountKind::kHandle);
    EXPECT_GT(verdict->confidence, 0.9);
    EXPECT_NEAR(verdict->moved_px, 0, 1);
}

TEST_F(MountCheckTest, CoveredLensIsRefused) {
    const cv::Mat black(720, 1280, CV_8UC3, cv::Scalar::all(12));

    EXPECT_THAT(mountFromMotion(black, at(98), black, at(101), rigOn(MountKind::kTelescope)), FailedWith(ErrorKind::kUndefined));
}

TEST_F(MountCheckTest, TurnTooSmallToTellIsRefused) {
    const cv::Mat picture = seen(rigOn(MountKind::kTelescope), 98);

    EXPECT_THAT(mountFromMotion(picture, at(98), picture, at(98.1), rigOn(MountKind::kTelescope)), FailedWith(ErrorKind::kLimit));
}

TEST_F(MountCheckTest, PicturesOfTwoScenesGiveNoVerdict) {
    const camera::Rig rig = rigOn(MountKind::kTelescope);
    auto truth = std::make_shared<simulator::TruePointing>();
    truth->place({Angle::fromGon(1.5), Angle::fromGon(98)});
    const cv::Mat beside = simulator::SceneCamera(square_, truth, rig, {}).draw({}).image.clone();

    const auto verdict = mountFromMotion(seen(rig, 98), at(98), beside, at(101), rig);

    EXPECT_TRUE(!verdict || !verdict->kind);  // it moved sideways: neither mount does
}

}  // namespace
}  // namespace pmts::calibration
