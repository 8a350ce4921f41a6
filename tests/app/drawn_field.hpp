#pragma once

#include "app/field_fixture.hpp"
#include "pmts/simulator/scene_camera.hpp"

namespace pmts::app {

/// The field with a camera that draws what the telescope turns past: a wall 15 m to the north.
class DrawnFieldTest : public FieldTest {
protected:
    using FieldTest::FieldTest;

    void TearDown() override {
        stopShowing();
        FieldTest::TearDown();
    }
    void seeWall(const cv::Mat& picture, double wide_m, double high_m, const camera::Rig& rig,
                 const simulator::CameraFaults& faults = {}) {
        const auto wall = std::make_shared<const simulator::Scene>(std::vector{simulator::Panel{
            QStringLiteral("wall"), {-wide_m / 2, 15, -high_m / 2}, {wide_m, 0, 0}, {0, 0, high_m}, picture}});
        const auto drawing = std::make_shared<simulator::SceneCamera>(wall, true_pointing, rig, faults);
        camera->picture = [drawing](core::Duration at) { return drawing->draw(at).image.clone(); };
    }
    /// Connects and shows a picture in every `period` until the test ends; the first has its circle readings.
    void beginShowing(core::Duration period) {
        connectInstrument();
        range.setAssumed(15.0);
        show(period);
        ASSERT_TRUE(until([this] { return live.scene().pointing.has_value(); }));
    }
    void stopShowing() { next_frame_.cancel(); }

private:
    void show(core::Duration period) {
        camera->show(clock.now());
        next_frame_ = clock.callAfter(period, [this, period] { show(period); });
    }

    core::Timer next_frame_;
};

}  // namespace pmts::app
