#include "limits_dialog.hpp"

#include "lab_parts.hpp"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

namespace pmts::gui {
namespace {

constexpr int kField_px = 150;

}  // namespace

LimitsDialog::LimitsDialog(const QString& title, QWidget* parent) : QDialog(parent), form_(new QFormLayout) {
    setWindowTitle(title);
    auto* const column = new QVBoxLayout(this);
    column->addLayout(form_);
    auto* const buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    for (QAbstractButton* button : buttons->buttons()) {
        button->setMinimumHeight(ActionButton::kLeastSide_px);
    }
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, &LimitsDialog::defaultsAsked);
}

void LimitsDialog::addHeading(const QString& text) { form_->addRow(labHeading(text, this)); }

QDoubleSpinBox* LimitsDialog::addField(const QString& name, const char* object_name, double least, double most, int decimals,
                                       const QString& unit) {
    auto* const field = new QDoubleSpinBox(this);
    field->setObjectName(QLatin1String(object_name));
    field->setAccessibleName(name);
    field->setDecimals(decimals);
    field->setRange(least, most);
    field->setSuffix(unit);
    field->setMinimumSize(kField_px, ActionButton::kLeastSide_px);
    form_->addRow(name, field);
    return field;
}

}  // namespace pmts::gui
