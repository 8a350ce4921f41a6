#include "action_bar.hpp"

#include "field_actions.hpp"
#include "ui_action_bar.h"

namespace pmts::gui {

ActionBar::ActionBar(QWidget* parent) : QWidget(parent), ui_(std::make_unique<Ui::ActionBar>()) {
    ui_->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
}

ActionBar::~ActionBar() = default;

void ActionBar::setActions(const FieldActions& actions) {
    using Weight = ActionButton::Weight;
    ui_->capture->setAction(actions.capture);
    ui_->move->setAction(actions.move);
    ui_->measure->setAction(actions.measure);
    ui_->convert->setAction(actions.convert);
    ui_->record->setAction(actions.record);
    ui_->all->setAction(actions.all, Weight::kMain);
    const std::pair<ActionButton*, QAction*> arrows[] = {{ui_->left, actions.left},
                                                         {ui_->up, actions.up},
                                                         {ui_->down, actions.down},
                                                         {ui_->right, actions.right}};
    for (const auto& [button, action] : arrows) {
        button->setAction(action);
        button->setIconOnly(true);
    }
    ui_->step->setAction(actions.step);
    ui_->stop->setAction(actions.stop, Weight::kStop);
}

void ActionBar::showStep(const QString& step_text) { ui_->step->setText(tr("Step %1").arg(step_text)); }

}  // namespace pmts::gui
