#pragma once

#include "parts/limits_dialog.hpp"
#include "pmts/app/settings/instrument_care_settings.hpp"

namespace pmts::gui {

/// When an axis test is no longer trusted (days, degrees Celsius), and what errors and faces may differ by (mgon, mm).
class AxisLimitsDialog : public LimitsDialog {
    Q_OBJECT
public:
    explicit AxisLimitsDialog(const app::InstrumentCareSettings& care, QWidget* parent = nullptr);
    /// As typed in; what the dialog does not show is as it was given.
    [[nodiscard]] app::InstrumentCareSettings care() const;

private:
    void fill(const app::InstrumentCareSettings& care);

    app::InstrumentCareSettings care_;
    QDoubleSpinBox *axis_mgon_, *age_, *temperature_, *face_mgon_, *face_mm_;
};

}  // namespace pmts::gui
