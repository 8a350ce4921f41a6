#include "mjpeg_live.hpp"

#include "pmts/video/video_source.hpp"
#include "support/figure.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTimer>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

namespace pmts::bench {
namespace {

constexpr int kPictures = 30;

double processSeconds() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) + static_cast<double>(spent.tv_nsec) * 1e-9;
}

/// Full HD pictures with as much detail as a street: about 400 kB each.
void writePictures(const QString& folder) {
    cv::RNG random(7);
    cv::Mat coarse(135, 240, CV_8UC3), picture;
    random.fill(coarse, cv::RNG::UNIFORM, 30, 220);
    cv::resize(coarse, picture, {1920, 1080}, 0, 0, cv::INTER_CUBIC);
    for (int i = 0; i < kPictures; ++i) {
        cv::Mat moved = picture.clone();
        cv::circle(moved, {60 + i * 60, 540}, 40, cv::Scalar(0, 0, 255), cv::FILLED);
        cv::imwrite(QStringLiteral("%1/%2.jpg").arg(folder).arg(i).toStdString(), moved, {cv::IMWRITE_JPEG_QUALITY, 90});
    }
}

/// Latencies of the run's first and last tenth tell whether anything piles up.
double growth(const std::vector<double>& latency_ms) {
    const std::size_t tenth = std::max<std::size_t>(1, latency_ms.size() / 10);
    return median({latency_ms.end() - static_cast<std::ptrdiff_t>(tenth), latency_ms.end()}) -
           median({latency_ms.begin(), latency_ms.begin() + static_cast<std::ptrdiff_t>(tenth)});
}

}  // namespace

void mjpegLive(double minutes) {
    const QTemporaryDir folder, pictures;
    writePictures(pictures.path());
    qputenv("PMTS_VIRTUAL_CAMERAS", folder.path().toUtf8());
    QFile camera(folder.filePath(QStringLiteral("video0")));
    if (!camera.open(QIODevice::WriteOnly)) {
        return;
    }
    camera.write("card=Bench camera\njpeg=" + pictures.path().toUtf8() + "\n");
    camera.close();

    core::VideoGate gate;
    const auto source = video::makeVideoSource(
        {video::SourceKind::kV4l2, camera.fileName(), QStringLiteral("Bench camera")}, gate);
    std::vector<double> latency_ms;
    QObject::connect(source.get(), &video::VideoSource::frameReady, source.get(), [&] {
        const auto age = core::SystemClock().now() - source->newestFrame()->captured_at;
        latency_ms.push_back(std::chrono::duration<double, std::milli>(age).count());
    });
    const double before_s = processSeconds();
    const core::Duration started = core::SystemClock().now();
    source->start({.size = {1920, 1080}, .rate_hz = 30.0, .pixel_format = QStringLiteral("MJPG")});
    QTimer::singleShot(static_cast<int>(minutes * 60'000.0), qApp, &QCoreApplication::quit);
    QCoreApplication::exec();
    const double cores = (processSeconds() - before_s) /
                         std::chrono::duration<double>(core::SystemClock().now() - started).count();
    const video::SourceStatistics seen = source->statistics();
    source->stop();

    std::printf("# 1920x1080 Motion-JPEG at 30 Hz through a virtual V4L2 camera for %.2g minutes, %zu frames\n", minutes,
                latency_ms.size());
    if (latency_ms.empty()) {
        return;
    }
    figure("camera.hd_mjpeg_rate", seen.measured_rate_hz, "Hz", Wanted::kAtLeast, 29.5);
    figure("camera.hd_mjpeg_lost_frames", static_cast<double>(seen.lost), "frames", Wanted::kAtMost, 0);
    figure("camera.hd_mjpeg_latency_median", median(latency_ms), "ms", Wanted::kAtMost, 33);
    figure("camera.hd_mjpeg_latency_growth", std::max(0.0, growth(latency_ms)), "ms", Wanted::kAtMost, 1);
    figure("camera.hd_mjpeg_cores", cores, "cores", Wanted::kAtMost, 1);
}

}  // namespace pmts::bench
