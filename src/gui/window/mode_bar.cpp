#include "mode_bar.hpp"

#include "parts/line_icon.hpp"
#include "ui_mode_bar.h"

namespace pmts::gui {

ModeBar::ModeBar(QWidget* parent) : QWidget(parent), ui_(std::make_unique<Ui::ModeBar>()) {
    ui_->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    ui_->field->setIcon(lineIcon(QStringLiteral("field")));
    ui_->lab->setIcon(lineIcon(QStringLiteral("lab")));
    ui_->line->setIcon(lineIcon(QStringLiteral("line")));
    ui_->field->setToolTip(tr("See, click, turn, measure, record (Ctrl+1)"));
    ui_->lab->setToolTip(tr("Mount, adjust and calibrate the camera (Ctrl+4)"));
    ui_->line->setToolTip(tr("What goes over the line, and the log (Ctrl+5)"));
    connect(ui_->field, &QToolButton::clicked, this, [this] { Q_EMIT modeChosen(Mode::kField); });
    connect(ui_->lab, &QToolButton::clicked, this, [this] { Q_EMIT modeChosen(Mode::kLab); });
    connect(ui_->line, &QToolButton::clicked, this, [this] { Q_EMIT modeChosen(Mode::kLine); });
    setMode(Mode::kField);
}

ModeBar::~ModeBar() = default;

void ModeBar::setMode(Mode mode) {
    QToolButton* const buttons[] = {ui_->field, ui_->lab, ui_->line};
    buttons[static_cast<int>(mode)]->setChecked(true);
}

}  // namespace pmts::gui
