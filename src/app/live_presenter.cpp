#include "pmts/app/live_presenter.hpp"

#include "pmts/app/frame_image.hpp"
#include "pmts/app/photo_circumstances.hpp"
#include "pmts/camera/rig_json.hpp"
#include "pmts/camera/scaled_picture.hpp"
#include "pmts/geometry/polar.hpp"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

constexpr double kMarginPx = 40.0;  ///< labels of points just outside still reach into the picture
const QString kCameraTopic = QStringLiteral("camera");

double milliseconds(core::Duration span) { return std::chrono::duration<double, std::milli>(span).count(); }

double medianOf(std::vector<double> sample) {
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    return *middle;
}

QPointF pointF(const Eigen::Vector2d& px) { return {px.x(), px.y()}; }

}  // namespace

QString rangeText(const RangeAssumption& range, const UnitFormat& units) {
    const auto say = [](const char* text) { return QCoreApplication::translate("LivePresenter", text); };
    const QString length = units.length(range.slope_distance_m);
    switch (range.source) {
        case RangeSource::kMeasured: return say("%1 (measured)").arg(length);
        case RangeSource::kPlane: return say("%1 (plane)").arg(length);
        case RangeSource::kPlanned: return say("%1 (planned)").arg(length);
        case RangeSource::kLastShot: return say("%1 (last shot)").arg(length);
        case RangeSource::kAssumed: return say("%1 (assumed)").arg(length);
    }
    return length;
}

LivePresenter::LivePresenter(InstrumentDesk& instrument, const PointsModel& points, const StationPresenter& station,
                             RangeKeeper& range, JobDesk& job, const Preferences& preferences, MessageCentre& messages,
                             core::VideoGate& gate, const core::Clock& clock, QObject* parent)
    : QObject(parent), instrument_(instrument), points_(points), station_(station), range_(range), job_(job),
      preferences_(preferences), messages_(messages), gate_(gate), clock_(clock),
      rig_choice_{.profile = preferences.settings().chosenRig(), .sentence = {}}, model_(rig_choice_.profile.rig) {
    setStatus(DeviceState::kIdle, tr("No camera"), tr("Choose a camera on the connection page."));
    connect(&points_, &PointsModel::pointsChanged, this, &LivePresenter::placePoints);
    connect(&station_, &StationPresenter::stationChanged, this, &LivePresenter::placePoints);
    connect(&range_, &RangeKeeper::changed, this, &LivePresenter::refreshPlaces);
    connect(&preferences_, &Preferences::changed, this, &LivePresenter::followPreferences);
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &LivePresenter::tryCapture);
    connect(&job_, &JobDesk::opened, this, [this](const JobContents& contents) {
        stills_taken_ = static_cast<int>(contents.photos.size());
    });
    connect(&job_, &JobDesk::photoAdded, this, [this](Ticket ticket, const job::Photo& photo) {
        if (ticket == photo_ticket_ && still_) {
            still_->photo_row_id = photo.row_id;
        }
    });
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == photo_ticket_) {
            messages_.report(error, MessageAction::kOpenJob, QStringLiteral("photo"));
        }
    });
    second_.setInterval(std::chrono::seconds(1));
    connect(&second_, &QTimer::timeout, this, &LivePresenter::updateStatistics);
    second_.start();
    refreshScene();  // the range assumption is on screen before the first frame
}

LivePresenter::~LivePresenter() = default;

void LivePresenter::setSource(std::unique_ptr<video::VideoSource> source) {
    if (source_) {
        source_->disconnect(this);
        source_->stop();
    }
    source_ = std::move(source);
    scene_.frame.reset();
    candidate_.reset();
    camera_trouble_.clear();
    followPreferences();
    if (!source_) {
        setStatus(DeviceState::kIdle, tr("No camera"), tr("Choose a camera on the connection page."));
        Q_EMIT sourceChanged();
        return refreshScene();
    }
    connect(source_.get(), &video::VideoSource::frameReady, this, &LivePresenter::takeFrame);
    connect(source_.get(), &video::VideoSource::stateChanged, this, &LivePresenter::showState);
    connect(source_.get(), &video::VideoSource::problemReported, this, [this](const core::Error& error) {
        messages_.report(error, MessageAction::kOpenConnectionPage, kCameraTopic);
        camera_trouble_ = error.sentence();
        showState(source_->state());
    });
    connect(source_.get(), &video::VideoSource::reportChanged, this, &LivePresenter::followPreferences);
    connect(source_.get(), &video::VideoSource::stillTaken, this, &LivePresenter::takeFullStill);
    connect(source_.get(), &video::VideoSource::stillFailed, this, &LivePresenter::doWithoutFullStill);
    startCamera();
    Q_EMIT sourceChanged();
}

void LivePresenter::startCamera() {
    if (source_) {
        const CameraSetting kept = preferences_.settings().cameras.of(source_->address());
        CameraUse use = cameraUse();
        use.size = {};  // whatever mode it ran in before
        const camera::Rig rig = preferences_.settings().rigFor(use).profile.rig;
        video::VideoFormat wanted;
        wanted.size = {rig.width_px, rig.height_px};
        source_->setControls(kept.controls);
        source_->start(kept.format.value_or(wanted));
        showState(source_->state());
    }
}

std::optional<video::VideoFormat> LivePresenter::largestMode() const {
    const video::DeviceReport report = source_ ? source_->report() : video::DeviceReport{};
    const auto pixels = [](const video::VideoFormat& format) { return qint64{format.size.width()} * format.size.height(); };
    const auto largest = std::ranges::max_element(report.formats, {}, pixels);
    const bool is_larger = largest != report.formats.end() && pixels(*largest) > pixels(report.format);
    return is_larger ? std::optional(*largest) : std::nullopt;
}

CameraUse LivePresenter::cameraUse() const {
    CameraUse use;
    if (!source_) {
        return use;
    }
    const video::DeviceReport report = source_->report();
    use.source = source_->address().kind;
    use.camera = source_->address().name;
    if (!report.formats.empty()) {
        use.size = report.format.size;
        use.pixel_format = report.format.pixel_format;
    }
    for (const video::CameraControlState& control : report.controls) {
        const bool is_focus = control.range.control == video::CameraControl::kFocus;
        const bool is_zoom = control.range.control == video::CameraControl::kZoom;
        if ((is_focus || is_zoom) && !control.value.automatic) {
            (is_focus ? use.focus : use.zoom) = control.value.value;
        }
    }
    return use;
}

void LivePresenter::takeFrame() {
    const camera::FramePtr newest = source_ ? source_->newestFrame() : nullptr;
    if (!newest) {
        return;
    }
    const auto tracked = instrument_.track().at(newest->captured_at);
    auto frame = std::make_shared<camera::Frame>(*newest);  // shares the pixels
    if (tracked && !frame->pointing) {
        frame->pointing = tracked->pointing;
    }
    feed_->publish(frame);
    scene_.frame = frame;
    scene_.pointing = frame->pointing;
    scene_.moving = (tracked && tracked->moving) || instrument_.isTurning();
    tryCapture();
    refreshScene();
}

void LivePresenter::placePoints() {
    placed_.clear();
    for (const survey::Point& point : points_.points()) {
        if (!point.struck_out && hasCoordinates(point)) {
            const survey::Coordinates& place = point.coordinates;
            placeGround({.kind = OverlayKind::kPoint, .p_station = {}, .label = point.id, .code = point.code,
                         .row_id = point.row_id},
                        place.e_m, place.n_m, place.h_m, point.observation.target_height_m);
        }
    }
    for (const survey::PlannedPoint& planned : planned_) {
        placeGround({.kind = OverlayKind::kPlanned, .p_station = {}, .label = planned.id, .code = planned.code,
                     .row_id = planned.row_id},
                    planned.e_m, planned.n_m, planned.h_m, 0.0);
    }
    refreshPlaces();
}

void LivePresenter::placeGround(OverlayPlace place, double e_m, double n_m, double h_m, double target_height_m) {
    place.p_station = survey::stationFrameFromGround(station_.station(), e_m, n_m, h_m, target_height_m);
    placed_.push_back(std::move(place));
}

void LivePresenter::setPlannedPoints(std::vector<survey::PlannedPoint> planned) {
    planned_ = std::move(planned);
    placePoints();
}

void LivePresenter::setExtraPlaces(std::vector<OverlayPlace> extra) {
    extra_ = std::move(extra);
    refreshPlaces();
}

std::optional<OverlayPlace> LivePresenter::placeOf(OverlayKind kind, qint64 row_id) const {
    for (const auto* places : {&placed_, &extra_}) {
        const auto found = std::ranges::find_if(
            *places, [&](const OverlayPlace& place) { return place.kind == kind && place.row_id == row_id; });
        if (found != places->end()) {
            return *found;
        }
    }
    return std::nullopt;
}

void LivePresenter::refreshPlaces() {
    refreshScene();
    Q_EMIT placesChanged();
}

void LivePresenter::refreshScene() {
    const auto newest = instrument_.track().newest();
    scene_.range = range_.rangeAt(newest ? std::optional(newest->pointing) : std::nullopt);
    scene_.range_text = rangeText(scene_.range, preferences_.units());
    scene_.reticle_px = scene_.pointing ? reticleFor(*scene_.pointing) : std::nullopt;
    scene_.overlay = scene_.pointing ? overlayFor(*scene_.pointing) : std::vector<OverlayItem>{};
    scene_.parallax = scene_.pointing ? parallaxFor(*scene_.pointing) : ParallaxCurve{};
    Q_EMIT sceneChanged();
}

bool LivePresenter::isInPicture(const Eigen::Vector2d& px) const {
    return px.x() > -kMarginPx && px.y() > -kMarginPx && px.x() < model_.rig().width_px + kMarginPx &&
           px.y() < model_.rig().height_px + kMarginPx;
}

std::vector<OverlayItem> LivePresenter::overlayFor(const geometry::Pointing& pointing) const {
    std::vector<OverlayItem> items;
    const auto draw = [&](const OverlayPlace& place) {
        if (const auto px = model_.pixelForPoint(place.p_station, pointing); px && isInPicture(*px)) {
            items.push_back({.kind = place.kind, .px = pointF(*px), .label = place.label, .code = place.code,
                             .row_id = place.row_id, .move = MoveState::kNone});
        }
    };
    const DepthFilter& depth = preferences_.settings().image_tools.depth;
    for (const OverlayPlace& place : placed_) {
        if (depth.passes(place.p_station.norm())) {
            draw(place);
        }
    }
    std::ranges::for_each(extra_, draw);
    if (target_) {
        const Eigen::Vector3d p_target =
            geometry::stationFromPolar({.pointing = *target_, .slope_distance_m = target_range_m_});
        if (const auto px = model_.pixelForPoint(p_target, pointing); px && isInPicture(*px)) {
            items.push_back({.kind = OverlayKind::kTarget, .px = pointF(*px), .label = {}, .code = {}, .row_id = 0,
                             .move = target_state_});
        }
    }
    return items;
}

/// A picture taken elsewhere has its own place on the plane; without one it shares the range in use.
RangeAssumption LivePresenter::rangeFor(const geometry::Pointing& pointing) const {
    return range_.plane() ? range_.rangeAt(pointing) : scene_.range;
}

std::optional<QPointF> LivePresenter::reticleFor(const geometry::Pointing& pointing) const {
    const auto px = model_.reticlePixel(pointing, rangeFor(pointing).slope_distance_m);
    return px ? std::optional(pointF(*px)) : std::nullopt;
}

ParallaxCurve LivePresenter::parallaxFor(const geometry::Pointing& pointing) const {
    const ImageToolSettings& tools = preferences_.settings().image_tools;
    return parallaxCurve(model_, pointing, tools.parallax_near_m, tools.parallax_far_m, rangeFor(pointing).slope_distance_m,
                         preferences_.units());
}

void LivePresenter::setTarget(const std::optional<geometry::Pointing>& target, double slope_distance_m, MoveState state) {
    target_ = target;
    target_range_m_ = slope_distance_m;
    target_state_ = state;
    refreshPlaces();
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

void LivePresenter::framePainted(core::Duration captured_at) {
    paint_latencies_ms_.push_back(milliseconds(clock_.now() - captured_at));
}

void LivePresenter::updateStatistics() {
    if (source_) {
        const video::SourceStatistics source = source_->statistics();
        statistics_.rate_hz = source.measured_rate_hz;
        statistics_.delivered = source.delivered;
        statistics_.lost = source.lost;
        statistics_.age_ms = milliseconds(source.newest_age);
        const QSize size = scene_.frame ? QSize(scene_.frame->image.cols, scene_.frame->image.rows) : QSize();
        statistics_.text = size.isEmpty()
                               ? tr("no picture yet")
                               : tr("%1x%2, %3 fps").arg(size.width()).arg(size.height()).arg(qRound(source.measured_rate_hz));
    }
    if (!paint_latencies_ms_.empty()) {
        statistics_.paint_latency_ms = medianOf(std::exchange(paint_latencies_ms_, {}));
    }
    statistics_.gate = gate_.statistics();
    if (source_ && source_->state() == video::SourceState::kRunning) {
        showState(source_->state());
    }
    Q_EMIT statisticsChanged(statistics_);
}

void LivePresenter::showState(video::SourceState state) {
    const QString name = source_ ? source_->address().name : QString();
    switch (state) {
        case video::SourceState::kStopped: return setStatus(DeviceState::kIdle, name, tr("The camera is stopped."));
        case video::SourceState::kStarting: return setStatus(DeviceState::kBusy, name, tr("The camera is starting."));
        case video::SourceState::kRunning:
            messages_.solve(kCameraTopic);
            camera_trouble_.clear();
            return setStatus(DeviceState::kGood, statistics_.text.isEmpty() ? name : statistics_.text,
                             tr("%1 delivers pictures.").arg(name));
        case video::SourceState::kPaused:
            return setStatus(DeviceState::kWarning, tr("%1: paused").arg(name), tr("The camera is paused: the picture stands still."));
        case video::SourceState::kSilent:
            return setStatus(DeviceState::kWarning, name,
                             troubleOr(tr("The camera has sent no picture for a while; it is started again.")));
        case video::SourceState::kLost:
            return setStatus(DeviceState::kFailed, name,
                             troubleOr(tr("The camera is gone; the view returns when it is plugged in again.")));
    }
}

QString LivePresenter::troubleOr(const QString& usual) const { return camera_trouble_.isEmpty() ? usual : camera_trouble_; }

void LivePresenter::setStatus(DeviceState state, const QString& text, const QString& details) {
    const StatusItem next{.state = state, .text = text, .details = details};
    if (!(next == status_)) {
        status_ = next;
        Q_EMIT cameraStatusChanged(status_);
    }
}

void LivePresenter::followPreferences() {
    const Settings& settings = preferences_.settings();
    rig_choice_ = source_ ? settings.rigFor(cameraUse()) : RigChoice{.profile = settings.chosenRig(), .sentence = {}};
    model_ = targeting::PixelToPointing(rig_choice_.profile.rig);
    refreshPlaces();
    Q_EMIT rigChoiceChanged();
}

}  // namespace pmts::app
