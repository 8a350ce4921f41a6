#include "rig_limits_dialog.hpp"

#include <QDoubleSpinBox>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kMgonPerGon = 1000.0;

}  // namespace

RigLimitsDialog::RigLimitsDialog(const app::RigCareSettings& care, QWidget* parent)
    : LimitsDialog(tr("Limits of a calibration"), parent), care_(care) {
    addHeading(tr("Warn when the calibration"));
    age_ = addField(tr("is older than"), "limit_age", 1, 3650, 0, tr(" days"));
    temperature_ = addField(tr("was made warmer or colder by"), "limit_temperature", 1, 100, 0, tr(" °C"));
    addHeading(tr("A check fails above"));
    check_px_ = addField(tr("rms in the picture"), "limit_check_px", 0.05, 100, 2, tr(" px"));
    check_mgon_ = addField(tr("rms of the direction"), "limit_check_mgon", 0.1, 10000, 1, tr(" mgon"));
    addHeading(tr("A knock is suspected when clicks miss"));
    knock_px_ = addField(tr("by (median)"), "limit_knock_px", 0.5, 500, 1, tr(" px"));
    knock_moves_ = addField(tr("in the last"), "limit_knock_moves", 3, 50, 0, tr(" moves"));
    connect(this, &LimitsDialog::defaultsAsked, this, [this] { fill(app::RigCareSettings{}); });
    fill(care);
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
