#include "pmts/app/field/plan_presenter.hpp"

namespace pmts::app {

PlanPresenter::PlanPresenter(const PointsModel& points, const PlannedPointsModel& planned, const StationPresenter& station,
                             const InstrumentDesk& instrument, const RangeKeeper& range, QObject* parent)
    : QObject(parent), points_(points), planned_(planned), station_(station), instrument_(instrument), range_(range) {
    connect(&points_, &PointsModel::pointsChanged, this, &PlanPresenter::changed);
    connect(&planned_, &PlannedPointsModel::plannedChanged, this, &PlanPresenter::changed);
    connect(&station_, &StationPresenter::stationChanged, this, &PlanPresenter::changed);
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &PlanPresenter::sightChanged);
    connect(&range_, &RangeKeeper::changed, this, &PlanPresenter::sightChanged);
}

PlanScene PlanPresenter::scene() const {
    const survey::Station& station = station_.station();
    PlanScene scene{.points = {}, .planned = {}, .station_en_m = {station.e_m, station.n_m}, .station_name = station.name, .sight_en_m = sight()};
    for (const survey::Point& point : points_.points()) {
        if (!point.struck_out && hasCoordinates(point)) {
            scene.points.push_back({.position_en_m = {point.coordinates.e_m, point.coordinates.n_m},
                                    .id = point.id,
                                    .code = point.code,
                                    .row_id = point.row_id,
                                    .absurd = !point.observation.absurd_reason.isEmpty()});
        }
    }
    for (const survey::PlannedPoint& point : planned_.points()) {
        scene.planned.push_back({.position_en_m = {point.e_m, point.n_m}, .id = point.id, .code = point.code, .row_id = point.row_id});
    }
    return scene;
}

std::optional<QPointF> PlanPresenter::sight() const {
    const auto reading = instrument_.track().newest();
    if (!reading || instrument_.connectionState() != ConnectionState::kConnected) {
        return std::nullopt;
    }
    survey::Observation sight;
    sight.pointing = reading->pointing;
    sight.slope_distance_m = range_.rangeAt(reading->pointing).slope_distance_m;
    const auto end = survey::coordinatesOf(station_.station(), sight, survey::InstrumentAccuracy{});
    return end ? std::optional(QPointF(end->e_m, end->n_m)) : std::nullopt;
}

}  // namespace pmts::app
