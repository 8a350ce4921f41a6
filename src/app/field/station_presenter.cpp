#include "pmts/app/field/station_presenter.hpp"

#include "desk/job_step.hpp"

#include <algorithm>

namespace pmts::app {

/// Undoing a station puts the old one back and recomputes: also points recorded since.
class StationPresenter::StationStep : public JobStep {
public:
    StationStep(StationPresenter& presenter, survey::Station before, survey::Station after, const QString& text)
        : JobStep(text, false), presenter_(presenter), before_(std::move(before)), after_(std::move(after)) {}

private:
    Ticket write(bool forward) override { return presenter_.put(forward ? after_ : before_); }

    StationPresenter& presenter_;
    survey::Station before_;
    survey::Station after_;
};

StationPresenter::StationPresenter(JobDesk& job, PointsModel& points, const InstrumentDesk& instrument,
                                   const Preferences& preferences, MessageCentre& messages, QUndoStack& undo,
                                   QObject* parent)
    : QObject(parent), job_(job), points_(points), instrument_(instrument), preferences_(preferences), messages_(messages),
      undo_(undo) {
    connect(&job_, &JobDesk::opened, this, [this](const JobContents& contents) {
        station_ = contents.station;
        Q_EMIT stationChanged(station_);
    });
    connect(&job_, &JobDesk::stationStored, this, [this](Ticket ticket) { before_.remove(ticket); });
    connect(&job_, &JobDesk::requestFailed, this, &StationPresenter::onRequestFailed);
}

StationForm StationPresenter::form() const {
    const UnitFormat& units = preferences_.units();
    return {.name = station_.name,
            .easting = units.length(station_.e_m),
            .northing = units.length(station_.n_m),
            .height = units.length(station_.h_m),
            .instrument_height = units.length(station_.instrument_height_m),
            .orientation = units.direction(station_.orientation)};
}

QString StationPresenter::bearingText(core::Angle ha) const {
    return preferences_.units().direction(ha + station_.orientation);
}

int StationPresenter::pointsObservedHere() const {
    return static_cast<int>(std::count_if(points_.points().begin(), points_.points().end(), [this](const auto& point) {
        return point.station_name == station_.name && !point.struck_out;
    }));
}

bool StationPresenter::readLength(const QString& text, StationField field, double& value_m) {
    const auto length_m = preferences_.units().parseLengthM(text);
    if (!length_m) {
        Q_EMIT fieldRejected(field, length_m.error());
        return false;
    }
    value_m = *length_m;
    return true;
}

void StationPresenter::apply(const StationForm& form) {
    survey::Station next = station_;
    next.name = form.name.trimmed();
    if (next.name.isEmpty()) {
        Q_EMIT fieldRejected(StationField::kName, core::Error{.kind = core::ErrorKind::kBadInput,
                                                              .happened = tr("A station needs a name."),
                                                              .remedy = tr("Type one, for example 100."),
                                                              .info_code = std::nullopt,
                                                              .detail = {}});
        return;
    }
    const auto orientation = preferences_.units().parseAngle(form.orientation);
    bool all_read = readLength(form.easting, StationField::kEasting, next.e_m);
    all_read = readLength(form.northing, StationField::kNorthing, next.n_m) && all_read;
    all_read = readLength(form.height, StationField::kHeight, next.h_m) && all_read;
    all_read = readLength(form.instrument_height, StationField::kInstrumentHeight, next.instrument_height_m) && all_read;
    if (!orientation) {
        Q_EMIT fieldRejected(StationField::kOrientation, orientation.error());
        return;
    }
    next.orientation = core::normalized(*orientation);
    if (all_read) {
        change(next, tr("Set station %1").arg(next.name));
    }
}

void StationPresenter::orientByBearing(const QString& bearing_text) {
    const auto bearing = preferences_.units().parseAngle(bearing_text);
    if (!bearing) {
        Q_EMIT fieldRejected(StationField::kBearing, bearing.error());
        return;
    }
    orient(*bearing);
}

void StationPresenter::orientToCoordinates(const QString& easting_text, const QString& northing_text) {
    double e_m = 0.0;
    double n_m = 0.0;
    const bool east_read = readLength(easting_text, StationField::kKnownEasting, e_m);
    const bool north_read = readLength(northing_text, StationField::kKnownNorthing, n_m);
    if (!east_read || !north_read) {
        return;
    }
    if (e_m == station_.e_m && n_m == station_.n_m) {
        Q_EMIT fieldRejected(StationField::kKnownEasting,
                             core::Error{.kind = core::ErrorKind::kUndefined,
                                         .happened = tr("These are the coordinates of the station itself."),
                                         .remedy = tr("Enter those of the point the telescope points at."),
                                         .info_code = std::nullopt,
                                         .detail = {}});
        return;
    }
    orient(survey::bearingTo(station_, e_m, n_m));
}

void StationPresenter::orientToPoint(qint64 row_id) {
    const survey::Point* point = points_.find(row_id);
    if (point && hasCoordinates(*point)) {
        orient(survey::bearingTo(station_, point->coordinates.e_m, point->coordinates.n_m));
    }
}

void StationPresenter::orient(core::Angle bearing) {
    const auto reading = instrument_.track().newest();
    if (instrument_.connectionState() != ConnectionState::kConnected || !reading) {
        messages_.warn(tr("There is no circle reading to orient with."), tr("Connect the instrument first."),
                       MessageAction::kOpenConnectionPage, QStringLiteral("orientation"));
        return;
    }
    messages_.solve(QStringLiteral("orientation"));
    survey::Station next = station_;
    next.orientation = core::normalized(survey::orientationFor(reading->pointing.ha, bearing));
    change(next, tr("Orient station %1").arg(next.name));
}

void StationPresenter::change(const survey::Station& next, const QString& text) {
    undo_.push(new StationStep(*this, station_, next, text));
    const int moved = pointsObservedHere();
    Q_EMIT applied(moved == 0 ? tr("Station %1 is set.").arg(next.name)
                              : tr("Station %1 is set; %n point(s) recomputed.", nullptr, moved).arg(next.name));
}

std::vector<survey::Point> StationPresenter::recomputed(const survey::Station& station) const {
    std::vector<survey::Point> moved;
    for (const survey::Point& point : points_.points()) {
        if (point.station_name != station.name) {
            continue;
        }
        if (const auto coordinates = survey::coordinatesOf(station, point.observation, survey::InstrumentAccuracy{})) {
            moved.push_back(point);
            moved.back().coordinates = *coordinates;
        }
    }
    return moved;
}

Ticket StationPresenter::put(const survey::Station& station) {
    const survey::Station before = station_;
    const std::vector<survey::Point> moved = recomputed(station);
    show(station, moved);
    const Ticket ticket = job_.setStation(station, moved);
    before_.insert(ticket, before);
    return ticket;
}

void StationPresenter::show(const survey::Station& station, const std::vector<survey::Point>& moved) {
    station_ = station;
    points_.replaceCoordinates(moved);
    Q_EMIT stationChanged(station_);
}

void StationPresenter::onRequestFailed(Ticket ticket, const core::Error& error) {
    if (!before_.contains(ticket)) {
        return;
    }
    const survey::Station before = before_.take(ticket);
    if (const auto later = before_.upperBound(ticket); later != before_.end()) {
        later.value() = before;  // the later change is still shown; this is what it would be taken back to
    } else {
        show(before, recomputed(before));
    }
    takeBackRefused(undo_, ticket);
    messages_.report(error, MessageAction::kOpenJob, QStringLiteral("station"));
}

}  // namespace pmts::app
