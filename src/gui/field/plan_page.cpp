#include "plan_page.hpp"

#include "parts/line_icon.hpp"
#include "ui_plan_page.h"

namespace pmts::gui {
namespace {

constexpr double kZoomStep = 1.5;

}  // namespace

PlanPage::PlanPage(app::PlanPresenter& plan, app::Preferences& preferences, QWidget* parent)
    : QWidget(parent), ui_(std::make_unique<Ui::PlanPage>()) {
    ui_->setupUi(this);
    ui_->zoom_in->setIcon(lineIcon(QStringLiteral("zoom-in")));
    ui_->zoom_out->setIcon(lineIcon(QStringLiteral("zoom-out")));
    ui_->fit->setIcon(lineIcon(QStringLiteral("fit")));
    PlanView* const view = ui_->plan;
    connect(ui_->zoom_in, &QToolButton::clicked, view, [view] { view->zoomBy(kZoomStep); });
    connect(ui_->zoom_out, &QToolButton::clicked, view, [view] { view->zoomBy(1 / kZoomStep); });
    connect(ui_->fit, &QToolButton::clicked, view, &PlanView::fit);
    connect(view, &PlanView::hovered, ui_->readout, &QLabel::setText);
    connect(view, &PlanView::pointClicked, this, &PlanPage::pointSelected);
    connect(view, &PlanView::pointDoubleClicked, this, &PlanPage::turnRequested);
    connect(view, &PlanView::plannedClicked, this, &PlanPage::plannedSelected);
    connect(view, &PlanView::plannedDoubleClicked, this, &PlanPage::plannedTurnRequested);
    const auto show = [view, &plan] { view->showScene(plan.scene()); };
    connect(&plan, &app::PlanPresenter::changed, view, show);
    connect(&plan, &app::PlanPresenter::sightChanged, view, show);
    connect(&preferences, &app::Preferences::unitsChanged, view, &PlanView::setUnits);
    view->setUnits(preferences.units());
    show();
}

PlanPage::~PlanPage() = default;

void PlanPage::selectPoint(qint64 row_id) { ui_->plan->selectPoint(row_id); }

void PlanPage::selectPlanned(qint64 row_id) { ui_->plan->selectPlanned(row_id); }

}  // namespace pmts::gui
