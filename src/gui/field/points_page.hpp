#pragma once

#include "pmts/app/field/points_model.hpp"

#include <QSortFilterProxyModel>
#include <QUndoStack>
#include <QWidget>

#include <memory>
#include <optional>

class QMenu;

namespace Ui {
class PointsPage;
}

namespace pmts::gui {

/// The recorded points. A double-click turns to the point; F2 or Edit changes a cell; Delete strikes out.
class PointsPage : public QWidget {
    Q_OBJECT
public:
    PointsPage(app::PointsModel& points, QUndoStack& undo, QWidget* parent = nullptr);
    ~PointsPage() override;

    void selectPoint(qint64 row_id);
    [[nodiscard]] std::optional<qint64> selectedPoint() const;

Q_SIGNALS:
    void turnRequested(qint64 row_id);
    void orientRequested(qint64 row_id);
    void evidenceRequested(qint64 row_id);
    void pointSelected(qint64 row_id);
    void planeRequested(const QList<qint64>& row_ids);  ///< ranges from the plane of these

private:
    void wireTable();
    void wireTools(QUndoStack& undo);
    void turnToCurrent();
    void editCurrent();
    void strikeSelected();
    void showMenu(const QPoint& at);
    void addOnePointEntries(QMenu& menu, qint64 row_id);
    void enableTools();
    [[nodiscard]] QList<qint64> selectedPoints() const;
    [[nodiscard]] qint64 rowIdAt(const QModelIndex& proxy_index) const;

    app::PointsModel& points_;
    QSortFilterProxyModel sorted_;
    std::unique_ptr<Ui::PointsPage> ui_;
};

}  // namespace pmts::gui
