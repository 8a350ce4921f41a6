#include "pmts/core/virtual_clock.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/simulator/station.hpp"
#include "pmts/transport/memory_link.hpp"
#include "start_up_figures.hpp"
#include "support/figure.hpp"

#include <QCoreApplication>

#include <cmath>
#include <cstdlib>

// Turn, measure, record over the simulated instrument, in its own time, against the time its motors, its
// distance meter and the wire need by themselves. That time is computed here from the settings and the
// shortest exchange that could do it.
namespace {

using namespace std::chrono_literals;
using pmts::core::Angle;
using pmts::geometry::Pointing;

constexpr int kCycles = 60;

pmts::simulator::Scene yard() {
    const auto wall = [](Eigen::Vector3d origin_m, Eigen::Vector3d right_m) {
        return pmts::simulator::Panel{.name = QStringLiteral("wall"),
                                      .origin_m = origin_m,
                                      .right_m = right_m,
                                      .up_m = {0, 0, 60},
                                      .texture = cv::Mat(4, 4, CV_8UC3, cv::Scalar(90, 90, 90)),
                                      .absorbing = false};
    };
    return pmts::simulator::Scene({wall({-60, 20, -30}, {120, 0, 0}), wall({30, 60, -30}, {0, -120, 0})});
}

struct Bench {
    explicit Bench(pmts::simulator::StationSettings settings)
        : wire(pmts::transport::makeMemoryPair(clock)),
          station(settings, scene, truth, clock),
          line(*wire.first, clock, gate),
          driver(line, clock) {
        wire.second->on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { wire.second->write(bytes); };
        if (!wire.first->open() || !wire.second->open()) {
            std::exit(1);
        }
    }

    /// The value; the bench ends when there is none.
    template <class T>
    T run(pmts::core::Task<pmts::core::Result<T>> task) {
        const auto outcome = std::make_shared<std::optional<pmts::core::Result<T>>>();
        auto running = [](auto work, auto kept) -> pmts::core::Task<void> { *kept = co_await work; }(
                                                    std::move(task), outcome);
        pmts::core::deliverQueuedEvents();
        while (!outcome->has_value() && clock.advanceToNextTimer(clock.now() + 10min)) {
            pmts::core::deliverQueuedEvents();
        }
        if (!outcome->has_value() || !outcome->value()) {
            std::fprintf(stderr, "%s\n",
                         outcome->has_value() ? outcome->value().error().sentence().toUtf8().constData()
                                              : "no answer");
            std::exit(1);
        }
        if constexpr (!std::is_void_v<T>) {
            return *outcome->value();
        }
    }

    pmts::core::VirtualClock clock;
    pmts::core::VideoGate gate;
    std::shared_ptr<const pmts::simulator::Scene> scene =
        std::make_shared<const pmts::simulator::Scene>(yard());
    std::shared_ptr<pmts::simulator::TruePointing> truth = std::make_shared<pmts::simulator::TruePointing>();
    pmts::transport::MemoryPair wire;
    pmts::simulator::Station station;
    pmts::scheduler::Scheduler line;
    pmts::instrument::GeodimeterDriver driver;
};

/// Both axes at once: accelerate, cruise, brake, settle.
double motorSeconds(const pmts::simulator::StationSettings& settings, const Pointing& from,
                    const Pointing& to) {
    const auto axis = [&](double gon) {
        const double ramps_gon = settings.speed_gon_s * settings.speed_gon_s / settings.acceleration_gon_s2;
        return gon <= ramps_gon
                   ? 2.0 * std::sqrt(gon / settings.acceleration_gon_s2)
                   : gon / settings.speed_gon_s + settings.speed_gon_s / settings.acceleration_gon_s2;
    };
    const double ha = axis(std::abs(pmts::core::normalizedSigned(to.ha - from.ha).gon()));
    const double va = axis(std::abs((to.va - from.va).gon()));
    return std::max(ha, va) + std::chrono::duration<double>(settings.settle).count();
}

/// The seven exchanges nobody can do without: two targets, the motion, both circles, the trigger, the
/// measurement.
double wireSeconds(const pmts::simulator::StationSettings& settings) {
    const std::size_t bytes = std::string_view(
                                  "WG,26=96.1684\r>"
                                  "WG,27=77.5612\r>"
                                  "WS=PH05V05\r>"
                                  "RG,7\r7=77.5612\r\n>"
                                  "RG,8\r8=96.1684\r\n>"
                                  "TG\r>"
                                  "RG\r0\r\n7=77.5612\r\n8=96.1684\r\n9=23.418\r\n>")
                                  .size();
    return static_cast<double>(bytes) * 10.0 / settings.baud;
}

double cycleRatio(pmts::instrument::EdmMode mode, pmts::core::Duration edm) {
    const pmts::simulator::StationSettings settings;
    Bench bench(settings);
    bench.run(bench.driver.connectTo({}));
    bench.run(bench.driver.setMode(mode));
    Pointing at{.ha = Angle(), .va = Angle::fromGon(100)};
    double needed_s = 0.0;
    const auto began_at = bench.clock.now();
    for (int i = 0; i < kCycles; ++i) {
        const Pointing target{.ha = Angle::fromGon(std::fmod(i * 37.0, 120.0)),
                              .va = Angle::fromGon(90.0 + i % 20)};
        needed_s += motorSeconds(settings, at, target) + std::chrono::duration<double>(edm).count() +
                    wireSeconds(settings);
        bench.run(bench.driver.turnTo(target, Angle::fromCc(5), {}));
        bench.run(bench.driver.measureDistance({}));
        at = target;
    }
    return std::chrono::duration<double>(bench.clock.now() - began_at).count() / needed_s;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const pmts::simulator::StationSettings settings;
    using pmts::bench::figure, pmts::bench::Wanted, pmts::instrument::EdmMode;
    figure("instrument.cycle_ratio", cycleRatio(EdmMode::kStd, settings.std_time), "x", Wanted::kAtMost,
           1.05);
    figure("instrument.cycle_ratio_fast_standard", cycleRatio(EdmMode::kFstd, settings.fast_std_time), "x",
           Wanted::kAtMost, 1.05);
    pmts::bench::startUpFigures();
    return 0;
}
