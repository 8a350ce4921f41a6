#pragma once

#include "pmts/app/field/range_presenter.hpp"

#include <QDialog>

#include <memory>

namespace Ui {
class RangeDialog;
}

namespace pmts::gui {

class QuantityEdit;

/// The range a click and the reticle are for: what is in use, the assumed one, and the ends of the parallax
/// curve.
class RangeDialog : public QDialog {
    Q_OBJECT
public:
    RangeDialog(app::RangePresenter& ranges, const app::UnitFormat& units, QWidget* parent = nullptr);
    ~RangeDialog() override;

private:
    void showInUse();
    void showRejection(app::RangePresenter::Field field, const core::Error& error);
    [[nodiscard]] QuantityEdit* editOf(app::RangePresenter::Field field) const;

    app::RangePresenter& ranges_;
    std::unique_ptr<Ui::RangeDialog> ui_;
};

}  // namespace pmts::gui
