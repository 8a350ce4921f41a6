#include "rig_limits_dialog.hpp"

#include "lab_parts.hpp"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kMgonPerGon = 1000.0;
constexpr int kField_px = 150;

}  // namespace

RigLimitsDialog::RigLimitsDialog(const app::RigCareSettings& care, QWidget* parent) : QDialog(parent), care_(care) {
    setWindowTitle(tr("Limits of a calibration"));
    auto* const column = new QVBoxLayout(this);
    auto* const form = new QFormLayout;
    form->addRow(labHeading(tr("Warn when the calibration"), this));
    age_ = addField(*form, tr("is older than"), "limit_age", 1, 3650, 0, tr(" days"));
    temperature_ = addField(*form, tr("was made warmer or colder by"), "limit_temperature", 1, 100, 0, tr(" °C"));
    form->addRow(labHeading(tr("A check fails above"), this));
    check_px_ = addField(*form, tr("rms in the picture"), "limit_check_px", 0.05, 100, 2, tr(" px"));
    check_mgon_ = addField(*form, tr("rms of the direction"), "limit_check_mgon", 0.1, 10000, 1, tr(" mgon"));
    form->addRow(labHeading(tr("A knock is suspected when clicks miss"), this));
    knock_px_ = addField(*form, tr("by (median)"), "limit_knock_px", 0.5, 500, 1, tr(" px"));
    knock_moves_ = addField(*form, tr("in the last"), "limit_knock_moves", 3, 50, 0, tr(" moves"));
    column->addLayout(form);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    for (QAbstractButton* button : buttons->buttons()) {
        button->setMinimumHeight(ActionButton::kLeastSide_px);
    }
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] { fill(app::RigCareSettings{}); });
    fill(care);
}

QDoubleSpinBox* RigLimitsDialog::addField(QFormLayout& form, const QString& name, const char* object_name, double least, double most,
                                          int decimals, const QString& unit) {
    auto* const field = new QDoubleSpinBox(this);
    field->setObjectName(QLatin1String(object_name));
    field->setAccessibleName(name);
    field->setDecimals(decimals);
    field->setRange(least, most);
    field->setSuffix(unit);
    field->setMinimumSize(kField_px, ActionButton::kLeastSide_px);
    form.addRow(name, field);
    return field;
}

void RigLimitsDialog::fill(const app::RigCareSettings& care) {
    age_->setValue(care.age_limit_days);
    temperature_->setValue(care.temperature_limit_c);
    check_px_->setValue(care.check_limit_px);
    check_mgon_->setValue(care.check_limit.gon() * kMgonPerGon);
    knock_px_->setValue(care.knock_limit_px);
    knock_moves_->setValue(care.knock_moves);
}

app::RigCareSettings RigLimitsDialog::care() const {
    app::RigCareSettings care = care_;
    care.age_limit_days = static_cast<int>(std::lround(age_->value()));
    care.temperature_limit_c = temperature_->value();
    care.check_limit_px = check_px_->value();
    care.check_limit = core::Angle::fromGon(check_mgon_->value() / kMgonPerGon);
    care.knock_limit_px = knock_px_->value();
    care.knock_moves = static_cast<int>(std::lround(knock_moves_->value()));
    return care;
}

}  // namespace pmts::gui
