#include "axis_limits_dialog.hpp"

#include <QDoubleSpinBox>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kMmPerM = 1000.0;

}  // namespace

AxisLimitsDialog::AxisLimitsDialog(const app::InstrumentCareSettings& care, QWidget* parent)
    : LimitsDialog(tr("Limits of axes and faces"), parent), care_(care) {
    addHeading(tr("Have the instrument adjusted above"));
    axis_mgon_ = addField(tr("collimation and index"), "limit_axis", 0.5, 1000, 1, tr(" mgon"));
    addHeading(tr("Warn when the test of the axes"));
    age_ = addField(tr("is older than"), "limit_axis_age", 1, 3650, 0, tr(" days"));
    temperature_ = addField(tr("was made warmer or colder by"), "limit_axis_temperature", 1, 100, 0, tr(" °C"));
    addHeading(tr("Warn when both faces of a point differ by more than"));
    face_mgon_ = addField(tr("angles, less the tested errors"), "limit_face_angle", 0.1, 1000, 1, tr(" mgon"));
    face_mm_ = addField(tr("distances, each from their mean"), "limit_face_distance", 0.1, 1000, 1, tr(" mm"));
    connect(this, &LimitsDialog::defaultsAsked, this, [this] { fill(app::InstrumentCareSettings{}); });
    fill(care);
}

void AxisLimitsDialog::fill(const app::InstrumentCareSettings& care) {
    axis_mgon_->setValue(care.axis_limit.mgon());
    age_->setValue(care.expires_days);
    temperature_->setValue(care.expires_degc);
    face_mgon_->setValue(care.face_limit.mgon());
    face_mm_->setValue(care.face_limit_m * kMmPerM);
}

app::InstrumentCareSettings AxisLimitsDialog::care() const {
    app::InstrumentCareSettings care = care_;
    care.axis_limit = core::Angle::fromMgon(axis_mgon_->value());
    care.expires_days = static_cast<int>(std::lround(age_->value()));
    care.expires_degc = temperature_->value();
    care.face_limit = core::Angle::fromMgon(face_mgon_->value());
    care.face_limit_m = face_mm_->value() / kMmPerM;
    return care;
}

}  // namespace pmts::gui
