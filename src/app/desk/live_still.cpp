// How the live presenter takes a photo: a picture of a telescope that stands, with its readings, kept in the job.
#include "pmts/app/desk/frame_image.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/field/photo_circumstances.hpp"
#include "pmts/camera/rig_json.hpp"
#include "pmts/camera/scaled_picture.hpp"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pmts::app {

std::optional<video::VideoFormat> LivePresenter::largestMode() const {
    const video::DeviceReport report = source_ ? source_->report() : video::DeviceReport{};
    const auto pixels = [](const video::VideoFormat& format) { return qint64{format.size.width()} * format.size.height(); };
    const auto largest = std::ranges::max_element(report.formats, {}, pixels);
    const bool is_larger = largest != report.formats.end() && pixels(*largest) > pixels(report.format);
    return is_larger ? std::optional(*largest) : std::nullopt;
}

void LivePresenter::capture() {
    capture_pending_ = true;
    full_.reset();
    full_asked_ = false;
    full_mode_.reset();
    if (source_ && preferences_.settings().cameras.of(source_->address()).full_stills) {
        full_mode_ = largestMode();
    }
    candidate_ = instrument_.isTurning() ? nullptr : scene_.frame;
    waiting_reason_.clear();
    tryCapture();
}

void LivePresenter::cancelCapture() {
    capture_pending_ = false;
    candidate_.reset();
    waitFor({});
}

void LivePresenter::tryCapture() {
    if (!capture_pending_) {
        return;
    }
    if (!scene_.frame) {
        return waitFor(tr("Waiting for a picture from the camera."));
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        return waitFor(tr("Waiting for circle readings: the instrument is not connected."));
    }
    if (source_->state() == video::SourceState::kPaused || source_->state() == video::SourceState::kStopped) {
        return waitFor(tr("Waiting for a picture: the camera is paused or stopped."));
    }
    if (awaitsFullStill()) {
        return;
    }
    const auto tracked = candidate_ ? instrument_.track().at(candidate_->captured_at) : std::nullopt;
    if (tracked && tracked->settled) {
        return finishCapture(candidate_, tracked->pointing);
    }
    const auto newest = instrument_.track().newest();
    if (!candidate_ || (newest && newest->at >= candidate_->captured_at)) {
        candidate_ = scene_.frame;  // the readings around the old one do not confirm it and never will
        full_asked_ = false;        // a large one is taken again
        full_.reset();
    }
    if (instrument_.isTurning()) {
        candidate_.reset();
        waitFor(tr("Waiting until the telescope stands still."));
    }
}

/// True while the picture of the large mode is still to come; asks for it once the telescope stands.
bool LivePresenter::awaitsFullStill() {
    if (!full_mode_ || full_) {
        return false;
    }
    if (!full_asked_ && instrument_.isTurning()) {
        waitFor(tr("Waiting until the telescope stands still."));
    } else if (!full_asked_) {
        full_asked_ = true;
        waitFor(tr("Taking the photo in %1x%2.").arg(full_mode_->size.width()).arg(full_mode_->size.height()));
        source_->takeStill(*full_mode_);
    }
    return true;
}

/// On screen the photo has the size of the live view, so that a pixel of one is a pixel of the other.
void LivePresenter::takeFullStill(const video::FullStill& still) {
    if (!capture_pending_ || !full_mode_) {
        return;
    }
    full_ = still.frame;
    auto shown = std::make_shared<camera::Frame>(*still.frame);
    shown->image = camera::scaledPicture(still.frame->image, model_.rig().width_px, model_.rig().height_px);
    candidate_ = shown;
    tryCapture();
}

void LivePresenter::doWithoutFullStill(const core::Error& error) {
    full_mode_.reset();
    messages_.report(error, MessageAction::kOpenConnectionPage, QStringLiteral("photo"));
    tryCapture();
}

void LivePresenter::waitFor(const QString& reason) {
    if (reason != waiting_reason_) {
        waiting_reason_ = reason;
        Q_EMIT captureWaiting(reason);
    }
}

void LivePresenter::finishCapture(const camera::FramePtr& frame, const geometry::Pointing& pointing) {
    const auto frozen = std::make_shared<camera::Frame>(*frame);
    frozen->pointing = pointing;
    still_ = Still{.number = ++stills_taken_,
                   .frame = frozen,
                   .pointing = pointing,
                   .ha_text = preferences_.units().direction(pointing.ha),
                   .va_text = preferences_.units().angle(pointing.va),
                   .utc = clock_.utcNow(),
                   .photo_row_id = 0};
    cancelCapture();
    keepPhoto(*still_);
    full_.reset();
    Q_EMIT stillCaptured(*still_);
}

void LivePresenter::keepPhoto(const Still& still) {
    if (!job_.isOpen()) {
        return;
    }
    job::Photo photo;
    photo.name = tr("Photo %1").arg(still.number);
    photo.pointing = still.pointing;
    photo.station_name = station_.station().name;
    photo.utc = still.utc;
    const camera::FramePtr picture = full_ ? full_ : still.frame;
    camera::Rig rig = model_.rig();
    if (full_) {
        CameraUse use = cameraUse();
        use.size = {full_->image.cols, full_->image.rows};
        rig = preferences_.settings().rigFor(use).profile.rig;
    }
    const PhotoCircumstances taken{.camera = source_ ? source_->address().name : QString(),
                                   .range = rangeFor(still.pointing),
                                   .station = station_.station()};
    const QJsonObject pose = withCircumstances(camera::rigToJson(rig), taken);
    photo.rig_json = QString::fromUtf8(QJsonDocument(pose).toJson(QJsonDocument::Compact));
    photo_ticket_ = job_.addPhoto(photo, imageOfFrame(picture));
}

}  // namespace pmts::app
