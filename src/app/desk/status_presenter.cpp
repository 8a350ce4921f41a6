#include "pmts/app/desk/status_presenter.hpp"

namespace pmts::app {

namespace {

using namespace std::chrono_literals;

constexpr core::Duration kShowBusyAfter = 300ms;
constexpr core::Duration kShowUsualAfter = 2s;

QString activityText(instrument::Activity activity) {
    switch (activity) {
        case instrument::Activity::kIdle: return {};
        case instrument::Activity::kConnecting: return StatusPresenter::tr("Connecting");
        case instrument::Activity::kTurning: return StatusPresenter::tr("Turning");
        case instrument::Activity::kMeasuring: return StatusPresenter::tr("Measuring");
        case instrument::Activity::kReading: return StatusPresenter::tr("Reading");
    }
    return {};
}

QString busyText(const instrument::Progress& progress) {
    const QString what = activityText(progress.activity);
    if (progress.elapsed < kShowUsualAfter || !progress.usual) {
        return what;
    }
    const double usual_s = std::chrono::duration<double>(*progress.usual).count();
    return StatusPresenter::tr("%1, usually %2 s").arg(what).arg(usual_s, 0, 'f', 1);
}

StatusItem jobItem(const JobPresenter& job) {
    if (!job.isOpen()) {
        return {.state = DeviceState::kWarning, .text = StatusPresenter::tr("No job"),
                .details = StatusPresenter::tr("Points cannot be recorded before a job is open.")};
    }
    return {.state = DeviceState::kGood, .text = job.name(), .details = job.path()};
}

StatusItem gateItem(const core::VideoGate::Statistics& gate) {
    const double longest_ms = std::chrono::duration<double, std::milli>(gate.longest).count();
    return {.state = DeviceState::kIdle,
            .text = StatusPresenter::tr("%1 pauses").arg(gate.pauses),
            .details = StatusPresenter::tr("The video was paused %1 times for time-critical instructions, %2 ms at the longest; "
                                           "%3 frames were dropped.")
                           .arg(gate.pauses)
                           .arg(longest_ms, 0, 'f', 1)
                           .arg(gate.frames_dropped)};
}

}  // namespace

StatusPresenter::StatusPresenter(const JobPresenter& job, const StationPresenter& station,
                                 const ConnectionPresenter& connection, const LivePresenter& live,
                                 const ControlPresenter& control, const InstrumentDesk& instrument, QObject* parent)
    : QObject(parent), job_(job), station_(station), connection_(connection), live_(live), control_(control),
      instrument_(instrument) {
    connect(&job_, &JobPresenter::jobChanged, this, &StatusPresenter::refresh);
    connect(&station_, &StationPresenter::stationChanged, this, &StatusPresenter::refresh);
    connect(&connection_, &ConnectionPresenter::instrumentStatusChanged, this, &StatusPresenter::refresh);
    connect(&live_, &LivePresenter::cameraStatusChanged, this, &StatusPresenter::refresh);
    connect(&live_, &LivePresenter::statisticsChanged, this, &StatusPresenter::refresh);
    connect(&control_, &ControlPresenter::modeChanged, this, &StatusPresenter::refresh);
    connect(&control_, &ControlPresenter::shownOwnerChanged, this, &StatusPresenter::refresh);
    refresh();
}

void StatusPresenter::refresh() {
    StatusLine next;
    next.job = jobItem(job_);
    next.station = {.state = DeviceState::kGood, .text = tr("Station %1").arg(station_.station().name),
                    .details = tr("Coordinates and orientation of the instrument.")};
    next.instrument = connection_.instrumentStatus();
    next.camera = live_.cameraStatus();
    next.control = control_.barItem();
    next.gate = gateItem(live_.statistics().gate);
    const instrument::Progress& progress = instrument_.progress();
    next.busy_shown = progress.activity != instrument::Activity::kIdle && progress.elapsed >= kShowBusyAfter;
    if (next.busy_shown) {
        next.busy_text = busyText(progress);
        next.busy_fraction = progress.fraction;
    }
    if (!(next == line_)) {
        line_ = next;
        Q_EMIT changed();
    }
}

}  // namespace pmts::app
