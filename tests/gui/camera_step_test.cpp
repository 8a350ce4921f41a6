#include "bench_fixture.hpp"
#include "lab/camera_step.hpp"
#include "field/field_actions.hpp"
#include "lab/histogram_view.hpp"
#include "lab/vidformat_dialog.hpp"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>

namespace pmts::gui {
namespace {

using video::CameraControl;
using video::SourceState;

/// A webcam as its driver tells of it.
class Webcam : public video::VideoSource {
public:
    Webcam() {
        report_.formats = {{{1280, 720}, 30.0, QStringLiteral("YUYV")}, {{1920, 1080}, 30.0, QStringLiteral("MJPG")},
                           {{1920, 1080}, 15.0, QStringLiteral("MJPG")}, {{1920, 1080}, 5.0, QStringLiteral("YUYV")}};
        report_.controls = {{{CameraControl::kExposure, 0.5, 100.0, 0.5, 10.0, true, true}, {CameraControl::kExposure, true, 12.5}},
                            {{CameraControl::kGain, 0.0, 255.0, 1.0, 16.0, false, true}, {CameraControl::kGain, false, 16.0}}};
    }
    void start(const video::VideoFormat& wanted) override {
        report_.format = wanted;
        setState(SourceState::kRunning);
        Q_EMIT reportChanged();
    }
    void stop() override { setState(SourceState::kStopped); }
    void pause() override { setState(SourceState::kPaused); }
    void resume() override { setState(SourceState::kRunning); }
    void setControls(const std::vector<video::ControlValue>& wishes) override {
        for (const video::ControlValue& wish : wishes) {
            for (video::CameraControlState& control : report_.controls) {
                if (control.range.control == wish.control) {
                    const double held = control.value.value;
                    control.value = {wish.control, wish.automatic && control.range.has_auto, wish.hold || wish.automatic ? held : wish.value};
                }
            }
        }
        Q_EMIT reportChanged();
    }
    video::SourceAddress address() const override { return {video::SourceKind::kV4l2, QStringLiteral("/dev/video0"), QStringLiteral("Webcam")}; }
    SourceState state() const override { return state_; }
    video::SourceStatistics statistics() const override { return {}; }
    camera::FramePtr newestFrame() const override { return frame_; }
    video::DeviceReport report() const override { return report_; }

    void addControl(const video::ControlRange& range, double value) {
        report_.controls.push_back({range, {range.control, range.has_auto, value}});
        Q_EMIT reportChanged();
    }
    void show(const cv::Mat& picture) {
        auto frame = std::make_shared<camera::Frame>();
        frame->image = picture;
        frame_ = frame;
        Q_EMIT frameReady();
    }

private:
    void setState(SourceState state) {
        state_ = state;
        Q_EMIT stateChanged(state);
    }
    SourceState state_ = SourceState::kStopped;
    video::DeviceReport report_;
    camera::FramePtr frame_;
};

class CameraStepTest : public test::WindowFixture {
protected:
    CameraStepTest() {
        webcam = new Webcam;
        bench->live.setSource(std::unique_ptr<video::VideoSource>(webcam));
    }
    template <class Part>
    static Part& part(QWidget& form, const char* name) {
        return *form.findChild<Part*>(QLatin1String(name));
    }
    Webcam* webcam = nullptr;
};

TEST_F(CameraStepTest, ShowsARowForWhatTheCameraHasAndNothingElse) {
    CameraStep step(bench->camera);
    const auto numbers = step.findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(numbers.size(), 2);
    EXPECT_EQ(numbers[0]->suffix(), QStringLiteral(" ms"));
    EXPECT_FALSE(numbers[0]->isEnabled()) << "the camera looks after its exposure";
    EXPECT_TRUE(numbers[1]->isEnabled());
    EXPECT_TRUE(part<QLabel>(step, "no_controls").isHidden());
}

TEST_F(CameraStepTest, ValueTypedAndAutomaticUntickedReachTheCamera) {
    CameraStep step(bench->camera);
    const auto numbers = step.findChildren<QDoubleSpinBox*>();
    numbers[1]->setValue(40);
    EXPECT_EQ(webcam->report().controls[1].value.value, 40.0);
    for (QCheckBox* const box : step.findChildren<QCheckBox*>()) {
        if (box->text() == QStringLiteral("Auto")) {
            box->click();
        }
    }
    EXPECT_FALSE(webcam->report().controls[0].value.automatic);
    EXPECT_EQ(webcam->report().controls[0].value.value, 12.5) << "held where it was";
    EXPECT_TRUE(numbers[0]->isEnabled());
}

TEST_F(CameraStepTest, EveryControlAndTheLockAreInSightOnTheSmallestScreen) {
    webcam->addControl({CameraControl::kWhiteBalance, 2800.0, 6500.0, 10.0, 4600.0, true, true}, 4600.0);
    webcam->addControl({CameraControl::kFocus, 0.0, 250.0, 5.0, 30.0, true, true}, 30.0);
    webcam->addControl({CameraControl::kZoom, 100.0, 500.0, 1.0, 100.0, false, true}, 100.0);
    window->setWindowState(Qt::WindowNoState);
    window->resize(1280, 800);
    window->show();
    window->actions().lab->trigger();
    QCoreApplication::processEvents();
    auto* const step = window->findChild<CameraStep*>();
    const auto* const sight = step->parentWidget();
    const auto place = [sight](const QWidget* part) { return QRect(part->mapTo(sight, QPoint()), part->size()); };

    const auto sliders = step->findChildren<QSlider*>();
    const auto numbers = step->findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(sliders.size(), 5);
    ASSERT_EQ(numbers.size(), 5);
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(sight->rect().contains(place(numbers[i]))) << numbers[i]->accessibleName().toStdString();
        EXPECT_EQ(place(sliders[i]).center().y(), place(numbers[i]).center().y()) << "in one row";
        EXPECT_LE(place(numbers[i]).height(), 44);
        EXPECT_GE(sliders[i]->width(), 60);
    }
    for (const QCheckBox* const box : step->findChildren<QCheckBox*>()) {
        EXPECT_LE(place(box).right(), sight->rect().right()) << box->text().toStdString();
    }
    EXPECT_TRUE(sight->rect().contains(place(&part<QPushButton>(*step, "lock"))));
}

TEST_F(CameraStepTest, PauseButtonActionAndKeyAreOneThing) {
    CameraStep step(bench->camera);
    QPushButton& pause = part<QPushButton>(step, "pause");
    pause.click();
    EXPECT_EQ(webcam->state(), SourceState::kPaused);
    EXPECT_TRUE(window->actions().pause_camera->isChecked());
    EXPECT_EQ(pause.text(), QStringLiteral("Start"));
    window->actions().pause_camera->trigger();
    EXPECT_EQ(webcam->state(), SourceState::kRunning);
    EXPECT_FALSE(window->actions().pause_camera->isChecked());
    window->actions().stop_camera->trigger();
    EXPECT_EQ(webcam->state(), SourceState::kStopped);
    EXPECT_FALSE(window->actions().stop_camera->isEnabled());
}

TEST_F(CameraStepTest, ClickMeasuresTheSharpnessThere) {
    CameraStep step(bench->camera);
    EXPECT_TRUE(step.pictureClicked({640, 360}));
    ASSERT_TRUE(bench->camera.box());
    EXPECT_EQ(bench->camera.box()->center(), QPointF(640, 360));
    part<QPushButton>(step, "whole").click();
    EXPECT_FALSE(bench->camera.box());
}

TEST_F(CameraStepTest, BurntOutPixelsAreHatchedOverThePictureOnRequest) {
    CameraStep step(bench->camera);
    part<QCheckBox>(step, "burnt").setChecked(true);
    cv::Mat picture(72, 128, CV_8UC3, cv::Scalar::all(90));
    picture(cv::Rect(32, 16, 32, 32)) = cv::Scalar::all(255);
    webcam->show(picture);
    bench->camera.waitForMeters();
    QImage view(128, 72, QImage::Format_ARGB32);
    view.fill(Qt::black);
    QPainter painter(&view);
    step.paintOver(painter, QTransform());
    painter.end();
    EXPECT_NE(view.pixelColor(42, 30), QColor(Qt::black));
    EXPECT_EQ(view.pixelColor(10, 30), QColor(Qt::black));
}

TEST_F(CameraStepTest, VideoFormatOffersWhatFitsTogetherAndUsesIt) {
    VidformatDialog dialog(bench->camera);
    auto& size = part<QComboBox>(dialog, "size");
    auto& pixels = part<QComboBox>(dialog, "pixels");
    auto& rate = part<QComboBox>(dialog, "rate");
    EXPECT_EQ(size.currentText(), QStringLiteral("1280 x 720"));
    size.setCurrentIndex(0);
    EXPECT_EQ(size.currentText(), QStringLiteral("1920 x 1080"));
    EXPECT_EQ(rate.count(), 1) << "YUYV stays chosen: this size has it at 5 a second only";
    pixels.setCurrentText(QStringLiteral("MJPG"));
    EXPECT_EQ(rate.count(), 2);
    part<QPushButton>(dialog, "apply").click();
    EXPECT_EQ(webcam->report().format, (video::VideoFormat{{1920, 1080}, 30.0, QStringLiteral("MJPG")}));
    EXPECT_TRUE(part<QLabel>(dialog, "camera").text().contains(QStringLiteral("1920x1080")));
}

TEST_F(CameraStepTest, RowsOfAnOpenListAreForGloves) {
    VidformatDialog dialog(bench->camera);
    dialog.show();
    for (const char* name : {"size", "pixels", "rate"}) {
        const auto& choice = part<QComboBox>(dialog, name);
        ASSERT_GT(choice.count(), 0) << name;
        EXPECT_GE(choice.view()->sizeHintForRow(0), 40) << name;
    }
}

TEST(HistogramViewTest, HoverTellsTheSharesOfALevel) {
    HistogramView view;
    view.resize(300, 120);
    camera::PictureMeters meters;
    meters.luma[255] = 0.021F;
    view.showMeters(meters);
    EXPECT_TRUE(view.textAt({299, 20}).startsWith(QStringLiteral("level 255: brightness 2.1 %")));
}

}  // namespace
}  // namespace pmts::gui
