#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QMainWindow>
#include <QSplitter>

namespace pmts::gui {

class FieldActions;
class DepthPopup;
class LivePanel;
class LogPage;
class Loupe;
class PictureInput;
class PictureTools;
class PlanPage;
class PlannedPage;
class PointEntry;
class PointsPage;
class ReadingsPanel;
class StillView;
class ZoomBoxPage;

/// The surveyor's workspace: live view, still and loupe in the middle, readings and pages around it as docks.
class FieldWorkspace : public QMainWindow {
    Q_OBJECT
public:
    FieldWorkspace(app::Workbench& bench, const FieldActions& actions, QWidget* parent = nullptr);

    [[nodiscard]] LivePanel& live() const { return *live_; }
    [[nodiscard]] QList<QDockWidget*> docks() const { return docks_; }
    /// Only live view and readings.
    void setFocusMode(bool on);
    /// Evidence of the selected point, else of the newest one.
    void showEvidence();
    void startTypingPoint();
    void showPage(QDockWidget* dock);
    [[nodiscard]] QDockWidget* planDock() const { return plan_dock_; }
    [[nodiscard]] QDockWidget* plannedDock() const { return planned_dock_; }
    [[nodiscard]] QDockWidget* pointsDock() const { return points_dock_; }

    [[nodiscard]] QByteArray layoutState() const;
    void restoreLayout(const QByteArray& state);

Q_SIGNALS:
    void importPlannedRequested();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void buildMiddle();
    void buildDocks();
    void wirePages();
    void wireLoupe();
    void wirePictures(const FieldActions& actions);
    void wireInput(PictureInput& input);
    void showLoupe(bool on_live, const QPointF& px);
    void refreshCopies(bool of_live);
    void openZoomBox(app::Picture picture, const QRectF& box_px);
    void openRange();
    QDockWidget* addPage(const QString& title, const QString& name, QWidget* page);
    void selectPoint(qint64 row_id);
    void turnToPoint(qint64 row_id);
    void turnToPlanned(qint64 row_id);

    app::Workbench& bench_;
    LivePanel* live_;
    StillView* still_;
    Loupe* loupe_;
    PictureTools* tools_;
    ZoomBoxPage* zoom_box_;
    DepthPopup* depth_;
    PictureInput* loupe_input_ = nullptr;
    PictureInput* zoom_box_input_ = nullptr;
    ReadingsPanel* readings_;
    PointEntry* entry_;
    PointsPage* points_;
    PlanPage* plan_;
    PlannedPage* planned_;
    QSplitter* middle_;
    QSplitter* lower_;
    QDockWidget* readings_dock_ = nullptr;
    QDockWidget* points_dock_ = nullptr;
    QDockWidget* plan_dock_ = nullptr;
    QDockWidget* planned_dock_ = nullptr;
    QDockWidget* zoom_box_dock_ = nullptr;
    QList<QDockWidget*> docks_;
    QList<QDockWidget*> hidden_by_focus_;
    bool loupe_on_live_ = false;
    bool sized_ = false;
};

}  // namespace pmts::gui
