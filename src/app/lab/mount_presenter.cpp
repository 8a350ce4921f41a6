#include "pmts/app/lab/mount_presenter.hpp"

#include "pmts/geometry/polar.hpp"

#include <algorithm>

namespace pmts::app {

using camera::MountKind;

MountPresenter::MountPresenter(LivePresenter& live, InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                               Threading threading, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), preferences_(preferences), messages_(messages),
      threading_(threading), frames_(live, instrument) {
    connect(&frames_, &StandingFrames::stood, this, &MountPresenter::takeFrame);
    connect(&instrument_, &InstrumentDesk::turned, this, [this](Ticket ticket) { onTurned(ticket); });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_ && isBusy()) {
            fail(error.sentence());
        }
    });
    connect(&preferences_, &Preferences::changed, this, &MountPresenter::changed);
}

DeviceState MountPresenter::state() const {
    if (isBusy()) {
        return DeviceState::kBusy;
    }
    if (!failure_.isEmpty()) {
        return DeviceState::kFailed;
    }
    if (!check_) {
        return DeviceState::kIdle;
    }
    return check_->kind == kindInUse() ? DeviceState::kGood : DeviceState::kWarning;
}

QString MountPresenter::step() const {
    switch (phase_) {
        case Phase::kBefore: return tr("Waiting for a picture while the telescope stands still.");
        case Phase::kTurning: return tr("Tilting the telescope by %1.").arg(preferences_.units().angle(tilt_));
        case Phase::kAfter: return tr("Waiting for a picture after the tilt.");
        case Phase::kComparing: return tr("Comparing the two pictures.");
        case Phase::kBack: return tr("Tilting the telescope back.");
        case Phase::kIdle: break;
    }
    if (!failure_.isEmpty()) {
        return failure_;
    }
    if (!check_) {
        return tr("Point the camera at something with detail and press Check: the telescope tilts and comes back.");
    }
    if (!check_->kind) {
        return tr("The picture does neither. Point at something farther away that stands still, and check again.");
    }
    return check_->kind == kindInUse() ? tr("The profile says the same. Go on with the twist.")
                                       : tr("The profile says otherwise: press the button of the mount that was found.");
}

QString MountPresenter::verdict() const {
    if (!check_) {
        return {};
    }
    if (!check_->kind) {
        return tr("The pictures do not tell the mount.");
    }
    return *check_->kind == MountKind::kTelescope ? tr("The camera is on the telescope.") : tr("The camera is on the handle.");
}

QString MountPresenter::evidence() const {
    return check_ ? tr("The picture moved by %1 px; on the telescope it would move by %2 px. %3 of %4 details agree.")
                        .arg(check_->moved_px, 0, 'f', 0)
                        .arg(check_->expected_px, 0, 'f', 0)
                        .arg(qRound(check_->confidence * static_cast<double>(check_->details.size())))
                        .arg(check_->details.size())
                  : QString();
}

QString MountPresenter::profileText() const {
    return kindInUse() == MountKind::kTelescope ? tr("The rig in use has the camera on the telescope.")
                                                : tr("The rig in use has the camera on the handle.");
}

void MountPresenter::setTilt(core::Angle tilt) {
    tilt_ = std::clamp(tilt, core::Angle::fromGon(0.5), core::Angle::fromGon(20));
    Q_EMIT changed();
}

void MountPresenter::start() {
    if (isBusy()) {
        return;
    }
    check_.reset();
    failure_.clear();
    if (instrument_.connectionState() != ConnectionState::kConnected || !live_.scene().frame) {
        return fail(tr("The check needs the instrument and a picture: connect both."));
    }
    frames_.setWanted(true);
    enter(Phase::kBefore);
}

void MountPresenter::cancel() {
    if (isBusy()) {
        instrument_.cancel(ticket_);
        fail(tr("The check was cancelled."));
    }
}

void MountPresenter::takeFrame(const camera::FramePtr& frame) {
    if (phase_ == Phase::kBefore) {
        before_ = frame;
        geometry::Pointing target = *frame->pointing;
        const bool looks_down = geometry::isFaceTwo(target) ? target.va.gon() < 300 : target.va.gon() > 100;
        target.va += looks_down != geometry::isFaceTwo(target) ? -tilt_ : tilt_;  // towards the horizon and across it
        turn(target, Phase::kTurning);
    } else if (phase_ == Phase::kAfter) {
        after_ = frame;
        turn(*before_->pointing, Phase::kBack);
    }
}

void MountPresenter::turn(const geometry::Pointing& target, Phase phase) {
    frames_.setWanted(false);
    enter(phase);
    ticket_ = instrument_.turnTo(target, preferences_.settings().turn_tolerance);
}

void MountPresenter::onTurned(Ticket ticket) {
    if (ticket != ticket_) {
        return;
    }
    if (phase_ == Phase::kTurning) {
        frames_.setWanted(true);
        enter(Phase::kAfter);
    } else if (phase_ == Phase::kBack) {
        compare();
    }
}

void MountPresenter::compare() {
    enter(Phase::kComparing);
    inPool(
        threading_, this,
        [before = before_, after = after_, rig = live_.model().rig()] {
            return calibration::mountFromMotion(before->image, *before->pointing, after->image, *after->pointing, rig);
        },
        [this](const core::Result<calibration::MountCheck>& check) { finish(check); });
}

void MountPresenter::finish(const core::Result<calibration::MountCheck>& check) {
    if (phase_ != Phase::kComparing) {
        return;  // cancelled meanwhile
    }
    before_.reset();
    after_.reset();
    if (!check) {
        return fail(check.error().sentence());
    }
    check_ = *check;
    enter(Phase::kIdle);
}

void MountPresenter::fail(const QString& sentence) {
    failure_ = sentence;
    ticket_ = 0;
    frames_.setWanted(false);
    enter(Phase::kIdle);
}

void MountPresenter::enter(Phase phase) {
    phase_ = phase;
    Q_EMIT changed();
}

void MountPresenter::accept(MountKind kind) {
    camera::Rig rig = live_.model().rig();
    if (rig.mount.kind == kind) {
        return;
    }
    rig.mount.kind = kind;
    CalibrationRecord record;
    record.method = CalibrationMethod::kMounting;
    record.remark = kind == MountKind::kTelescope ? tr("mount kind: telescope") : tr("mount kind: handle");
    keepMeasuredRig(live_, preferences_, messages_, rig, record);
    Q_EMIT changed();
}

}  // namespace pmts::app
