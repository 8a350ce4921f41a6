#include "pmts/app/field/plane_range.hpp"

namespace pmts::app {

namespace {
const QString kTopic = QStringLiteral("plane");
}

PlaneRange::PlaneRange(RangeKeeper& range, const PointsModel& points, const StationPresenter& station,
                       Preferences& preferences, MessageCentre& messages, QObject* parent)
    : QObject(parent), range_(range), points_(points), station_(station), preferences_(preferences), messages_(messages) {
    connect(&points_, &PointsModel::pointsChanged, this, &PlaneRange::refit);
    connect(&station_, &StationPresenter::stationChanged, this, &PlaneRange::refit);
}

core::Result<geometry::PlaneFit> PlaneRange::fit() const {
    std::vector<Eigen::Vector3d> places;
    for (const qint64 row : rows_) {
        const survey::Point* const point = points_.find(row);
        if (point && hasCoordinates(*point) && !point->struck_out) {
            const survey::Coordinates& at = point->coordinates;
            places.push_back(survey::stationFrameFromGround(station_.station(), at.e_m, at.n_m, at.h_m,
                                                            point->observation.target_height_m));
        }
    }
    return geometry::fitPlane(places);
}

void PlaneRange::use(const QList<qint64>& point_rows) {
    const QList<qint64> before = std::exchange(rows_, point_rows);
    const auto plane = fit();
    if (!plane) {
        rows_ = before;
        messages_.report(plane.error(), MessageAction::kNone, kTopic);
        return;
    }
    messages_.solve(kTopic);
    range_.setPlane(plane->plane);
    const auto count = static_cast<int>(plane->residuals_m.size());
    messages_.toast(count == kLeastPoints ? tr("Ranges come from the plane of 3 points; a fourth would check it.")
                                          : tr("Ranges come from the plane of %1 points, %2 rms.")
                                                .arg(count)
                                                .arg(preferences_.units().precision(plane->rms_m)));
}

/// A plane that its points no longer span is given up.
void PlaneRange::refit() {
    if (!range_.plane()) {
        rows_.clear();
        return;
    }
    const auto plane = fit();
    range_.setPlane(plane ? std::optional(plane->plane) : std::nullopt);
}

}  // namespace pmts::app
