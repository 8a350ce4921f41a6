#pragma once

#include "app/field_fixture.hpp"
#include "pmts/simulator/scene_camera.hpp"
#include "pmts/simulator/simulated_rig.hpp"

#include <algorithm>

namespace pmts::app {

/// The field with a camera that draws what it would see from where the instrument truly points.
class LabTest : public FieldTest {
protected:
    /// From now on the camera is this one, in this scene.
    void look(const QString& scene_name, const camera::Rig& true_rig) {
        drawn_scene = std::make_shared<const simulator::Scene>(simulator::Scene::named(scene_name, 1).value());
        lookWith(true_rig);
    }
    void lookWith(const camera::Rig& true_rig) {
        rig = true_rig;
        auto drawing = std::make_shared<simulator::SceneCamera>(drawn_scene, true_pointing, rig, simulator::CameraFaults{});
        camera->picture = [drawing](core::Duration at) { return drawing->draw(at).image.clone(); };
    }
    /// Frames come while the clock runs, until it is so.
    bool watch(const std::function<bool()>& so, int most_frames = 200) {
        for (int i = 0; i < most_frames && !so(); ++i) {
            showFrames(1);
        }
        return so();
    }
    [[nodiscard]] geometry::PolarPoint mark(const char* name) const {
        const auto found = std::find_if(drawn_scene->marks().begin(), drawn_scene->marks().end(),
                                        [name](const simulator::Mark& m) { return m.name == QLatin1String(name); });
        return geometry::polarFromStation(found->p_station_m).value();
    }
    /// The telescope is put on the mark, as at the eyepiece.
    bool sight(const char* name) {
        const geometry::Pointing at = mark(name).pointing;
        const bool there = turnTo(at.ha.gon(), at.va.gon());
        showFrames(3);
        return there;
    }
    /// Where the camera truly sees the mark now.
    [[nodiscard]] QPointF seen(const char* name) const {
        const auto px = camera::pixelFromStation(rig, true_pointing->at(clock.now()), geometry::stationFromPolar(mark(name)));
        return {px->x(), px->y()};
    }

    std::shared_ptr<const simulator::Scene> drawn_scene;
    camera::Rig rig;
};

}  // namespace pmts::app
