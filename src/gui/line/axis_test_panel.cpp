#include "axis_test_panel.hpp"

#include "parts/lab_parts.hpp"
#include "pmts/app/field/method_page.hpp"
#include "parts/state_lamp.hpp"
#include "parts/text_table.hpp"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTableWidget>

namespace pmts::gui {
namespace {

QString bothLines(const app::StatusItem& item) {
    return item.details.isEmpty() ? item.text : item.text + u'\n' + item.details;
}

}  // namespace

AxisTestPanel::AxisTestPanel(app::AxisTestPresenter& test, QWidget* parent)
    : QWidget(parent),
      test_(test),
      kept_lamp_(new StateLamp(this)),
      kept_(labText("axis_kept", this)),
      lamp_(new StateLamp(this)),
      instruction_(labText("axis_instruction", this)),
      table_(new QTableWidget(this)),
      result_(labText("axis_result", this)),
      temperature_(new QLineEdit(this)),
      temperature_text_(labText("axis_temperature_text", this)),
      take_(labButton(tr("Take the &pointing"), "axis_take", this)),
      turn_(labButton(tr("Tu&rn to the other face"), "axis_turn", this)),
      accept_(labButton(tr("&Accept"), "axis_accept", this)),
      discard_(labButton(tr("&Discard"), "axis_discard", this)),
      cancel_(labButton(tr("Ca&ncel"), "axis_cancel", this)) {
    auto* const column = new QVBoxLayout(this);
    auto* const kept_row = new QHBoxLayout;
    kept_row->addWidget(kept_lamp_, 0, Qt::AlignTop);
    kept_row->addWidget(kept_, 1);
    auto* const result_row = new QHBoxLayout;
    result_row->addWidget(lamp_, 0, Qt::AlignTop);
    result_row->addWidget(result_, 1);
    QFont bold = instruction_->font();
    bold.setBold(true);
    instruction_->setFont(bold);
    table_->setObjectName(QStringLiteral("axis_pairs"));
    table_->setAccessibleName(tr("Pairs of pointings"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    auto* const steps = new QHBoxLayout;
    steps->addWidget(take_);
    steps->addWidget(turn_);
    steps->addWidget(cancel_);
    auto* const ends = new QHBoxLayout;
    ends->addWidget(accept_);
    ends->addWidget(discard_);
    column->addLayout(kept_row);
    column->addWidget(instruction_);
    column->addLayout(steps);
    column->addWidget(table_, 1);
    column->addLayout(result_row);
    column->addLayout(makeTemperature());
    column->addLayout(ends);
    connect(take_, &QPushButton::clicked, &test_, &app::AxisTestPresenter::take);
    connect(turn_, &QPushButton::clicked, &test_, &app::AxisTestPresenter::turnToOther);
    connect(accept_, &QPushButton::clicked, &test_, &app::AxisTestPresenter::accept);
    connect(discard_, &QPushButton::clicked, &test_, &app::AxisTestPresenter::discard);
    connect(cancel_, &QPushButton::clicked, &test_, &app::AxisTestPresenter::cancel);
    connect(&test_, &app::AxisTestPresenter::changed, this, &AxisTestPanel::showAll);
    showAll();
}

QLayout* AxisTestPanel::makeTemperature() {
    constexpr int kWidth_px = 100;
    auto* const row = new QHBoxLayout;
    auto* const name = new QLabel(tr("&Temperature, °C"), this);
    name->setBuddy(temperature_);
    temperature_->setObjectName(QStringLiteral("axis_temperature"));
    temperature_->setMinimumHeight(ActionButton::kLeastSide_px);
    temperature_->setFixedWidth(kWidth_px);
    temperature_->setToolTip(tr("In place of what the instrument says; empty: what the instrument says."));
    connect(temperature_, &QLineEdit::editingFinished, &test_,
            [this] { test_.typeTemperature(temperature_->text()); });
    row->addWidget(name);
    row->addWidget(temperature_);
    row->addWidget(temperature_text_, 1);
    return row;
}

void AxisTestPanel::showAll() {
    const app::StatusItem kept = test_.kept(), result = test_.resultState();
    const bool busy = test_.isReading() || test_.isTurning();
    kept_lamp_->setState(kept.state);
    kept_->setText(bothLines(kept));
    instruction_->setText(test_.instruction());
    lamp_->setState(busy ? app::DeviceState::kBusy : result.state);
    result_->setText(bothLines(result));
    take_->setEnabled(!busy);
    turn_->setEnabled(!busy);
    cancel_->setEnabled(busy);
    accept_->setEnabled(!busy && test_.canAccept());
    temperature_text_->setText(test_.temperatureText());
    if (!temperature_->hasFocus()) {  // what is being typed stays
        temperature_->setText(test_.typedTemperature());
    }
    discard_->setEnabled(!busy && !test_.isEmpty());
    app::TextTable texts;
    texts.header = test_.headers();
    texts.rows = test_.rows();
    texts.plain_rows = static_cast<int>(texts.rows.size());
    showTexts(*table_, texts);
}

}  // namespace pmts::gui
