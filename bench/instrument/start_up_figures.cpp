#include "start_up_figures.hpp"

#include "pmts/camera/scaled_rig.hpp"
#include "pmts/instrument/bus_driver.hpp"
#include "pmts/simulator/bus_simulation.hpp"
#include "pmts/simulator/scene_camera.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "pmts/transport/serial_link.hpp"
#include "pmts/video/video_source.hpp"
#include "support/figure.hpp"

#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>

#include <atomic>
#include <cstdio>

namespace pmts::bench {
namespace {

constexpr int kStarts = 1000, kStartsWithoutGate = 300;
constexpr int kSteps = 6;
constexpr double kTimeScale = 4.0;           ///< the base and its line run four times as fast, the host and its video do not
constexpr double kFailurePerFrame = 0.1;     ///< the injected sensitivity: of a step, for each frame drawn during it
constexpr double kFailurePerLateSecond = 1.0;  ///< beyond 125 ms between a reply and the next command
constexpr core::Duration kBetweenStarts = std::chrono::milliseconds(40);  ///< the video goes on
constexpr int kWidth_px = 1920, kHeight_px = 1080;

/// The base on a thread and a pty of its own.
class Base {
public:
    explicit Base(const std::atomic<std::uint64_t>& frames) {
        simulator::BusSimulationSettings settings;
        settings.station.time_scale = kTimeScale;
        settings.station.start_up.steps = kSteps;
        settings.station.start_up.failure_per_frame = kFailurePerFrame;
        settings.station.start_up.failure_per_late_second = kFailurePerLateSecond;
        worker_.moveToThread(&thread_);
        thread_.start(QThread::HighPriority);
        QMetaObject::invokeMethod(
            &worker_,
            [&] {
                simulation_ = std::move(simulator::BusSimulation::start(settings, clock_).value());
                simulation_->station().frames_of_host = [&frames] { return frames.load(); };
                name_ = simulation_->slaveName();
            },
            Qt::BlockingQueuedConnection);
    }
    ~Base() {
        QMetaObject::invokeMethod(&worker_, [this] { simulation_.reset(); }, Qt::BlockingQueuedConnection);
        thread_.quit();
        thread_.wait();
    }
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;

    [[nodiscard]] const QString& name() const { return name_; }

private:
    QThread thread_;
    QObject worker_;
    core::SystemClock clock_;
    std::unique_ptr<simulator::BusSimulation> simulation_;
    QString name_;
};

/// The town square, drawn at full HD as the live view wants it; each frame that is begun is counted.
video::FramePainter painterThatCounts(std::atomic<std::uint64_t>& frames) {
    const auto scene = std::make_shared<const simulator::Scene>(simulator::Scene::townSquare(1));
    const auto pointing = std::make_shared<simulator::TruePointing>();
    const auto camera = std::make_shared<simulator::SceneCamera>(
        scene, pointing, camera::scaledRig(simulator::simulatedRig({}), kWidth_px, kHeight_px), simulator::CameraFaults{});
    return [camera, &frames](core::Duration captured_at) {
        ++frames;
        return camera->draw(captured_at);
    };
}

protocol::TableRoutine startUp() {
    std::string text = "routine start_up\n";
    for (int i = 1; i <= kSteps; ++i) {
        text += "send PV,30=" + std::to_string(i) + "\nexpect 240.8\nfail 248.8\nwithin 2\ntime_critical\n";
    }
    return protocol::readInstructionTable(text).routines.at(0);
}

core::Task<void> startAgainAndAgain(instrument::InstructionRunner& runner, core::Clock& clock, int starts, int& succeeded,
                                    QEventLoop& loop) {
    const auto routine = startUp();
    for (int i = 0; i < starts; ++i) {
        auto starting = runner.run(routine, {}, {});
        const auto outcome = co_await starting;
        succeeded += outcome ? 1 : 0;
        auto pausing = core::sleepFor(clock, kBetweenStarts);
        (void)co_await pausing;
    }
    loop.quit();
}

struct Run {
    double percent = 0.0;
    double frames_per_start = 0.0;
    std::uint64_t pauses = 0;
};

/// `gate_of_video`: the one that the camera looks at; the scheduler closes `gate`.
Run run(int starts, core::VideoGate& gate, core::VideoGate& gate_of_video) {
    std::atomic<std::uint64_t> frames = 0;
    const Base base(frames);
    core::SystemClock clock;
    const auto source = video::makeSimulatedSource(painterThatCounts(frames), gate_of_video);
    source->start({.size = {kWidth_px, kHeight_px}, .rate_hz = 30.0, .pixel_format = QStringLiteral("BGR")});
    transport::SerialLink link({.port_name = base.name()});
    if (const auto opened = link.open(); !opened) {
        std::fprintf(stderr, "%s\n", opened.error().sentence().toLocal8Bit().constData());
        return {};
    }
    scheduler::Scheduler line(link, clock, gate);
    instrument::BusDriver driver(line, clock);
    instrument::InstructionRunner runner(line, clock);
    QEventLoop loop;
    int succeeded = 0;
    [[maybe_unused]] const auto running = startAgainAndAgain(runner, clock, starts, succeeded, loop);
    loop.exec();
    source->stop();
    return {.percent = 100.0 * succeeded / starts,
            .frames_per_start = static_cast<double>(frames) / starts,
            .pauses = gate.statistics().pauses};
}

}  // namespace

void startUpFigures() {
    core::VideoGate gate, unused, never_closed;
    const Run with_gate = run(kStarts, gate, gate);
    const Run without = run(kStartsWithoutGate, unused, never_closed);
    std::printf("# %d starts of %d steps, 1080p drawn at 30 Hz, a step fails for %g %% of the frames begun during it\n", kStarts,
                kSteps, 100.0 * kFailurePerFrame);
    std::printf("# with the gate: %.2f frames a start, %llu pauses; without it: %d starts, %.2f frames a start\n",
                with_gate.frames_per_start, static_cast<unsigned long long>(with_gate.pauses), kStartsWithoutGate,
                without.frames_per_start);
    figure("instrument.start_up_with_gate", with_gate.percent, "%", Wanted::kAtLeast, 100);
    figure("instrument.start_up_without_gate", without.percent, "%", Wanted::kAtMost, 99);
}

}  // namespace pmts::bench
