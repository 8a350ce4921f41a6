#pragma once

#include "parts/pan_drag.hpp"
#include "pmts/app/field/plan_presenter.hpp"
#include "pmts/app/settings/unit_format.hpp"

#include <QTransform>
#include <QWidget>

#include <optional>

namespace pmts::gui {

/// The plan: points with labels (crosses), planned ones (diamonds), station, line of sight, north arrow,
/// scale bar. Drag pans, the wheel zooms, a click selects, a double-click asks to turn there. East is right,
/// north is up.
class PlanView : public QWidget {
    Q_OBJECT
public:
    explicit PlanView(QWidget* parent = nullptr);

    void showScene(app::PlanScene scene);
    void setUnits(const app::UnitFormat& units);
    void selectPoint(qint64 row_id);
    void selectPlanned(qint64 row_id);
    [[nodiscard]] qint64 selectedPoint() const { return selected_; }
    void fit();
    void zoomBy(double factor);

    [[nodiscard]] QPointF widgetFromGround(const QPointF& en_m) const {
        return widget_from_ground_.map(en_m);
    }
    [[nodiscard]] QPointF groundFromWidget(const QPointF& at) const {
        return widget_from_ground_.inverted().map(at);
    }

    [[nodiscard]] QSize sizeHint() const override { return {360, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

Q_SIGNALS:
    void pointClicked(qint64 row_id);
    void pointDoubleClicked(qint64 row_id);
    void plannedClicked(qint64 row_id);
    void plannedDoubleClicked(qint64 row_id);
    void hovered(const QString& text);  ///< E, N under the cursor and the point there

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    /// Null when none is near.
    [[nodiscard]] const app::PlanPoint* nearestOf(const std::vector<app::PlanPoint>& points,
                                                  const QPointF& at) const;
    void zoomAbout(const QPointF& at, double factor);
    void paintPlanned(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintStation(QPainter& painter) const;
    void paintNorth(QPainter& painter) const;
    void paintScaleBar(QPainter& painter) const;

    app::PlanScene scene_;
    app::UnitFormat units_;
    QTransform widget_from_ground_;
    bool fitted_ = true;  ///< follows its contents until somebody pans or zooms
    qint64 selected_ = 0;
    qint64 selected_planned_ = 0;
    PanDrag drag_;
};

/// The longest of 1, 2, 5 x 10^n that is not above `at_most`.
[[nodiscard]] double niceLength(double at_most);

}  // namespace pmts::gui
