#include "pmts/app/field/snap_presenter.hpp"

#include <opencv2/core.hpp>

#include <utility>

namespace pmts::app {

namespace {

constexpr double kSamePlace_px = 1.5;  ///< a hand that clicks moves this much

/// Pool thread: values in, a value out.
std::optional<SnapSpot> spotBeside(const camera::FramePtr& frame, const QPointF& at_px, double reach_px) {
    targeting::SnapSettings settings;
    settings.radius_px = reach_px;
    try {
        const auto found = targeting::snapped(frame->image, {at_px.x(), at_px.y()}, settings);
        if (!found) {
            return std::nullopt;
        }
        return SnapSpot{.kind = found->kind,
                        .px = {found->px.x(), found->px.y()},
                        .half_axes_px = {found->half_axes_px.x(), found->half_axes_px.y()},
                        .axis_angle_rad = found->axis_angle_rad};
    } catch (const cv::Exception&) {
        return std::nullopt;  // a picture of a kind nothing can be found in
    }
}

bool isNear(const QPointF& a, const QPointF& b) { return (a - b).manhattanLength() <= kSamePlace_px; }

}  // namespace

SnapPresenter::SnapPresenter(LivePresenter& live, Preferences& preferences, Threading threading, QObject* parent)
    : QObject(parent), live_(live), preferences_(preferences), threading_(threading) {
    pool_.setMaxThreadCount(1);
    pool_.setThreadPriority(QThread::LowPriority);
    connect(&live_, &LivePresenter::sceneChanged, this, &SnapPresenter::followFrame);
}

SnapPresenter::~SnapPresenter() {
    pool_.clear();
    pool_.waitForDone();
}

std::optional<SnapSpot> SnapPresenter::spotIn(Picture picture) const {
    return isOn() && asked_ && asked_->picture == picture ? spot_ : std::nullopt;
}

void SnapPresenter::setOn(bool on) {
    if (on != isOn()) {
        Settings next = preferences_.settings();
        next.image_tools.snap = on;
        preferences_.set(next);
        lookAway();
    }
}

void SnapPresenter::look(Picture picture, const camera::FramePtr& frame, const QPointF& cursor_px, double reach_px) {
    if (isOn() && frame) {
        if (asked_ && asked_->picture != picture) {
            lookAway();
        }
        asked_ = Question{.picture = picture, .frame = frame, .at_px = cursor_px, .reach_px = reach_px, .take = {}};
        ask(*asked_);
    }
}

void SnapPresenter::lookAway() {
    asked_.reset();
    hover_.reset();
    answered_.reset();
    show(std::nullopt);
}

void SnapPresenter::followFrame() {
    const camera::FramePtr& newest = live_.scene().frame;
    if (asked_ && asked_->picture == Picture::kLive && newest && newest != asked_->frame) {
        asked_->frame = newest;
        ask(*asked_);
    }
}

void SnapPresenter::choose(Picture picture, const camera::FramePtr& frame, const QPointF& clicked_px, double reach_px,
                           std::function<void(QPointF)> take) {
    if (!isOn() || !frame) {
        return take(clicked_px);
    }
    if (answered_ && answered_->picture == picture && isNear(answered_->at_px, clicked_px)) {
        return take(spot_ ? spot_->px : clicked_px);  // what is drawn is what the click gets
    }
    ask({.picture = picture, .frame = frame, .at_px = clicked_px, .reach_px = reach_px, .take = std::move(take)});
}

void SnapPresenter::ask(Question question) {
    if (!running_) {
        return start(std::move(question));
    }
    (question.take ? click_ : hover_) = std::move(question);  // a newer place replaces one nobody has looked at
}

void SnapPresenter::start(Question question) {
    running_ = std::move(question);
    const auto look = [frame = running_->frame, at_px = running_->at_px, reach_px = running_->reach_px] {
        return spotBeside(frame, at_px, reach_px);
    };
    if (threading_ == Threading::kCallersThread) {
        return finish(look());
    }
    pool_.start([this, look] {
        const auto spot = look();
        QMetaObject::invokeMethod(this, [this, spot] { finish(spot); }, Qt::QueuedConnection);
    });
}

void SnapPresenter::finish(const std::optional<SnapSpot>& spot) {
    Question done = *std::exchange(running_, std::nullopt);
    if (asked_ && asked_->picture == done.picture) {
        const auto take = std::exchange(done.take, {});
        answered_ = done;
        show(spot);
        if (take) {
            take(spot ? spot->px : done.at_px);
        }
    } else if (done.take) {
        done.take(spot ? spot->px : done.at_px);
    }
    if (running_) {
        return;  // a click's outcome has asked already
    }
    for (std::optional<Question>* next : {&click_, &hover_}) {
        if (*next) {
            return start(*std::exchange(*next, std::nullopt));
        }
    }
}

void SnapPresenter::show(const std::optional<SnapSpot>& spot) {
    if (spot_ || spot) {
        spot_ = spot;
        Q_EMIT spotChanged();
    }
}

}  // namespace pmts::app
