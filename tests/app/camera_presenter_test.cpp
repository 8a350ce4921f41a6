#include "app/field_fixture.hpp"

#include "pmts/app/lab/camera_presenter.hpp"
#include "pmts/app/field/photo_circumstances.hpp"
#include "pmts/camera/rig_json.hpp"

#include <QJsonDocument>
#include <QSignalSpy>

namespace pmts::app {
namespace {

using video::CameraControl;
using video::SourceState;

/// A webcam in the hands of the test: modes and controls as a driver would tell them.
class HandWebcam : public HandSource {
public:
    explicit HandWebcam(const char* name = "Webcam") : HandSource(video::SourceKind::kV4l2), name_(name) {
        report_.formats = {{{640, 480}, 30.0, QStringLiteral("YUYV")},  {{1280, 720}, 30.0, QStringLiteral("YUYV")},
                           {{1280, 720}, 10.0, QStringLiteral("YUYV")}, {{1280, 720}, 30.0, QStringLiteral("MJPG")},
                           {{1920, 1080}, 5.0, QStringLiteral("MJPG")}};
        report_.controls = {{{CameraControl::kExposure, 0.5, 100.0, 0.5, 10.0, true, true}, {CameraControl::kExposure, true, 12.5}},
                            {{CameraControl::kGain, 0.0, 255.0, 1.0, 16.0, false, true}, {CameraControl::kGain, false, 16.0}}};
    }
    video::SourceAddress address() const override {
        return {.kind = video::SourceKind::kV4l2, .location = QStringLiteral("/dev/video0"), .name = QString::fromLatin1(name_)};
    }
    void start(const video::VideoFormat& wanted) override {
        started.push_back(wanted);
        report_.format = wanted;
        setState(SourceState::kRunning);
        Q_EMIT reportChanged();
    }
    void pause() override { setState(SourceState::kPaused); }
    void resume() override { setState(SourceState::kRunning); }
    void setControls(const std::vector<video::ControlValue>& wishes) override {
        asked = wishes;
        for (const video::ControlValue& wish : wishes) {
            for (video::CameraControlState& control : report_.controls) {
                if (control.range.control == wish.control) {
                    const double held = control.value.value;
                    control.value = allowed(control.range, wish);
                    control.value.automatic = control.value.automatic && !wish.hold;
                    control.value.value = wish.hold ? held : control.value.value;
                    control.value.hold = false;
                }
            }
        }
        Q_EMIT reportChanged();
    }
    void takeStill(const video::VideoFormat& mode) override { stills.push_back(mode); }
    video::DeviceReport report() const override { return report_; }

    std::vector<video::VideoFormat> started;
    std::vector<video::VideoFormat> stills;
    std::vector<video::ControlValue> asked;

private:
    const char* name_;
    video::DeviceReport report_;
};

class CameraPresenterTest : public FieldTest {
protected:
    CameraPresenterTest() { plug(); }
    void plug(const char* name = "Webcam") {
        webcam = new HandWebcam(name);
        live.setSource(std::unique_ptr<video::VideoSource>(webcam));
    }
    ControlRow row(std::size_t index) const { return page.controls().at(index); }

    HandWebcam* webcam = nullptr;
    CameraPresenter page{live, preferences, messages, Threading::kCallersThread};
};

TEST_F(CameraPresenterTest, OffersWhatTheCameraOffersLargestFirst) {
    EXPECT_EQ(page.sizes(), (std::vector<QSize>{{1920, 1080}, {1280, 720}, {640, 480}}));
    EXPECT_EQ(page.pixelFormats({1280, 720}), QStringList({QStringLiteral("YUYV"), QStringLiteral("MJPG")}));
    EXPECT_EQ(page.rates({1280, 720}, QStringLiteral("YUYV")), (std::vector{30.0, 10.0}));
    EXPECT_TRUE(page.sentence().contains(QStringLiteral("1280x720")));
}

TEST_F(CameraPresenterTest, ChosenFormatIsUsedAtOnceAndKeptForThisCamera) {
    page.setFormat({{640, 480}, 30.0, QStringLiteral("YUYV")});
    EXPECT_EQ(webcam->started.back().size, QSize(640, 480));
    plug("Another camera");
    EXPECT_EQ(webcam->started.back().size, QSize(1280, 720)) << "another camera has its own";
    plug();
    EXPECT_EQ(webcam->started.back().size, QSize(640, 480)) << "back after a replug or a restart";
}

TEST_F(CameraPresenterTest, RigFollowsTheMode) {
    Settings settings = preferences.settings();
    settings.rig_profiles.push_back({.name = QStringLiteral("Webcam rig"), .rig = simulatedRigProfile().rig});
    settings.rig_profile = QStringLiteral("Webcam rig");
    preferences.set(settings);
    const double f_px = live.model().rig().lens.focalLengthPx();
    page.setFormat({{640, 480}, 30.0, QStringLiteral("YUYV")});
    EXPECT_EQ(live.model().rig().width_px, 640);
    EXPECT_NEAR(live.model().rig().lens.focalLengthPx(), f_px * 480.0 / 720.0, 1e-9);
    EXPECT_FALSE(page.rigNote().isEmpty()) << "a rig of another size is said to be converted";
}

TEST_F(CameraPresenterTest, ManualValueIsKeptAndSetAgainAfterAReplug) {
    page.setValue(CameraControl::kGain, 77.4);
    EXPECT_EQ(row(1).value.value, 77.0) << "on a step";
    plug();
    EXPECT_EQ(row(1).value.value, 77.0);
    plug("Another camera");
    EXPECT_EQ(row(1).value.value, 16.0);
}

TEST_F(CameraPresenterTest, LockStopsEveryAutomaticAtItsValueAndKeepsIt) {
    ASSERT_TRUE(page.canLock());
    page.lock();
    EXPECT_FALSE(page.canLock());
    EXPECT_EQ(row(0).value.value, 12.5);
    plug();
    EXPECT_EQ(row(0).value.value, 12.5);
    EXPECT_FALSE(row(0).value.automatic);
    page.setAutomatic(CameraControl::kExposure, true);
    EXPECT_TRUE(row(0).value.automatic);
}

TEST_F(CameraPresenterTest, WhatTheCameraDoesNotHaveIsAbsent) {
    ASSERT_EQ(page.controls().size(), 2U);
    EXPECT_EQ(row(0).name, QStringLiteral("Exposure"));
    EXPECT_EQ(row(0).text, QStringLiteral("12.5 ms, automatic"));
    EXPECT_EQ(row(1).limits, QStringLiteral("0 to 255, usually 16"));
}

TEST_F(CameraPresenterTest, PauseKeepsTheCameraAndStopLetsItGo) {
    page.togglePause();
    EXPECT_TRUE(page.isPaused());
    EXPECT_EQ(live.cameraStatus().text, QStringLiteral("Webcam: paused"));
    page.togglePause();
    EXPECT_TRUE(page.isRunning());
    page.stop();
    EXPECT_FALSE(page.isRunning());
    page.start();
    EXPECT_TRUE(page.isRunning());
    EXPECT_EQ(webcam->started.size(), 2U) << "resuming is no new start";
}

TEST_F(CameraPresenterTest, CaptureWaitsWhileTheCameraIsPaused) {
    connectInstrument();
    webcam->show(clock.now());
    page.pause();
    QSignalSpy waiting(&live, &LivePresenter::captureWaiting);
    live.capture();
    pass(500ms);
    EXPECT_FALSE(live.still().has_value());
    EXPECT_TRUE(waiting.at(0).at(0).toString().contains(QStringLiteral("paused")));
}

TEST_F(CameraPresenterTest, BurntOutPictureIsAWarningWithARemedy) {
    page.setMetering(true);
    cv::Mat picture(720, 1280, CV_8UC3, cv::Scalar::all(120));
    picture(cv::Rect(0, 0, 1280, 20)) = cv::Scalar::all(255);  // 2.8 %
    webcam->show(clock.now(), picture);
    EXPECT_EQ(page.meters().exposure_text, QStringLiteral("2.8 % of the picture is burnt out: shorten the exposure."));
    EXPECT_EQ(page.meters().exposure_state, DeviceState::kWarning);
}

TEST_F(CameraPresenterTest, MaskMarksTheBurntPixelsOnRequestOnly) {
    page.setMetering(true);
    cv::Mat picture(720, 1280, CV_8UC3, cv::Scalar::all(120));
    picture(cv::Rect(100, 50, 10, 10)) = cv::Scalar::all(255);
    webcam->show(clock.now(), picture);
    EXPECT_TRUE(page.meters().burnt.isNull());
    page.setShowsBurnt(true);
    ASSERT_EQ(page.meters().burnt.size(), QSize(1280, 720));
    EXPECT_EQ(qGray(page.meters().burnt.pixel(105, 55)), 255);
    EXPECT_EQ(qGray(page.meters().burnt.pixel(95, 55)), 0);
}

TEST_F(CameraPresenterTest, NothingIsMeasuredWhileNobodyLooks) {
    QSignalSpy measured(&page, &CameraPresenter::metersChanged);
    webcam->show(clock.now());
    EXPECT_TRUE(measured.empty());
}

TEST_F(CameraPresenterTest, PhotoIsTakenInTheLargestModeAndShownInTheLiveSize) {
    connectInstrument();
    openJob();
    page.setFullStills(true);
    webcam->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
    QSignalSpy added(&job_desk, &JobDesk::photoAdded);
    live.capture();
    ASSERT_EQ(webcam->stills.size(), 1U);
    EXPECT_EQ(webcam->stills[0].size, QSize(1920, 1080));
    auto frame = std::make_shared<camera::Frame>();
    frame->image = cv::Mat(1080, 1920, CV_8UC3, cv::Scalar::all(90));
    frame->captured_at = clock.now();
    Q_EMIT webcam->stillTaken({frame, 400ms});
    pass(300ms);
    ASSERT_TRUE(live.still().has_value());
    EXPECT_EQ(live.still()->frame->image.size(), cv::Size(1280, 720));
    ASSERT_TRUE(until([&] { return !added.empty(); }));
    const auto photo = added.at(0).at(1).value<job::Photo>();
    const QJsonObject json = QJsonDocument::fromJson(photo.rig_json.toUtf8()).object();
    const auto rig = camera::rigFromJson(json);
    ASSERT_TRUE(rig.has_value());
    EXPECT_EQ(rig->width_px, 1920);
    EXPECT_NEAR(rig->lens.focalLengthPx(), 1.5 * live.model().rig().lens.focalLengthPx(), 1e-6);
    EXPECT_EQ(circumstancesOf(json).camera, QStringLiteral("Webcam"));
    EXPECT_TRUE(circumstancesOf(json).range.has_value());
    EXPECT_TRUE(page.fullStillText().contains(QStringLiteral("0.4 s")));
}

TEST_F(CameraPresenterTest, WithoutTheLargeModeThePhotoIsTheLivePicture) {
    connectInstrument();
    page.setFullStills(true);
    webcam->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
    live.capture();
    Q_EMIT webcam->stillFailed({core::ErrorKind::kCamera, QStringLiteral("No."), QStringLiteral("Yes."), std::nullopt, {}});
    webcam->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
    pass(300ms);
    EXPECT_TRUE(live.still().has_value());
    EXPECT_FALSE(messages.bars().empty());
}

TEST(CameraSettingsTest, SurviveTheSettingsFile) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("settings.ini"));
    Settings kept;
    CameraSetting webcam;
    webcam.kind = video::SourceKind::kV4l2;
    webcam.name = QStringLiteral("HD Pro \"Webcam\"; 2");
    webcam.format = video::VideoFormat{{1920, 1080}, 15.0, QStringLiteral("MJPG")};
    webcam.controls = {{CameraControl::kExposure, false, 12.5}, {CameraControl::kFocus, true, 0.0}};
    webcam.full_stills = true;
    kept.cameras.keep(webcam);
    ASSERT_TRUE(kept.save(path).has_value());
    const Settings again = Settings::load(path);
    EXPECT_EQ(again.cameras.of({video::SourceKind::kV4l2, {}, webcam.name}), webcam);
    EXPECT_FALSE(again.cameras.of({video::SourceKind::kQtCamera, {}, webcam.name}).format.has_value());
}

}  // namespace
}  // namespace pmts::app
