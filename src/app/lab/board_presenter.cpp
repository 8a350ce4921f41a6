#include "pmts/app/lab/board_presenter.hpp"

#include "pmts/camera/scaled_rig.hpp"

#include <utility>

namespace pmts::app {

namespace {

constexpr double kStill_px = 2.0;  ///< between two pictures of a board that is held still

bool stands(const calibration::BoardView& now, const calibration::BoardView& before) {
    return now.px.size() == before.px.size() && (now.px.front() - before.px.front()).norm() < kStill_px &&
           (now.px.back() - before.px.back()).norm() < kStill_px;
}

}  // namespace

BoardPresenter::BoardPresenter(LivePresenter& live, Preferences& preferences, MessageCentre& messages, const core::Clock& clock,
                               Threading threading, QObject* parent)
    : QObject(parent), live_(live), preferences_(preferences), messages_(messages), clock_(clock), threading_(threading) {
    pool_.setMaxThreadCount(1);
    pool_.setThreadPriority(QThread::LowPriority);
    connect(&live_, &LivePresenter::sceneChanged, this, &BoardPresenter::lookAtFrame);
    connect(&live_, &LivePresenter::rigChoiceChanged, this, &BoardPresenter::compare);
}

BoardPresenter::~BoardPresenter() {
    cancelled_ = true;
    pool_.clear();
    pool_.waitForDone();
}

void BoardPresenter::run(std::function<void()> work) {
    if (threading_ == Threading::kCallersThread) {
        return work();
    }
    pool_.start(std::move(work));
}

void BoardPresenter::say(const QString& sentence) {
    sentence_ = sentence;
    Q_EMIT changed();
}

void BoardPresenter::setPattern(const calibration::BoardPattern& pattern) {
    if (const auto usable = calibration::usablePattern(pattern); !usable) {
        return say(usable.error().sentence());
    }
    if (pattern == this->pattern()) {
        return;
    }
    Settings next = preferences_.settings();
    next.rig_care.board = pattern;
    preferences_.set(next);
    clear();
}

void BoardPresenter::setLooking(bool on) {
    looking_ = on;
    seen_.reset();
    before_.reset();
    say(on ? tr("Show the board, hold it still, then move it: middle, edges, corners, tilted to all sides.") : QString());
}

void BoardPresenter::removeView(int index) {
    if (index >= 0 && index < static_cast<int>(views_.size())) {
        views_.erase(views_.begin() + index);
        Q_EMIT changed();
    }
}

void BoardPresenter::clear() {
    views_.clear();
    result_.reset();
    difference_.reset();
    say({});
}

// Looking -----------------------------------------------------------------------------------------------------------

void BoardPresenter::lookAtFrame() {
    const camera::FramePtr frame = live_.scene().frame;
    if (!looking_ || busy_ || adjusting_ || !frame) {
        return;
    }
    busy_ = true;
    const auto look = [frame, pattern = pattern()] { return calibration::findBoard(frame->image, pattern); };
    if (threading_ == Threading::kCallersThread) {
        return onLooked(look());
    }
    run([this, look] {
        auto view = look();
        QMetaObject::invokeMethod(this, [this, view = std::move(view)] { onLooked(view); }, Qt::QueuedConnection);
    });
}

void BoardPresenter::onLooked(const core::Result<calibration::BoardView>& view) {
    busy_ = false;
    if (!looking_) {
        return;
    }
    before_ = std::exchange(seen_, view ? std::optional(*view) : std::nullopt);
    if (!view) {
        return say(view.error().sentence());
    }
    const bool same_mode = views_.empty() || (views_.front().width_px == view->width_px && views_.front().height_px == view->height_px);
    if (!same_mode) {
        return say(tr("The camera's mode has changed. Clear the views to start again."));
    }
    if (!calibration::isNewView(*view, views_)) {
        return say(tr("Taken. Move or tilt the board."));
    }
    if (!before_ || !stands(*view, *before_)) {
        return say(tr("Hold it still."));
    }
    calibration::BoardView taken = *view;
    taken.name = tr("view %1").arg(views_.size() + 1);
    views_.push_back(std::move(taken));
    say(tr("Taken. Move or tilt the board."));
    Q_EMIT viewTaken(static_cast<int>(views_.size()));
}

// Adjusting ---------------------------------------------------------------------------------------------------------

void BoardPresenter::adjust(std::function<core::Result<calibration::BoardCalibration>()> work) {
    if (adjusting_) {
        return;
    }
    adjusting_ = true;
    cancelled_ = false;
    say(tr("Adjusting the lens to the corners."));
    if (threading_ == Threading::kCallersThread) {
        return onAdjusted(work());
    }
    run([this, work = std::move(work)] {
        auto result = work();
        QMetaObject::invokeMethod(this, [this, result = std::move(result)] { onAdjusted(result); }, Qt::QueuedConnection);
    });
}

void BoardPresenter::calibrate() {
    adjust([views = views_] { return calibration::calibrateBoard(views); });
}

void BoardPresenter::calibrateFolder(const QString& folder) {
    adjust([this, folder, pattern = pattern()] {
        return calibration::calibrateBoardFolder(folder, pattern, {}, [this](int done, int of) {
            QMetaObject::invokeMethod(this, [this, done, of] { say(tr("Reading picture %1 of %2.").arg(done + 1).arg(of)); }, Qt::QueuedConnection);
            return !cancelled_;
        });
    });
}

void BoardPresenter::cancel() {
    cancelled_ = true;
    setLooking(false);
}

void BoardPresenter::onAdjusted(const core::Result<calibration::BoardCalibration>& result) {
    adjusting_ = false;
    if (!result) {
        return say(result.error().sentence());
    }
    result_ = *result;
    sentence_.clear();
    compare();
}

void BoardPresenter::compare() {
    difference_.reset();
    if (result_) {
        const camera::Rig rig = camera::scaledRig(live_.rigChoice().profile.rig, result_->width_px, result_->height_px);
        if (const auto difference = camera::lensDifference(rig.lens, result_->lens, result_->width_px, result_->height_px)) {
            difference_ = *difference;
        }
    }
    Q_EMIT changed();
}

core::Result<BoardPresenter::Sheet> BoardPresenter::sheet() const {
    const auto modules = calibration::boardModules(pattern());
    PMTS_TRY(modules);
    const double square_mm = pattern().square_m * 1000;
    const QString kind = pattern().isCharuco() ? pattern().dictionary : tr("chessboard");
    return Sheet{.cells = modules->cells, .cell_mm = square_mm / modules->cells_per_square,
                 .caption = tr("PMTS board %1x%2, %3, squares %4 mm: measure one after printing").arg(pattern().columns).arg(pattern().rows).arg(kind).arg(square_mm)};
}

QString BoardPresenter::resultText() const { return result_ ? calibration::boardCalibrationText(*result_) : QString(); }

DeviceState BoardPresenter::verdictState() const {
    constexpr double kAlike_px = 1.0;
    if (!result_ || !difference_) {
        return result_ ? DeviceState::kWarning : DeviceState::kIdle;
    }
    return difference_->rms_px <= kAlike_px && result_->warnings.isEmpty() ? DeviceState::kGood : DeviceState::kWarning;
}

QString BoardPresenter::verdict() const {
    if (!result_) {
        return {};
    }
    if (!difference_) {
        return tr("The lens in use sees too little of this picture to be compared.");
    }
    const QString numbers = tr("%1 px rms, at most %2 px, after the best turn").arg(difference_->rms_px, 0, 'f', 2).arg(difference_->largest_px, 0, 'f', 2);
    return verdictState() == DeviceState::kGood ? tr("The board confirms the lens in use: %1.").arg(numbers)
                                                : tr("The board sees another lens than the one in use: %1.").arg(numbers);
}

void BoardPresenter::acceptLens() {
    if (!result_) {
        return;
    }
    CameraUse use = live_.cameraUse();
    use.size = {result_->width_px, result_->height_px};
    const camera::Rig before = camera::scaledRig(live_.rigChoice().profile.rig, result_->width_px, result_->height_px);
    const auto rig = camera::withLens(before, result_->lens);
    if (!rig) {
        messages_.report(rig.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    CalibrationRecord record{.method = CalibrationMethod::kBoard, .utc = clock_.utcNow(), .rms_px = result_->rms_px};
    record.camera = use;
    record.remark = tr("lens from %1 views of a board; the mount is that of before").arg(result_->views.size());
    for (const auto& parameter : result_->parameters) {
        if (parameter.standard_deviation) {
            record.standard_deviations[calibration::parameterName(parameter.parameter)] = *parameter.standard_deviation;
        }
    }
    for (const auto& residual : result_->residuals) {
        record.residuals.push_back({.px = residual.px, .residual_px = residual.residual_px});
    }
    const QString name = preferences_.acceptRig(*rig, record);
    messages_.toast(tr("“%1” has the board's lens; its mount is kept.").arg(name));
}

}  // namespace pmts::app
