#pragma once

#include "parts/limits_dialog.hpp"
#include "pmts/app/settings/rig_care_settings.hpp"

namespace pmts::gui {

/// When a calibration is no longer trusted (days, degrees Celsius) and what a check and clicked moves may leave over (px, mgon).
class RigLimitsDialog : public LimitsDialog {
    Q_OBJECT
public:
    explicit RigLimitsDialog(const app::RigCareSettings& care, QWidget* parent = nullptr);
    /// As typed in; what the dialog does not show is as it was given.
    [[nodiscard]] app::RigCareSettings care() const;

private:
    void fill(const app::RigCareSettings& care);

    app::RigCareSettings care_;
    QDoubleSpinBox *age_, *temperature_, *check_px_, *check_mgon_, *knock_px_, *knock_moves_;
};

}  // namespace pmts::gui
