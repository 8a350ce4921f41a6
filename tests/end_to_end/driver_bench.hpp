#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/simulator/station.hpp"
#include "pmts/transport/memory_link.hpp"
#include "support/matchers.hpp"
#include "support/run_to_end.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace pmts::end_to_end {

using namespace std::chrono_literals;
using core::Angle;
using core::ErrorKind;
using simulator::StationSettings;

/// Two walls of a yard, 20 m to the north and 30 m to the east, and a black absorbing one to the south.
inline simulator::Scene yard() {
    const auto wall = [](const char* name, Eigen::Vector3d origin, Eigen::Vector3d right, bool absorbing) {
        return simulator::Panel{.name = QString::fromLatin1(name),
                                .origin_m = origin,
                                .right_m = right,
                                .up_m = {0, 0, 30},
                                .texture = cv::Mat(4, 4, CV_8UC3, cv::Scalar(90, 90, 90)),
                                .absorbing = absorbing};
    };
    return simulator::Scene({wall("north", {-30, 20, -15}, {60, 0, 0}, false),
                             wall("east", {30, 30, -15}, {0, -60, 0}, false),
                             wall("south", {30, -12, -15}, {-60, 0, 0}, true)});
}

/// Painting its sky takes a tenth of a second: once for all tests.
inline std::shared_ptr<const simulator::Scene> sharedYard() {
    static const auto scene = std::make_shared<const simulator::Scene>(yard());
    return scene;
}

/// An instrument that differs in one setting: `with(&StationSettings::end_mark, 35)`.
template <class Value, class Given>
simulator::StationSettings with(Value simulator::StationSettings::*field, Given value) {
    simulator::StationSettings settings;
    settings.*field = value;
    return settings;
}

/// The driver and the simulated instrument at both ends of a line in memory, on one virtual clock. The
/// simulator was written from the protocol page alone: what agrees here agrees for that reason.
class DriverBench {
public:
    explicit DriverBench(simulator::StationSettings station_settings = {},
                         transport::MemoryPairSettings line_settings = {},
                         instrument::GeodimeterSettings profile = {})
        : wire(transport::makeMemoryPair(clock, line_settings)),
          station(station_settings, scene, truth, clock),
          line(*wire.first, clock, gate),
          driver(line, clock, std::move(profile)) {
        wire.second->on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { wire.second->write(bytes); };
        EXPECT_TRUE(wire.second->open().has_value());
        EXPECT_TRUE(wire.first->open().has_value());
    }

    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task, core::Duration limit = 10min) {
        auto outcome = test::runToEnd(std::move(task), clock, limit);
        if (!outcome) {
            ADD_FAILURE() << "the driver never answered";
            return core::fail(ErrorKind::kTimeOut, QStringLiteral("the driver never answered"));
        }
        return *outcome;
    }
    void connect() { ASSERT_TRUE(run(driver.connectTo({})).has_value()); }
    void fault(const char* name) {
        ASSERT_TRUE(station.injectFault(QString::fromLatin1(name)).has_value()) << name;
    }
    core::Result<geometry::Pointing> turn(double ha_gon, double va_gon) {
        return run(driver.turnTo({.ha = Angle::fromGon(ha_gon), .va = Angle::fromGon(va_gon)},
                                 Angle::fromCc(5), {}));
    }
    core::Result<instrument::DistanceShot> measure() { return run(driver.measureDistance({})); }

    /// A shot against the truth of the scene at this moment: five sigma of the distance meter and of the
    /// circles.
    [[nodiscard]] testing::AssertionResult isRight(const instrument::DistanceShot& shot) const {
        const auto pointing = truth->at(clock.now());
        const auto echo = scene->echo(pointing);
        if (!echo) {
            return testing::AssertionFailure() << "there is nothing to measure to";
        }
        const double off_m = shot.slope_distance_m - echo->distance_m;
        const Angle off_ha = core::normalizedSigned(shot.pointing.ha - pointing.ha);
        const Angle off_va = core::normalizedSigned(shot.pointing.va - pointing.va);
        const bool right = std::abs(off_m) <= 5 * 0.0032 && core::abs(off_ha) <= Angle::fromCc(16) &&
                           core::abs(off_va) <= Angle::fromCc(16);
        return right ? testing::AssertionSuccess()
                     : testing::AssertionFailure()
                           << "SD off by " << off_m << " m, HA by " << off_ha.cc() << " cc, VA by "
                           << off_va.cc() << " cc; " << shot.raw_reply.toStdString();
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    std::shared_ptr<const simulator::Scene> scene = sharedYard();
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    transport::MemoryPair wire;
    simulator::Station station;
    scheduler::Scheduler line;
    instrument::GeodimeterDriver driver;
};

}  // namespace pmts::end_to_end
