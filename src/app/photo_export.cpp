#include "pmts/app/photo_export.hpp"

#include "pmts/app/photo_circumstances.hpp"
#include "pmts/camera/rig_json.hpp"

#include <QJsonDocument>

namespace pmts::app {

job::PhotoFile photoFileOf(const job::Photo& photo) {
    job::PhotoFile file;
    file.photo = photo;
    QJsonObject json = QJsonDocument::fromJson(photo.rig_json.toUtf8()).object();
    const PhotoCircumstances taken = circumstancesOf(json);
    file.camera = taken.camera;
    file.station = taken.station;
    if (taken.range) {
        file.slope_distance_m = taken.range->slope_distance_m;
        file.range_source = rangeSourceKey(taken.range->source);
    }
    if (const auto rig = camera::rigFromJson(json)) {
        file.focal_length_px = rig->lens.focalLengthPx();
        file.principal_x_px = rig->lens.principalPoint().x();
        file.principal_y_px = rig->lens.principalPoint().y();
        json.remove(QStringLiteral("taken"));
        file.rig = json;
    }
    return file;
}

PhotoExport::PhotoExport(JobDesk& job, MessageCentre& messages, QObject* parent)
    : QObject(parent), job_(job), messages_(messages) {
    connect(&job_, &JobDesk::photosExported, this, [this](Ticket ticket, const QString& folder, int count) {
        if (ticket == ticket_) {
            messages_.toast(count > 0 ? tr("%n photo(s) exported to %1.", nullptr, count).arg(folder)
                                      : tr("The job has no photos yet."));
        }
    });
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_) {
            messages_.report(error, MessageAction::kOpenJob, QStringLiteral("photo"));
        }
    });
}

void PhotoExport::exportTo(const QString& folder) { ticket_ = job_.exportPhotos(folder); }

}  // namespace pmts::app
