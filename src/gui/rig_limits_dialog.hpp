#pragma once

#include "pmts/app/rig_care_settings.hpp"

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;

namespace pmts::gui {

/// When a calibration is no longer trusted (days, degrees Celsius) and what a check and clicked moves may leave over (px, mgon).
class RigLimitsDialog : public QDialog {
    Q_OBJECT
public:
    explicit RigLimitsDialog(const app::RigCareSettings& care, QWidget* parent = nullptr);
    /// As typed in; what the dialog does not show is as it was given.
    [[nodiscard]] app::RigCareSettings care() const;

private:
    QDoubleSpinBox* addField(QFormLayout& form, const QString& name, const char* object_name, double least, double most, int decimals,
                             const QString& unit);
    void fill(const app::RigCareSettings& care);

    app::RigCareSettings care_;
    QDoubleSpinBox *age_, *temperature_, *check_px_, *check_mgon_, *knock_px_, *knock_moves_;
};

}  // namespace pmts::gui
