// Qt Multimedia from end to end: a camera that its own backend finds, opens and loses. The cameras are virtual
// (tests/support/virtual_gst); everything between them and the source is Qt's and ours.
#include "support.hpp"
#include "worker_source.hpp"

#include <QFile>
#include <QMediaDevices>
#include <gmock/gmock.h>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;

constexpr WorkerTimes kQuick{.silent_after = 1500ms, .reopen_every = 100ms, .abandon_after = 4s};

/// The text file that the virtual cameras come from.
class CameraList {
public:
    CameraList() {
        static QTemporaryDir folder;  // GStreamer asks for as long as the program lives
        path_ = folder.filePath(QStringLiteral("cameras"));
        qputenv("PMTS_VIRTUAL_GST", path_.toUtf8());
        plug({});
    }
    void plug(const QByteArray& text) const {
        QSaveFile file(path_);
        file.open(QIODevice::WriteOnly);
        file.write(text);
        file.commit();
    }

private:
    QString path_;
};

const QByteArray kWebcam =
    "Bench webcam|videotestsrc is-live=true pattern=smpte ! video/x-raw,format=YUY2,width=640,height=480,framerate=30/1 ! queue|"
    "video/x-raw,format=(string)YUY2,width=640,height=480,framerate=30/1\n";
const SourceAddress kAddress{SourceKind::kQtCamera, QStringLiteral("Bench webcam"), QStringLiteral("Bench webcam")};

bool isListed() {
    const std::vector<SourceAddress> cameras = presentCameras();
    return std::count(cameras.begin(), cameras.end(), kAddress) == 1;
}

/// One process, one life of Qt's backend: steps of one story, each asserted.
TEST(QtCameraPathTest, CameraIsListedShownLostWhenUnpluggedAndBackByItself) {
    const CameraList list;
    // Plugged in while the program runs: Qt 6.4 lists a camera that was there at its start twice and forgets one only.
    ASSERT_FALSE(isListed());
    list.plug(kWebcam);
    ASSERT_TRUE(until([] { return isListed(); }));

    core::VideoGate gate;
    WorkerSource source(kAddress, [] { return makeQtCameraDevice(kAddress.name); }, gate, kQuick);
    Watcher seen(source);
    source.start({.size = {640, 480}});
    ASSERT_TRUE(until([&] { return seen.newest && source.statistics().delivered > 5; }));
    EXPECT_EQ(seen.newest->image.size(), cv::Size(640, 480));
    // The left bar of the test picture is light, the one at the right of the upper part blue.
    const cv::Vec3b left = seen.newest->image.at<cv::Vec3b>(100, 40), right = seen.newest->image.at<cv::Vec3b>(100, 600);
    EXPECT_GT(left[1], 150);
    EXPECT_GT(right[0], right[2] + 80);
    EXPECT_EQ(source.report().format.size, QSize(640, 480));
    EXPECT_EQ(source.report().formats.size(), 1U);
    EXPECT_TRUE(source.report().controls.empty()) << "this backend lets nothing be set, and says so";

    source.pause();
    ASSERT_TRUE(until([&] { return source.state() == SourceState::kPaused; }));
    source.resume();
    ASSERT_TRUE(until([&] { return source.state() == SourceState::kRunning; }));

    list.plug({});
    ASSERT_TRUE(until([&] { return source.state() == SourceState::kLost; }));
    EXPECT_TRUE(until([&] { return seen.hasProblemWith("Bench webcam is not connected."); }));
    list.plug(kWebcam);
    EXPECT_TRUE(until([&] { return source.state() == SourceState::kRunning; }));
}

}  // namespace
}  // namespace pmts::video
