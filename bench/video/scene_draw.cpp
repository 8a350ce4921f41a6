#include "scene_draw.hpp"

#include "pmts/simulator/scene_camera.hpp"
#include "support/figure.hpp"

#include <chrono>

namespace pmts::bench {
namespace {

using Steady = std::chrono::steady_clock;

double millisecondsSince(Steady::time_point start) {
    return std::chrono::duration<double, std::milli>(Steady::now() - start).count();
}

}  // namespace

void sceneDraw() {
    const auto start = Steady::now();
    const auto scene = std::make_shared<const simulator::Scene>(simulator::Scene::townSquare(1));
    figure("video.scene_build", millisecondsSince(start), "ms", Wanted::kAtMost, 800);

    camera::Rig rig;
    rig.lens =
        camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 641, .cy_px = 358, .k1 = -0.2, .k2 = 0.05});
    const auto pointing = std::make_shared<simulator::TruePointing>();
    pointing->setMotion({.end_gon = 400.0, .acceleration_gon_s2 = 1000.0},
                        {.start_gon = 96.0, .end_gon = 96.0});
    simulator::SceneCamera camera(scene, pointing, rig, {});
    std::vector<double> times_ms;
    for (int i = 0; i < 150; ++i) {  // once round the square
        const auto frame_start = Steady::now();
        (void)camera.draw(std::chrono::milliseconds(i * 53));
        times_ms.push_back(millisecondsSince(frame_start));
    }
    figure("video.scene_draw_median", median(times_ms), "ms", Wanted::kAtMost, 20);
}

}  // namespace pmts::bench
