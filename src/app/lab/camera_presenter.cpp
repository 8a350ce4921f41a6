#include "pmts/app/lab/camera_presenter.hpp"

#include "camera_words.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pmts::app {

namespace {

constexpr qint64 kLookEvery_ms = 200;

bool isSame(double a_hz, double b_hz) { return std::abs(a_hz - b_hz) < 0.05; }

}  // namespace

CameraPresenter::CameraPresenter(LivePresenter& live, Preferences& preferences, MessageCentre& messages, Threading threading,
                                 QObject* parent)
    : QObject(parent), live_(live), preferences_(preferences), messages_(messages), threading_(threading) {
    pool_.setMaxThreadCount(1);
    pool_.setThreadPriority(QThread::LowPriority);
    connect(&live_, &LivePresenter::sourceChanged, this, &CameraPresenter::followSource);
    connect(&live_, &LivePresenter::sceneChanged, this, &CameraPresenter::look);
    connect(&live_, &LivePresenter::cameraStatusChanged, this, &CameraPresenter::stateChanged);
    connect(&live_, &LivePresenter::statisticsChanged, this, &CameraPresenter::rateChanged);
    followSource();
}

CameraPresenter::~CameraPresenter() {
    pool_.clear();
    pool_.waitForDone();
}

void CameraPresenter::followSource() {
    report_ = {};
    last_still_took_.reset();
    chose_controls_ = false;
    meters_ = {};
    box_.reset();
    if (video::VideoSource* const camera = live_.camera()) {
        connect(camera, &video::VideoSource::reportChanged, this, &CameraPresenter::showReport);
        connect(camera, &video::VideoSource::stateChanged, this, &CameraPresenter::stateChanged);
        connect(camera, &video::VideoSource::stillTaken, this, [this](const video::FullStill& still) {
            last_still_took_ = still.took;
            Q_EMIT optionsChanged();
        });
        report_ = camera->report();
    }
    Q_EMIT stateChanged();
    Q_EMIT modesChanged();
    Q_EMIT controlsChanged();
    Q_EMIT optionsChanged();
    Q_EMIT metersChanged();
}

void CameraPresenter::showReport() {
    const video::DeviceReport before = std::exchange(report_, live_.source()->report());
    if (std::exchange(chose_controls_, false)) {
        keepControls();
    }
    if (before.format.size != report_.format.size) {
        box_.reset();  // its pixels were another picture's
        meters_.best_sharpness = 0.0;
    }
    if (before.format != report_.format || before.formats != report_.formats) {
        Q_EMIT modesChanged();
        Q_EMIT optionsChanged();
    }
    if (before.controls != report_.controls) {
        Q_EMIT controlsChanged();
    }
}

// State -------------------------------------------------------------------------------------------------------------

QString CameraPresenter::name() const { return hasCamera() ? live_.source()->address().name : QString(); }

DeviceState CameraPresenter::state() const { return live_.cameraStatus().state; }

QString CameraPresenter::sentence() const {
    if (!hasCamera()) {
        return tr("No camera is chosen: choose one on the connection page.");
    }
    if (live_.source()->state() != video::SourceState::kRunning) {
        return live_.cameraStatus().details;
    }
    const video::VideoFormat now = format();
    return tr("%1: %2x%3, %4 of %5 pictures a second.")
        .arg(name())
        .arg(now.size.width())
        .arg(now.size.height())
        .arg(live_.statistics().rate_hz, 0, 'f', 1)
        .arg(rateText(now.rate_hz));
}

bool CameraPresenter::isRunning() const {
    return hasCamera() && live_.source()->state() != video::SourceState::kStopped && !isPaused();
}

bool CameraPresenter::isPaused() const { return hasCamera() && live_.source()->state() == video::SourceState::kPaused; }

void CameraPresenter::start() {
    if (video::VideoSource* const camera = live_.camera()) {
        isPaused() ? camera->resume() : live_.startCamera();
    }
}

void CameraPresenter::pause() {
    if (video::VideoSource* const camera = live_.camera()) {
        camera->pause();
    }
}

void CameraPresenter::togglePause() { isRunning() ? pause() : start(); }

void CameraPresenter::stop() {
    if (video::VideoSource* const camera = live_.camera()) {
        camera->stop();
    }
}

// Modes -------------------------------------------------------------------------------------------------------------

video::VideoFormat CameraPresenter::format() const { return report_.format; }

std::vector<QSize> CameraPresenter::sizes() const {
    std::vector<QSize> all;
    for (const video::VideoFormat& offer : report_.formats) {
        if (std::ranges::find(all, offer.size) == all.end()) {
            all.push_back(offer.size);
        }
    }
    std::ranges::sort(all, std::greater<>(), [](const QSize& size) { return qint64{size.width()} * size.height(); });
    return all;
}

QStringList CameraPresenter::pixelFormats(const QSize& size) const {
    QStringList all;
    for (const video::VideoFormat& offer : report_.formats) {
        if (offer.size == size && !all.contains(offer.pixel_format)) {
            all.append(offer.pixel_format);
        }
    }
    return all;
}

std::vector<double> CameraPresenter::rates(const QSize& size, const QString& pixel_format) const {
    std::vector<double> all;
    for (const video::VideoFormat& offer : report_.formats) {
        const bool is_known = std::ranges::any_of(all, [&offer](double rate_hz) { return isSame(rate_hz, offer.rate_hz); });
        if (offer.size == size && offer.pixel_format == pixel_format && !is_known) {
            all.push_back(offer.rate_hz);
        }
    }
    std::ranges::sort(all, std::greater<>());
    return all;
}

QString CameraPresenter::measuredText() const {
    const LiveStatistics& seen = live_.statistics();
    return tr("%1 pictures a second, %2 lost").arg(seen.rate_hz, 0, 'f', 1).arg(seen.lost);
}

QString CameraPresenter::rigNote() const {
    const RigChoice choice = live_.rigChoice();
    return choice.deservesWarning() ? choice.sentence : QString();
}

void CameraPresenter::setFormat(const video::VideoFormat& format) {
    if (!hasCamera() || format == this->format()) {
        return;
    }
    change([&format](CameraSetting& kept) { kept.format = format; });
    live_.startCamera();
}

// Controls ----------------------------------------------------------------------------------------------------------

std::vector<ControlRow> CameraPresenter::controls() const {
    std::vector<ControlRow> rows;
    for (const video::CameraControlState& control : report_.controls) {
        rows.push_back({.range = control.range,
                        .value = control.value,
                        .name = controlName(control.range.control),
                        .unit = controlUnit(control.range.control),
                        .text = controlText(control),
                        .limits = limitsText(control.range)});
    }
    return rows;
}

bool CameraPresenter::canLock() const {
    return std::ranges::any_of(report_.controls, [](const video::CameraControlState& control) { return control.value.automatic; });
}

void CameraPresenter::setAutomatic(video::CameraControl control, bool automatic) {
    wish({{.control = control, .automatic = automatic, .value = 0.0, .hold = !automatic}});
}

void CameraPresenter::setValue(video::CameraControl control, double value) {
    wish({{.control = control, .automatic = false, .value = value}});
}

void CameraPresenter::lock() {
    std::vector<video::ControlValue> holds;
    for (const video::CameraControlState& control : report_.controls) {
        if (control.value.automatic) {
            holds.push_back({.control = control.range.control, .hold = true});
        }
    }
    wish(holds);
}

void CameraPresenter::useUsualValues() {
    std::vector<video::ControlValue> usual;
    for (const video::CameraControlState& control : report_.controls) {
        usual.push_back({.control = control.range.control, .automatic = control.range.has_auto, .value = control.range.usual});
    }
    wish(usual);
}

/// On top of what stands: a device that is opened again gets all of it.
void CameraPresenter::wish(const std::vector<video::ControlValue>& wishes) {
    if (!hasCamera() || wishes.empty()) {
        return;
    }
    std::vector<video::ControlValue> all = setting().controls;
    for (const video::ControlValue& one : wishes) {
        video::remember(all, one);
    }
    chose_controls_ = true;
    change([&wishes](CameraSetting& kept) {
        for (video::ControlValue one : wishes) {
            if (!one.hold) {
                video::remember(kept.controls, one);
            }
        }
    });
    live_.camera()->setControls(all);
}

/// What was held has a value now; what was out of range has been moved into it.
void CameraPresenter::keepControls() {
    change([this](CameraSetting& kept) {
        for (const video::CameraControlState& control : report_.controls) {
            const bool was_set = std::ranges::any_of(
                kept.controls, [&](const video::ControlValue& value) { return value.control == control.range.control; });
            if (was_set || (control.range.has_auto && !control.value.automatic)) {
                video::remember(kept.controls, control.value);
            }
        }
    });
    live_.camera()->setControls(setting().controls);
}

CameraSetting CameraPresenter::setting() const {
    return hasCamera() ? preferences_.settings().cameras.of(live_.source()->address()) : CameraSetting{};
}

void CameraPresenter::change(const std::function<void(CameraSetting&)>& how) {
    CameraSetting next = setting();
    how(next);
    if (hasCamera() && !(next == setting())) {
        Settings settings = preferences_.settings();
        settings.cameras.keep(next);
        preferences_.set(settings);
    }
}

// Stills ------------------------------------------------------------------------------------------------------------

bool CameraPresenter::takesFullStills() const { return setting().full_stills; }

void CameraPresenter::setFullStills(bool on) {
    change([on](CameraSetting& kept) { kept.full_stills = on; });
    Q_EMIT optionsChanged();
}

QString CameraPresenter::fullStillText() const {
    const auto mode = live_.largestMode();
    if (!mode) {
        return tr("The live picture is the largest this camera has.");
    }
    const QString size = tr("Photos in %1x%2").arg(mode->size.width()).arg(mode->size.height());
    return last_still_took_ ? tr("%1; the last one took %2 s.").arg(size).arg(secondsOf(*last_still_took_), 0, 'f', 1)
                            : tr("%1; the live view stands still meanwhile.").arg(size);
}

// Meters ------------------------------------------------------------------------------------------------------------

void CameraPresenter::setMetering(bool on) {
    metering_ = on;
    since_look_.invalidate();
    look();
}

void CameraPresenter::setBox(const std::optional<QRectF>& frame_px) {
    box_ = frame_px;
    meters_.best_sharpness = 0.0;
    since_look_.invalidate();
    look();
    Q_EMIT optionsChanged();
}

void CameraPresenter::resetPeak() {
    meters_.best_sharpness = meters_.sharpness;
    meters_.sharpness_text = sharpnessText(meters_.sharpness, meters_.best_sharpness);
    Q_EMIT metersChanged();
}

void CameraPresenter::setShowsBurnt(bool on) {
    shows_burnt_ = on;
    meters_.burnt = {};
    since_look_.invalidate();
    look();
    Q_EMIT optionsChanged();
}

void CameraPresenter::look() {
    const camera::FramePtr frame = live_.scene().frame;
    const bool is_soon = since_look_.isValid() && since_look_.elapsed() < kLookEvery_ms;
    if (!(metering_ || shows_burnt_) || !frame || measuring_ || is_soon) {
        return;
    }
    since_look_.start();
    std::optional<cv::Rect> box;
    if (box_) {
        box = cv::Rect(qRound(box_->x()), qRound(box_->y()), qRound(box_->width()), qRound(box_->height()));
    }
    const auto measure = [frame, box, wants_mask = shows_burnt_] {
        return std::pair(camera::measurePicture(frame->image, box), wants_mask ? burntImage(frame->image) : QImage());
    };
    if (threading_ == Threading::kCallersThread) {
        const auto [picture, burnt] = measure();
        return showMeters(picture, burnt);
    }
    measuring_ = true;
    pool_.start([this, measure] {
        const auto outcome = measure();
        QMetaObject::invokeMethod(
            this,
            [this, outcome] {
                measuring_ = false;
                showMeters(outcome.first, outcome.second);
            },
            Qt::QueuedConnection);
    });
}

void CameraPresenter::waitForMeters() {
    pool_.waitForDone();
    QCoreApplication::sendPostedEvents(this);
}

void CameraPresenter::showMeters(const camera::PictureMeters& picture, const QImage& burnt) {
    meters_.picture = picture;
    meters_.sharpness = picture.box_sharpness.value_or(picture.sharpness);
    meters_.best_sharpness = std::max(meters_.best_sharpness, meters_.sharpness);
    meters_.sharpness_text = sharpnessText(meters_.sharpness, meters_.best_sharpness);
    const auto has = [this](video::CameraControl control) {
        return std::ranges::any_of(report_.controls, [control](const video::CameraControlState& state) {
            return state.range.control == control && state.range.has_value;
        });
    };
    const ExposureAdvice advice = adviceOn(picture, has(video::CameraControl::kExposure), has(video::CameraControl::kGain));
    meters_.exposure_state = advice.state;
    meters_.exposure_text = advice.text;
    meters_.burnt = burnt;
    Q_EMIT metersChanged();
}

}  // namespace pmts::app
