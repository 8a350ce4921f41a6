#include "qt_camera_device.hpp"
#include "support.hpp"
#include "worker_source.hpp"

#include <gmock/gmock.h>

#include <atomic>

namespace pmts::video {
namespace {

using namespace std::chrono_literals;
using Format = QVideoFrameFormat::PixelFormat;

const VideoFormat kWanted{.size = {1280, 720}, .rate_hz = 30.0};

TEST(QtCameraFormatTest, TheWantedSizeComesBeforeTheRate) {
    EXPECT_EQ(nearestFormat({{{640, 480}, 60, Format::Format_YUYV},
                             {{1280, 720}, 10, Format::Format_YUYV},
                             {{1920, 1080}, 30, Format::Format_YUYV}},
                            kWanted),
              1U);
}

TEST(QtCameraFormatTest, OfOneSizeTheFastEnoughOneIsTaken) {
    EXPECT_EQ(nearestFormat({{{1280, 720}, 10, Format::Format_YUYV}, {{1280, 720}, 30, Format::Format_Jpeg}}, kWanted),
              1U);
}

TEST(QtCameraFormatTest, PixelsThatCannotBeReadAreTheLastChoice) {
    EXPECT_EQ(nearestFormat({{{1280, 720}, 30, Format::Format_YUV420P}, {{640, 480}, 15, Format::Format_NV12}}, kWanted),
              1U);
    EXPECT_EQ(nearestFormat({{{1280, 720}, 30, Format::Format_YUV420P}}, kWanted), 0U);
}

TEST(QtCameraFormatTest, NoFormatOfferedIsNoChoice) { EXPECT_EQ(nearestFormat({}, kWanted), std::nullopt); }

/// A camera on Qt's side of the device, in the hands of the test.
struct HandCamera {
    std::atomic<bool> plugged{true};
    std::atomic<int> started{0};
    std::atomic<bool> runs{false};
    std::mutex mutex;
    QtCameraBackend::Listener listener;

    void show() {
        QVideoFrame frame(QVideoFrameFormat({8, 4}, Format::Format_BGRA8888));
        const std::lock_guard lock(mutex);
        if (runs) {
            listener.frame(frame);
        }
    }
    void fail(const QString& text) {
        const std::lock_guard lock(mutex);
        listener.error(text);
    }
};

class HandBackend final : public QtCameraBackend {
public:
    explicit HandBackend(std::shared_ptr<HandCamera> camera) : camera_(std::move(camera)) {}
    bool isPresent(const QString& description) override {
        return camera_->plugged && description == QStringLiteral("Webcam");
    }
    void start(const QString&, const VideoFormat&, Listener listener) override {
        const std::lock_guard lock(camera_->mutex);
        camera_->listener = std::move(listener);
        camera_->runs = true;
        ++camera_->started;
    }
    void stop() override {
        const std::lock_guard lock(camera_->mutex);
        camera_->runs = false;
    }

private:
    std::shared_ptr<HandCamera> camera_;
};

class QtCameraTest : public testing::Test {
protected:
    std::unique_ptr<CaptureDevice> device(const char* description = "Webcam") {
        return makeQtCameraDevice(QString::fromLatin1(description), std::make_unique<HandBackend>(camera));
    }
    std::shared_ptr<HandCamera> camera = std::make_shared<HandCamera>();
};

TEST_F(QtCameraTest, NewestFrameIsTakenAndOlderOnesAreAGapInTheCount) {
    const auto webcam = device();
    ASSERT_TRUE(webcam->open(kWanted).has_value());
    camera->show();
    const auto first = webcam->next(0ms);
    camera->show();
    camera->show();
    const auto newest = webcam->next(0ms);
    ASSERT_TRUE(first.has_value() && *first && newest.has_value() && *newest);
    EXPECT_EQ((*newest)->sequence, (*first)->sequence + 2);
    EXPECT_GE((*newest)->captured_at, (*first)->captured_at);
    EXPECT_EQ(webcam->picture().image.size(), cv::Size(8, 4));
    EXPECT_TRUE(webcam->picture().image.empty()) << "a picture is handed out once";
}

TEST_F(QtCameraTest, NoFrameWithinTheLimitIsNoError) {
    const auto webcam = device();
    ASSERT_TRUE(webcam->open(kWanted).has_value());
    const auto shot = webcam->next(1ms);
    ASSERT_TRUE(shot.has_value());
    EXPECT_FALSE(shot->has_value());
}

TEST_F(QtCameraTest, CameraThatIsNotThereSaysSoAndIsNotStarted) {
    const auto opened = device("Other")->open(kWanted);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().kind, core::ErrorKind::kCamera);
    EXPECT_TRUE(opened.error().happened.contains(QStringLiteral("Other is not connected")));
    EXPECT_EQ(camera->started, 0);
}

TEST_F(QtCameraTest, UnpluggedCameraIsNoticedWithTheFirstMissingFrame) {
    const auto webcam = device();
    ASSERT_TRUE(webcam->open(kWanted).has_value());
    camera->plugged = false;
    const auto shot = webcam->next(1ms);
    ASSERT_FALSE(shot.has_value());
    EXPECT_TRUE(shot.error().happened.contains(QStringLiteral("not connected")));
}

TEST_F(QtCameraTest, ErrorOfTheCameraEndsTheWaitWithItsWords) {
    const auto webcam = device();
    ASSERT_TRUE(webcam->open(kWanted).has_value());
    camera->fail(QStringLiteral("device busy"));
    const auto shot = webcam->next(20s);
    ASSERT_FALSE(shot.has_value());
    EXPECT_TRUE(shot.error().happened.contains(QStringLiteral("Webcam has stopped")));
    EXPECT_EQ(shot.error().detail, QStringLiteral("device busy"));
    ASSERT_TRUE(webcam->open(kWanted).has_value());
    camera->show();
    EXPECT_TRUE(webcam->next(0ms).has_value()) << "opened again, the error is forgotten";
}

TEST_F(QtCameraTest, SourceSurvivesUnpluggingAndAnError) {
    core::VideoGate gate;
    WorkerSource source(
        {SourceKind::kQtCamera, QStringLiteral("Webcam"), QStringLiteral("Webcam")}, [this] { return device(); },
        gate, {.silent_after = 60s, .reopen_every = 10ms, .abandon_after = 60s});
    const Watcher watcher(source);
    const auto runs = [&] {
        camera->show();
        return source.state() == SourceState::kRunning;
    };
    source.start(kWanted);
    ASSERT_TRUE(until(runs));
    camera->plugged = false;
    ASSERT_TRUE(until([&] { return source.state() == SourceState::kLost; }));
    camera->plugged = true;
    ASSERT_TRUE(until(runs));
    camera->fail(QStringLiteral("gone"));
    ASSERT_TRUE(until([&] { return source.state() == SourceState::kLost; }));
    ASSERT_TRUE(until(runs));
    EXPECT_TRUE(watcher.hasProblemWith("not connected"));
    EXPECT_TRUE(watcher.hasProblemWith("has stopped"));
}

}  // namespace
}  // namespace pmts::video
