// Live view without a window: a simulated source whose painter returns a frame drawn before, and a receiver
// that takes each frame on this thread. What it costs is the delivery alone. Options: --minutes N (0.5).
#include "pmts/video/video_source.hpp"
#include "scene_draw.hpp"
#include "support/figure.hpp"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTimer>

#include <cstdio>
#include <ctime>
#include <vector>

namespace {

using namespace pmts;

double processSeconds() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) + static_cast<double>(spent.tv_nsec) * 1e-9;
}

double minutesWanted(const QCoreApplication& app) {
    QCommandLineParser parser;
    const QCommandLineOption minutes(QStringLiteral("minutes"), QStringLiteral("Length of the run."),
                                     QStringLiteral("N"), QStringLiteral("0.5"));
    parser.addOption(minutes);
    parser.process(app);
    return parser.value(minutes).toDouble();
}

/// What a live view sees during the run.
struct LiveRun {
    std::vector<double> latency_ms;
    std::uint64_t missed = 0;
    std::uint64_t last_sequence = 0;

    void take(const camera::FramePtr& frame) {
        const auto age = core::SystemClock().now() - frame->captured_at;
        latency_ms.push_back(std::chrono::duration<double, std::milli>(age).count());
        if (latency_ms.size() > 1) {
            missed += frame->sequence - last_sequence - 1;
        }
        last_sequence = frame->sequence;
    }
};

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const double minutes = minutesWanted(app);
    const cv::Mat picture(720, 1280, CV_8UC3, cv::Scalar::all(110));
    core::VideoGate gate;
    const auto source = video::makeSimulatedSource(
        [picture](core::Duration) {
            camera::Frame frame;
            frame.image = picture;
            return frame;
        },
        gate);
    LiveRun run;
    QObject::connect(source.get(), &video::VideoSource::frameReady, [&] { run.take(source->newestFrame()); });

    const double before_s = processSeconds();
    const core::Duration started = core::SystemClock().now();
    source->start({});
    QTimer::singleShot(static_cast<int>(minutes * 60'000.0), &app, &QCoreApplication::quit);
    QCoreApplication::exec();
    const double busy_s = processSeconds() - before_s;
    const double span_s = std::chrono::duration<double>(core::SystemClock().now() - started).count();
    source->stop();

    std::printf("# live view for %.2g minutes, %zu frames\n", minutes, run.latency_ms.size());
    bench::figure("video.live_lost_frames", static_cast<double>(run.missed), "frames", bench::Wanted::kAtMost,
                  0);
    bench::figure("video.live_rate", static_cast<double>(run.latency_ms.size()) / span_s, "Hz",
                  bench::Wanted::kAtLeast, 29.5);
    bench::figure("video.capture_to_delivery_median", bench::median(run.latency_ms), "ms",
                  bench::Wanted::kAtMost, 10);
    bench::figure("video.delivery_cpu", 100.0 * busy_s / span_s, "%", bench::Wanted::kAtMost, 5);
    bench::sceneDraw();
    return 0;
}
