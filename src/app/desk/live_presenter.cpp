#include "pmts/app/desk/live_presenter.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

const QString kCameraTopic = QStringLiteral("camera");

double milliseconds(core::Duration span) { return std::chrono::duration<double, std::milli>(span).count(); }

double medianOf(std::vector<double> sample) {
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    return *middle;
}

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
