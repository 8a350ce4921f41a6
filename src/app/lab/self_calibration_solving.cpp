// What follows a sweep of the self-calibration: solves in the pool, compares, keeps the result or drops it.
#include "pmts/app/lab/self_calibration_presenter.hpp"

#include "pmts/app/lab/lab_calibration.hpp"

#include <QPromise>
#include <QThreadPool>

#include <memory>

namespace pmts::app {

void SelfCalibrationPresenter::solve() {
    setPhase(SelfCalibrationPhase::kSolving);
    const auto promise = std::make_shared<QPromise<Solved>>();
    watcher_.setFuture(promise->future());
    promise->start();
    const auto work = [promise, spots = spots_, start = start_] {
        promise->addResult(calibration::selfCalibrate(
            spots, {.start = start}, [&promise](double) { return !promise->isCanceled(); }));
        promise->finish();
    };
    if (threading_ == Threading::kOwnThread) {
        QThreadPool::globalInstance()->start(work);
    } else {
        work();
    }
}

void SelfCalibrationPresenter::finishSolving() {
    const bool cancelled = watcher_.isCanceled() || watcher_.future().resultCount() == 0;
    const Solved solved = cancelled ? Solved(core::cancelled()) : watcher_.result();
    if (!solved) {
        spots_.pop_back();
        pointings_used_ -= done_before_;
        return fail(solved.error());
    }
    found_ = *solved;
    rough_ = found_->rig;
    picked_.reset();
    show();
    messages_.cue(Cue::kArrived);
    setPhase(SelfCalibrationPhase::kSolved);
}

bool SelfCalibrationPresenter::canCompareWithBefore() const {
    return preferences_.settings().rigFor(cameraInUse(live_)).profile.previous.has_value();
}

QString SelfCalibrationPresenter::comparedWith() const {
    return before_ && canCompareWithBefore() ? tr("the rig before the one in use") : tr("the rig in use");
}

void SelfCalibrationPresenter::compareWithBefore(bool before) {
    before_ = before;
    show();
}

void SelfCalibrationPresenter::show() {
    if (!found_) {
        return;
    }
    const RigProfile profile = preferences_.settings().rigFor(cameraInUse(live_)).profile;
    const camera::Rig& other = before_ && profile.previous ? profile.previous->rig : live_.model().rig();
    view_ = viewOf(*found_, spots_, other, preferences_.units());
    Q_EMIT changed();
}

void SelfCalibrationPresenter::accept() {
    if (!found_ || phase_ != SelfCalibrationPhase::kSolved) {
        return;
    }
    CalibrationRecord record = recordOf(*found_, spots_);
    record.camera = cameraInUse(live_);
    if (const auto& identity = instrument_.identity()) {
        record.instrument = identity->serial_number;
    }
    const QString profile = preferences_.acceptRig(found_->rig, record);
    messages_.toast(tr("The calibration is kept as “%1” and used from now on.").arg(profile));
    Q_EMIT accepted(profile);
    reject();
}

void SelfCalibrationPresenter::reject() {
    if (isBusy()) {
        return;
    }
    found_.reset();
    view_.reset();
    spots_.clear();
    pointings_used_ = 0;
    picked_.reset();
    setPhase(SelfCalibrationPhase::kPick);
}

}  // namespace pmts::app
