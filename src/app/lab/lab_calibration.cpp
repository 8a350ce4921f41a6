#include "pmts/app/lab/lab_calibration.hpp"

#include <QCoreApplication>
#include <QDateTime>

namespace pmts::app {

CameraUse cameraInUse(const LivePresenter& live) {
    CameraUse use;
    if (const video::VideoSource* const source = live.source()) {
        use.source = source->address().kind;
        use.camera = source->address().name;
    }
    if (const auto& frame = live.scene().frame) {
        use.size = QSize(frame->image.cols, frame->image.rows);
    }
    return use;
}

QString keepMeasuredRig(const LivePresenter& live, Preferences& preferences, MessageCentre& messages, const camera::Rig& rig,
                        CalibrationRecord record) {
    record.utc = QDateTime::currentDateTimeUtc();
    record.camera = cameraInUse(live);
    const QString name = preferences.acceptRig(rig, record);
    messages.toast(QCoreApplication::translate("LabCalibration", "The calibration (%1) is kept in the rig profile %2.").arg(methodText(record.method), name));
    return name;
}

}  // namespace pmts::app
