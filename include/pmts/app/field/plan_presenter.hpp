#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/field/planned_points_model.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace pmts::app {

/// A symbol of the plan. `position` is (E, N) in metres: the widget flips y.
struct PlanPoint {
    QPointF position_en_m;
    QString id;
    QString code;
    qint64 row_id = 0;
    bool absurd = false;
};

struct PlanScene {
    std::vector<PlanPoint> points;  ///< struck-out ones and those without coordinates are left out
    std::vector<PlanPoint> planned;  ///< of the design; their row numbers are of another table
    QPointF station_en_m;
    QString station_name;
    /// End of the line of sight: the present bearing, as long as the range.
    std::optional<QPointF> sight_en_m;
};

/// What the plan draws.
class PlanPresenter : public QObject {
    Q_OBJECT
public:
    PlanPresenter(const PointsModel& points, const PlannedPointsModel& planned, const StationPresenter& station,
                  const InstrumentDesk& instrument, const RangeKeeper& range, QObject* parent = nullptr);

    [[nodiscard]] PlanScene scene() const;

Q_SIGNALS:
    void changed();       ///< points, planned points or station
    void sightChanged();  ///< the line of sight only: up to 10 times a second

private:
    [[nodiscard]] std::optional<QPointF> sight() const;

    const PointsModel& points_;
    const PlannedPointsModel& planned_;
    const StationPresenter& station_;
    const InstrumentDesk& instrument_;
    const RangeKeeper& range_;
};

}  // namespace pmts::app
