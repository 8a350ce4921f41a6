#pragma once

#include "lab_step.hpp"
#include "pmts/app/lab/check_presenter.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

/// The one-minute check against a known place.
class CheckStep : public LabStep {
    Q_OBJECT
public:
    CheckStep(app::CheckPresenter& check, app::ProfilesPresenter& profiles, const app::PointsModel& points, QWidget* parent = nullptr);
    [[nodiscard]] QString title() const override { return tr("Check"); }
    bool pictureClicked(const QPointF& frame_px) override;
    [[nodiscard]] bool wantsClearCentre() const override;
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void fillPoints();
    void choosePlace(int index);
    void showAll();
    void showHistory();

    app::CheckPresenter& check_;
    app::ProfilesPresenter& profiles_;
    const app::PointsModel& points_;
    QComboBox* place_;
    QLabel *step_, *verdict_, *concerns_;
    QPushButton *telescope_, *run_, *hand_, *cancel_;
    QTableWidget* history_;
};

}  // namespace pmts::gui
