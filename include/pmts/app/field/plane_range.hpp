#pragma once

#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QList>
#include <QObject>

namespace pmts::app {

/// Ranges from a surface: a plane through recorded points says how far away a click or the reticle is, until it is
/// given up. Follows the station and the points it was made of.
class PlaneRange : public QObject {
    Q_OBJECT
public:
    static constexpr int kLeastPoints = 3;

    PlaneRange(RangeKeeper& range, const PointsModel& points, const StationPresenter& station, Preferences& preferences,
               MessageCentre& messages, QObject* parent = nullptr);

public Q_SLOTS:
    /// Says how well the plane fits; refused with a sentence when these points span none.
    void use(const QList<qint64>& point_rows);

private:
    void refit();
    [[nodiscard]] core::Result<geometry::PlaneFit> fit() const;

    RangeKeeper& range_;
    const PointsModel& points_;
    const StationPresenter& station_;
    Preferences& preferences_;
    MessageCentre& messages_;
    QList<qint64> rows_;
};

}  // namespace pmts::app
