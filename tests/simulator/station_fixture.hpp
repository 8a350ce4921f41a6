#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/simulator/station.hpp"
#include "support/matchers.hpp"

#include <string>

namespace pmts::simulator {

/// Walls north (20 m), east (100 m) and, black and absorbing, south (10 m); sky in the west.
inline std::shared_ptr<const Scene> threeWalls() {
    const auto panel = [](const char* name, Eigen::Vector3d origin, Eigen::Vector3d right,
                          bool absorbing = false) {
        return Panel{QString::fromLatin1(name),
                     origin,
                     right,
                     {0, 0, 40},
                     cv::Mat(2, 2, CV_8UC3, cv::Scalar(90, 90, 90)),
                     absorbing};
    };
    static const auto scene = std::make_shared<const Scene>(std::vector<Panel>{
        panel("north", {-20, 20, -20}, {40, 0, 0}), panel("east", {100, 20, -20}, {0, -40, 0}),
        panel("black", {5, -10, -20}, {-10, 0, 0}, true)});
    return scene;
}

/// A station without noise and without wire time, on a clock that moves when told to.
class StationTest : public testing::Test {
protected:
    StationTest() {
        settings.baud = 0.0;
        settings.angle_sigma = {};
        settings.edm_sigma_m = settings.edm_sigma_ppm = 0.0;
        settings.trk_accuracy = settings.fast_std_accuracy = settings.d_bar_accuracy =
            settings.d_bar_high_resolution_accuracy = {0.0, 0.0};
        point(0.0, 100.0);
    }

    void point(double ha_gon, double va_gon) {
        pointing->place({core::Angle::fromGon(ha_gon), core::Angle::fromGon(va_gon)});
    }
    geometry::Pointing truth() const { return pointing->at(clock.now()); }

    /// Made at first use, so that a test may change the settings before.
    Station& station() {
        if (!station_) {
            station_ = std::make_unique<Station>(settings, threeWalls(), pointing, clock);
            station_->send = [this](std::string_view bytes) { heard_ += bytes; };
        }
        return *station_;
    }
    void inject(const char* fault) {
        const auto outcome = station().injectFault(QString::fromLatin1(fault));
        ASSERT_TRUE(outcome.has_value()) << outcome.error().sentence().toStdString();
    }

    /// Everything the station has said since the last call.
    std::string heard() { return std::exchange(heard_, {}); }
    /// Sends a command and gives what comes back within `span`.
    std::string ask(std::string_view command, core::Duration span = {}) {
        station().receive(std::string(command) + '\r');
        clock.advance(span);
        return heard();
    }

    core::VirtualClock clock;
    StationSettings settings;
    std::shared_ptr<TruePointing> pointing = std::make_shared<TruePointing>();

private:
    std::string heard_;
    std::unique_ptr<Station> station_;
};

}  // namespace pmts::simulator
