#include "path_switch_box.hpp"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

namespace pmts::gui {
namespace {

constexpr int kTick_px = 36;

}  // namespace

PathSwitchBox::PathSwitchBox(QWidget* parent) : QGroupBox(tr("Switch box on the instrument's port"), parent) {
    auto* const grid = new QGridLayout(this);
    auto* const help = new QLabel(tr("Lines that are asserted, by mode"), this);
    help->setWordWrap(true);
    grid->addWidget(help, 0, 0);
    int column = 1;
    for (const auto mode : app::ControlPresenter::modes()) {
        grid->addWidget(new QLabel(app::ControlPresenter::modeName(mode), this), 0, column++);
    }
    dtr_ = addLine(tr("DTR drives it"), "dtr", *grid, 1);
    rts_ = addLine(tr("RTS drives it"), "rts", *grid, 2);
    inverted_ = addTick(tr("Inverted: the box takes an asserted line for off"), QStringLiteral("switch_inverted"));
    grid->addWidget(inverted_, 3, 0, 1, 4);
    grid->setColumnStretch(0, 1);
    showSwitch({});
}

QCheckBox* PathSwitchBox::addTick(const QString& text, const QString& object_name) {
    auto* const tick = new QCheckBox(text, this);
    tick->setObjectName(object_name);
    tick->setMinimumHeight(kTick_px);
    connect(tick, &QCheckBox::clicked, this, &PathSwitchBox::tell);
    return tick;
}

PathSwitchBox::Line PathSwitchBox::addLine(const QString& name, const char* object_name, QGridLayout& grid, int row) {
    const QString base = QString::fromLatin1(object_name);
    Line line{.used = addTick(name, base), .modes = {}};
    grid.addWidget(line.used, row, 0);
    const auto modes = app::ControlPresenter::modes();
    for (std::size_t i = 0; i < line.modes.size(); ++i) {
        line.modes.at(i) = addTick({}, QStringLiteral("%1_in_mode_%2").arg(base).arg(i + 1));
        line.modes.at(i)->setAccessibleName(tr("%1 asserted in mode %2").arg(base.toUpper(), app::ControlPresenter::modeName(modes[i])));
        grid.addWidget(line.modes.at(i), row, static_cast<int>(i) + 1, Qt::AlignHCenter);
    }
    return line;
}

void PathSwitchBox::showLine(const Line& line, const std::optional<instrument::LineInModes>& modes) {
    const instrument::LineInModes shown = modes.value_or(instrument::LineInModes{});
    line.used->setChecked(modes.has_value());
    line.modes[0]->setChecked(shown.shared);
    line.modes[1]->setChecked(shown.computer);
    line.modes[2]->setChecked(shown.panel);
    for (QCheckBox* const tick : line.modes) {
        tick->setEnabled(modes.has_value());
    }
}

void PathSwitchBox::showSwitch(const instrument::PathSwitch& path_switch) {
    showLine(dtr_, path_switch.dtr);
    showLine(rts_, path_switch.rts);
    inverted_->setChecked(path_switch.inverted);
    inverted_->setEnabled(path_switch.dtr || path_switch.rts);
}

std::optional<instrument::LineInModes> PathSwitchBox::lineFrom(const Line& line) {
    if (!line.used->isChecked()) {
        return std::nullopt;
    }
    return instrument::LineInModes{.shared = line.modes[0]->isChecked(),
                                   .computer = line.modes[1]->isChecked(),
                                   .panel = line.modes[2]->isChecked()};
}

void PathSwitchBox::tell() {
    const instrument::PathSwitch path_switch{.dtr = lineFrom(dtr_), .rts = lineFrom(rts_), .inverted = inverted_->isChecked()};
    showSwitch(path_switch);
    Q_EMIT chosen(path_switch);
}

}  // namespace pmts::gui
