#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/targeting/click_method.hpp"
#include "pmts/targeting/recentring.hpp"
#include "support/fake_total_station.hpp"
#include "support/run_to_end.hpp"
#include "support/scene_frames.hpp"
#include "targeting/pictures.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace pmts::targeting {

/// A total station before a wall 20 m to the north, in virtual time. Its camera has a bent lens and sits crooked in
/// every direction.
struct CrookedCameraTest : testing::Test {
    static constexpr double kWall_m = 20.0;

    [[nodiscard]] static camera::Rig crookedRig() {
        using core::Angle;
        camera::Rig rig;
        rig.lens = camera::Lens(camera::BrownLens{.f_px = 1500, .cx_px = 652, .cy_px = 349, .k1 = -0.2, .k2 = 0.06});
        rig.mount = {.kind = camera::MountKind::kTelescope,
                     .offset_m = {0.02, 0.125, 0.11},
                     .yaw = Angle::fromGon(0.6),
                     .pitch = Angle::fromGon(0.7),
                     .twist = Angle::fromGon(-1.2)};
        return rig;
    }
    /// The wall with this picture on it.
    [[nodiscard]] static std::shared_ptr<const simulator::Scene> wallWith(const cv::Mat& picture, double wide_m, double high_m) {
        return std::make_shared<const simulator::Scene>(std::vector{simulator::Panel{
            QStringLiteral("wall"), {-wide_m / 2, kWall_m, -high_m / 2}, {wide_m, 0, 0}, {0, 0, high_m}, picture}});
    }

    void stand(const std::shared_ptr<const simulator::Scene>& scene) {
        truth = std::make_shared<simulator::TruePointing>();
        truth->place(begin);
        station.emplace(clock, truth);
        frames.emplace(clock, std::make_shared<simulator::SceneCamera>(scene, truth, crookedRig(),
                                                                       simulator::CameraFaults{.noise_sigma = 2.5}));
    }
    /// From now on the spot is what this pixel shows of the wall.
    void mark(const Eigen::Vector2d& px) {
        const auto ray = PixelToPointing(crookedRig()).rayForPixel(px, truth->at(clock.now()));
        spot = ray->at((kWall_m - ray->origin_m.y()) / ray->direction.y());
    }
    /// A click at this pixel, with the range of the spot as the true rig knows it.
    [[nodiscard]] Click clickOnSpot(const Eigen::Vector2d& px) {
        return {.frame = frames->now(), .at = station->reading(), .px = px, .slope_distance_m = spot.norm(), .first_target = {}};
    }
    [[nodiscard]] Eigen::Vector2d truePixel(const geometry::Pointing& at) const {
        return *PixelToPointing(crookedRig()).pixelForPoint(spot, at);
    }

    geometry::Pointing begin{core::Angle::fromGon(1.5), core::Angle::fromGon(101)};
    core::VirtualClock clock;
    std::shared_ptr<simulator::TruePointing> truth;
    std::optional<test::FakeTotalStation> station;
    std::optional<test::SceneFrames> frames;
    Eigen::Vector3d spot = Eigen::Vector3d::Zero();
};

}  // namespace pmts::targeting
