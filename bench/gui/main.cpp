#include "field/field_workspace.hpp"
#include "field/image_view.hpp"
#include "field/live_panel.hpp"
#include "pmts/app/desk/workbench.hpp"
#include "pmts/gui/main_window.hpp"
#include "support/figure.hpp"
#include "support/thread_times.hpp"
#include "timeline_figures.hpp"

#include <QApplication>
#include <QEventLoop>
#include <QLoggingCategory>
#include <QPixmap>
#include <QTemporaryDir>
#include <QTimer>
#include <opencv2/core/utility.hpp>

#include <cstdio>

namespace {

using namespace std::chrono_literals;
using pmts::core::Duration;

constexpr Duration kWarmUp = 3s;  ///< connecting, first layout: not what the figures are about

double milliseconds(Duration span) { return std::chrono::duration<double, std::milli>(span).count(); }
double seconds(Duration span) { return std::chrono::duration<double>(span).count(); }

/// What reached the screen, frame by frame.
struct Painted {
    std::optional<Duration> first_at;
    std::vector<double> latency_ms;
    std::uint64_t first_sequence = 0;
    std::uint64_t last_sequence = 0;

    void add(const pmts::camera::Frame& frame, Duration now) {
        if (latency_ms.empty()) {
            first_sequence = frame.sequence;
        }
        last_sequence = frame.sequence;
        latency_ms.push_back(milliseconds(now - frame.captured_at));
    }
    [[nodiscard]] std::uint64_t missing() const {
        return last_sequence - first_sequence + 1 - latency_ms.size();
    }
};

/// Threads that are the simulator: they stand for the camera and the instrument.
const std::vector<std::string> kSimulator{"pmts-camera", "simulator"};

double minutesFrom(const QStringList& arguments) {
    const auto at = arguments.indexOf(QStringLiteral("--minutes"));
    return at >= 0 ? arguments.value(at + 1).toDouble() : 0.5;
}

void runFor(Duration span) {
    QEventLoop loop;  // quitting the application would close the window
    QTimer::singleShot(std::chrono::duration_cast<std::chrono::milliseconds>(span), &loop, &QEventLoop::quit);
    loop.exec();
}

double growthMs(const std::vector<double>& latency_ms) {
    const auto quarter = static_cast<std::ptrdiff_t>(latency_ms.size() / 4);
    const double before = pmts::bench::median({latency_ms.begin(), latency_ms.begin() + quarter});
    const double after = pmts::bench::median({latency_ms.end() - quarter, latency_ms.end()});
    return after - before;
}

/// What a paint costs more for recorded points in the picture, median.
double overlayMs(const pmts::core::Clock& clock, pmts::gui::ImageView& view, int points) {
    pmts::gui::ImageOverlay overlay;
    for (int i = 0; i < points; ++i) {
        overlay.points.push_back({QPointF(i * 37 % 1280, i * 91 % 720), QString::number(100 + i)});
    }
    std::vector<double> with_ms, without_ms;
    QPixmap target(view.size());
    for (int round = 0; round < 20; ++round) {
        for (auto* const took_ms : {&without_ms, &with_ms}) {
            view.setOverlay(took_ms == &with_ms ? overlay : pmts::gui::ImageOverlay{});
            const Duration from = clock.now();
            view.render(&target);
            took_ms->push_back(milliseconds(clock.now() - from));
        }
    }
    return pmts::bench::median(with_ms) - pmts::bench::median(without_ms);
}

/// Frames a second while the corners beside a resting cursor are looked for in each of them.
double rateWithSnap(const pmts::core::Clock& clock, pmts::app::Workbench& bench, pmts::gui::MainWindow& window,
                    Painted& painted) {
    pmts::gui::ImageView& view = window.field().live().view();
    bench.snap.setOn(true);
    Q_EMIT view.hovered(QPointF(view.frame()->image.cols, view.frame()->image.rows) / 3);
    painted = {};
    const Duration from = clock.now();
    runFor(5s);
    const double rate = static_cast<double>(painted.latency_ms.size()) / seconds(clock.now() - from);
    bench.snap.setOn(false);
    return rate;
}

}  // namespace

int main(int argc, char** argv) {
    const pmts::core::SystemClock clock;
    const Duration started_at = clock.now();
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && qEnvironmentVariableIsEmpty("DISPLAY")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false"));
    cv::setNumThreads(1);  // each thread's work stays on it: the simulator's drawing can be told from ours

    if (QCoreApplication::arguments().contains(QStringLiteral("--timeline"))) {  // these alone
        timelineFigures();
        return 0;
    }
    const QTemporaryDir folder;
    pmts::app::StartOptions options;
    options.data_folder = folder.path();
    options.force_simulated = true;
    pmts::app::Workbench bench(options);
    pmts::gui::MainWindow window(bench);
    window.setWindowState(Qt::WindowNoState);
    window.resize(1440, 900);

    Painted painted;
    std::optional<Duration> first_frame_at;
    QObject::connect(&window.field().live().view(), &pmts::gui::ImageView::framePainted, &window,
                     [&](const pmts::camera::FramePtr& frame) {
                         first_frame_at = first_frame_at.value_or(clock.now());
                         painted.add(*frame, clock.now());
                     });
    window.show();
    bench.start();
    runFor(kWarmUp);

    painted = {};
    const auto gate_before = bench.gate.statistics();
    const double cpu_before_s = pmts::bench::cpuSecondsWithout(kSimulator);
    const Duration from = clock.now();
    runFor(std::chrono::duration_cast<Duration>(
        std::chrono::duration<double>(minutesFrom(QCoreApplication::arguments()) * 60.0)));
    const double took_s = seconds(clock.now() - from);
    const double cpu_s = pmts::bench::cpuSecondsWithout(kSimulator) - cpu_before_s;
    const auto dropped = bench.gate.statistics().frames_dropped - gate_before.frames_dropped;
    if (painted.latency_ms.size() < 40 || !first_frame_at) {
        std::fprintf(stderr, "the live view showed only %zu frames\n", painted.latency_ms.size());
        return 1;
    }

    using pmts::bench::figure;
    using pmts::bench::Wanted;
    figure("gui.start_to_first_frame", seconds(*first_frame_at - started_at), "s", Wanted::kAtMost, 1.5);
    figure("gui.live_rate", static_cast<double>(painted.latency_ms.size()) / took_s, "1/s", Wanted::kAtLeast,
           29.0);
    figure("gui.live_cpu_share", 100.0 * cpu_s / took_s, "%", Wanted::kAtMost, 40.0);
    figure("gui.live_lost_frames",
           static_cast<double>(painted.missing() - std::min(painted.missing(), dropped)), "frames",
           Wanted::kAtMost, 0.0);
    figure("gui.camera_to_paint_median", pmts::bench::median(painted.latency_ms), "ms", Wanted::kAtMost,
           50.0);
    figure("gui.camera_to_paint_growth", growthMs(painted.latency_ms), "ms", Wanted::kAtMost, 5.0);
    figure("gui.overlay_of_200_points", overlayMs(clock, window.field().live().view(), 200), "ms",
           Wanted::kAtMost, 8.0);
    figure("gui.live_rate_with_snap", rateWithSnap(clock, bench, window, painted), "1/s", Wanted::kAtLeast, 29.0);
    figure("gui.resident_memory", pmts::bench::residentMemoryMb(), "MB", Wanted::kAtMost, 300.0);
    window.hide();
    bench.instrument.disconnectInstrument();
    bench.live.setSource(nullptr);
    timelineFigures();
}
