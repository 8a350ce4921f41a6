#pragma once

#include "pmts/app/field/plan_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QWidget>

#include <memory>

namespace Ui {
class PlanPage;
}

namespace pmts::gui {

/// The plan with its readout and zoom buttons.
class PlanPage : public QWidget {
    Q_OBJECT
public:
    PlanPage(app::PlanPresenter& plan, app::Preferences& preferences, QWidget* parent = nullptr);
    ~PlanPage() override;

    void selectPoint(qint64 row_id);
    void selectPlanned(qint64 row_id);

Q_SIGNALS:
    void turnRequested(qint64 row_id);
    void pointSelected(qint64 row_id);
    void plannedTurnRequested(qint64 row_id);
    void plannedSelected(qint64 row_id);

private:
    std::unique_ptr<Ui::PlanPage> ui_;
};

}  // namespace pmts::gui
