#include "pmts/app/field/photo_export.hpp"

#include "pmts/app/field/photo_circumstances.hpp"
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
    connect(&job_, &JobDesk::photosListed, this, [this](Ticket ticket, const std::vector<job::Photo>& photos) {
        if (ticket == ticket_) {
            photos_ = photos;
            next();
        }
    });
    connect(&job_, &JobDesk::photoExported, this, [this](Ticket ticket) {
        if (ticket == ticket_) {
            ++done_;
            next();
        }
    });
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_) {
            fail(error);
        }
    });
    connect(&job_, &JobDesk::opened, this, &PhotoExport::cancel);  // row numbers belong to the job before
    connect(&job_, &JobDesk::closed, this, &PhotoExport::cancel);
}

void PhotoExport::exportTo(const QString& folder) {
    if (isRunning()) {
        messages_.toast(tr("Photos are being exported already."));
        return;
    }
    folder_ = folder;
    photos_.clear();
    done_ = 0;
    is_cancelled_ = false;
    ticket_ = job_.listPhotos();
    Q_EMIT progressed();
}

void PhotoExport::next() {
    if (is_cancelled_ || done_ == photos_.size()) {
        return finish();
    }
    ticket_ = job_.exportPhoto(photos_[done_], folder_);
    Q_EMIT progressed();
}

void PhotoExport::finish() {
    ticket_ = 0;
    if (done_ < photos_.size()) {
        messages_.toast(tr("Export cancelled: %1 of %2 photos are in %3.").arg(done_).arg(count()).arg(folder_));
    } else if (photos_.empty()) {
        messages_.toast(is_cancelled_ ? tr("Export cancelled.") : tr("The job has no photos yet."));
    } else {
        messages_.toast(tr("%n photo(s) exported to %1.", nullptr, static_cast<int>(done_)).arg(folder_));
    }
    Q_EMIT progressed();
}

void PhotoExport::cancel() { is_cancelled_ = true; }

void PhotoExport::fail(core::Error error) {
    if (error.kind == core::ErrorKind::kCancelled) {
        return finish();
    }
    ticket_ = 0;
    if (done_ > 0) {
        error.happened += u' ' + tr("%1 of %2 photos were written before.").arg(done_).arg(count());
    }
    messages_.report(error, job_.isOpen() ? MessageAction::kNone : MessageAction::kOpenJob, QStringLiteral("photo"));
    Q_EMIT progressed();
}

}  // namespace pmts::app
