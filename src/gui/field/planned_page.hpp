#pragma once

#include "pmts/app/field/planned_points_model.hpp"

#include <QSortFilterProxyModel>
#include <QWidget>

#include <memory>
#include <optional>

namespace Ui {
class PlannedPage;
}

namespace pmts::gui {

/// The design's points. A double-click turns to the point, Delete removes it from the job.
class PlannedPage : public QWidget {
    Q_OBJECT
public:
    explicit PlannedPage(app::PlannedPointsModel& planned, QWidget* parent = nullptr);
    ~PlannedPage() override;

    void selectPoint(qint64 row_id);
    [[nodiscard]] std::optional<qint64> selectedPoint() const;

Q_SIGNALS:
    void turnRequested(qint64 row_id);
    void pointSelected(qint64 row_id);
    void importRequested();

private:
    void wireTable();
    void wireTools();
    void turnToCurrent();
    void removeSelected();
    void enableTools();
    [[nodiscard]] QList<qint64> selectedPoints() const;

    app::PlannedPointsModel& planned_;
    QSortFilterProxyModel sorted_;
    std::unique_ptr<Ui::PlannedPage> ui_;
};

}  // namespace pmts::gui
