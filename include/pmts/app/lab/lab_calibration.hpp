#pragma once

#include "pmts/app/lab/calibration_record.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/desk/threading.hpp"

#include <QMetaObject>
#include <QPointer>
#include <QThreadPool>

#include <functional>

namespace pmts::app {

/// The camera in use as the live view knows it: what a calibration made now belongs to.
[[nodiscard]] CameraUse cameraInUse(const LivePresenter& live);

/// Takes a rig measured with the camera in use into its profile; toast and the profile's name. What was before stays as the
/// profile's `previous`.
QString keepMeasuredRig(const LivePresenter& live, Preferences& preferences, MessageCentre& messages, const camera::Rig& rig,
                        CalibrationRecord record);

/// Work for the pool: `work` runs there (at once with kCallersThread), `then` on the receiver's thread unless it is gone.
template <class Work, class Then>
void inPool(Threading threading, QObject* receiver, Work work, Then then) {
    if (threading == Threading::kCallersThread) {
        return then(work());
    }
    QThreadPool::globalInstance()->start([receiver = QPointer<QObject>(receiver), loop = receiver->thread(), work, then] {
        auto outcome = work();
        auto* const here = new QObject;  // the receiver may go while this thread looks at it: ask on its own thread
        here->moveToThread(loop);
        QMetaObject::invokeMethod(
            here,
            [here, receiver, then, outcome = std::move(outcome)] {
                if (receiver) {
                    then(outcome);
                }
                here->deleteLater();
            },
            Qt::QueuedConnection);
    });
}

}  // namespace pmts::app
