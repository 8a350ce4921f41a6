// How the targeting presenter turns to its target, follows the move and tells how it ended.
#include "desk/message_topics.hpp"
#include "pmts/app/field/targeting_presenter.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

bool TargetingPresenter::isMoving() const { return ticket_ != 0; }

void TargetingPresenter::abandonMove() {
    legs_.clear();
    if (ticket_ != 0) {  // a new target while turning: the old move ends here, its outcome is nobody's any more
        instrument_.cancel(std::exchange(ticket_, 0));
        Q_EMIT movingChanged(false);
    }
}

void TargetingPresenter::move() { startMove(preferences_.settings().aiming.recentre); }

void TargetingPresenter::moveWithoutPicture() { startMove(false); }

void TargetingPresenter::startMove(bool with_picture) {
    if (!target_) {
        messages_.warn(tr("There is no target to turn to."), tr("Click it in the live view or in the still first."),
                       MessageAction::kNone, kMoveTopic);
        return;
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        messages_.warn(tr("The instrument is not connected, so it cannot turn."), tr("Connect it, then press Move again."),
                       MessageAction::kOpenConnectionPage, kMoveTopic);
        return;
    }
    abandonMove();
    messages_.solve(kMoveTopic);
    target_->proof.reset();
    const Settings& settings = preferences_.settings();
    if (with_picture && target_->click) {
        target_->click->patch = ahead_.taken(target_->click->frame, target_->click->px);
        ticket_ = instrument_.recentre({.click = *target_->click, .model = live_.model(), .frames = live_.feed(),
                                        .settings = settings.aiming.recentring(settings.turn_tolerance)});
    } else {
        ticket_ = instrument_.turnTo(target_->pointing, settings.turn_tolerance);
    }
    setState(MoveState::kQueued, tr("The move waits for its turn on the line."));
    Q_EMIT movingChanged(true);
}

void TargetingPresenter::moveTheLongWay() {
    const auto reading = instrument_.track().newest();
    if (!target_ || !reading) {
        return;
    }
    abandonMove();
    messages_.solve(kMoveTopic);
    legs_ = targeting::PointingGuard::longWay(reading->pointing, target_->pointing);
    legs_.pop_back();  // the last leg is the move itself
    std::reverse(legs_.begin(), legs_.end());
    ticket_ = instrument_.turnTo(legs_.back(), preferences_.settings().turn_tolerance);
    setState(MoveState::kQueued, tr("Turning the long way, which unwinds the cable."));
    Q_EMIT movingChanged(true);
}

void TargetingPresenter::stop() { instrument_.stop(); }

void TargetingPresenter::onTurned(Ticket ticket, const geometry::Pointing& arrived) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    if (!legs_.empty()) {
        legs_.pop_back();
        if (!legs_.empty()) {
            ticket_ = instrument_.turnTo(legs_.back(), preferences_.settings().turn_tolerance);
            return;
        }
        ticket_ = 0;
        return move();
    }
    const UnitFormat& units = preferences_.units();
    arrive(tr("Arrived at HA %1, VA %2.").arg(units.direction(arrived.ha), units.angle(arrived.va)));
}

void TargetingPresenter::arrive(const QString& sentence) {
    ticket_ = 0;
    setState(MoveState::kArrived, sentence);
    messages_.cue(Cue::kArrived);
    Q_EMIT movingChanged(false);
}

QString TargetingPresenter::residualText(const targeting::Recentred& proof) const {
    return tr("%1 px (%2), match %3")
        .arg(proof.residual_px.norm(), 0, 'f', 2)
        .arg(preferences_.units().smallAngle(proof.residual))
        .arg(proof.score, 0, 'f', 3);
}

void TargetingPresenter::onStep(Ticket ticket, const targeting::RecentringStep& step) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    switch (step.stage) {
        case targeting::RecentringStage::kTurning:
            return setState(MoveState::kTurning, tr("Turning to HA %1, VA %2.").arg(target_->ha_text, target_->va_text));
        case targeting::RecentringStage::kLooking:
            return setState(MoveState::kRecentring, tr("Looking for the clicked spot after move %1.").arg(step.move));
        case targeting::RecentringStage::kMatched:
            return setState(MoveState::kRecentring,
                            tr("Move %1: %2.").arg(step.move).arg(residualText(*step.matched)));
    }
}

void TargetingPresenter::onRecentred(Ticket ticket, const targeting::Recentred& proof) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    target_->proof = proof;
    target_->pointing = proof.pointing;
    refreshTexts();
    const QString moves = proof.moves == 1 ? tr("one move") : tr("%1 moves").arg(proof.moves);
    arrive(tr("On target: %1, %2.").arg(residualText(proof), moves));
}

/// A spot that cannot be known again may still be turned to; a wound cable can be unwound.
MessageAction TargetingPresenter::wayOut(const core::Error& error) const {
    if (error.detail == QLatin1String("cable")) {
        return MessageAction::kTurnTheLongWay;
    }
    const bool is_unrecognisable = error.detail == QLatin1String("plain") || error.detail == QLatin1String("edge") ||
                                   error.detail.startsWith(QLatin1String("ambiguous"));
    const bool has_not_turned = target_->state == MoveState::kQueued;
    return is_unrecognisable && has_not_turned ? MessageAction::kTurnWithoutPicture : MessageAction::kNone;
}

void TargetingPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    ticket_ = 0;
    legs_.clear();
    const MessageAction way_out = wayOut(error);
    setState(MoveState::kLost, error.sentence());
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, way_out, kMoveTopic);
        messages_.cue(Cue::kFailed);
    }
    Q_EMIT movingChanged(false);
}

void TargetingPresenter::onProgress(const instrument::Progress& progress) {
    if (isMoving() && progress.activity == instrument::Activity::kTurning) {
        setState(MoveState::kTurning, tr("Turning to HA %1, VA %2 (%3 %).")
                                          .arg(target_->ha_text, target_->va_text)
                                          .arg(qRound(progress.fraction * 100.0)));
    }
}

}  // namespace pmts::app
