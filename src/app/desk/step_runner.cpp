#include "pmts/app/desk/step_runner.hpp"

namespace pmts::app {

StepRunner::StepRunner(TargetingPresenter& targeting, core::Clock& clock, QObject* parent)
    : QObject(parent), targeting_(targeting), clock_(clock) {
    // Queued: whoever hears of the arrival hears of it before the next step begins.
    connect(&targeting_, &TargetingPresenter::movingChanged, this, &StepRunner::goOn, Qt::QueuedConnection);
}

void StepRunner::keyPressed(Direction direction) {
    if (direction_ == direction && letting_go_) {
        letting_go_ = false;
        return let_go_.cancel();
    }
    released();
    targeting_.nudge(direction);
    hold(direction);
}

void StepRunner::keyReleased() {
    letting_go_ = true;
    let_go_ = clock_.callAfter(kKeyGap, [this] { released(); });
}

void StepRunner::buttonPressed(Direction direction) { hold(direction); }

void StepRunner::step(Direction direction) {
    const bool ends_a_run = running_;
    released();
    if (!ends_a_run) {
        targeting_.nudge(direction);
    }
}

void StepRunner::released() {
    held_long_.cancel();
    let_go_.cancel();
    letting_go_ = false;
    direction_.reset();
    running_ = false;
}

void StepRunner::hold(Direction direction) {
    released();
    direction_ = direction;
    held_long_ = clock_.callAfter(kHold, [this] { startRunning(); });
}

void StepRunner::startRunning() {
    running_ = direction_.has_value();
    if (!targeting_.isMoving()) {
        goOn();
    }
}

void StepRunner::goOn() {
    if (!running_ || targeting_.isMoving()) {
        return;
    }
    const auto& target = targeting_.target();
    if (target && target->state == MoveState::kLost) {
        return released();  // stopped by Esc or by trouble: going on would fight it
    }
    targeting_.nudge(*direction_);
}

}  // namespace pmts::app
