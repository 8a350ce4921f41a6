#pragma once

#include "pmts/app/lab/self_calibration_view.hpp"

#include <QTableWidget>

namespace pmts::gui {

/// A correlation matrix as numbers on coloured ground: the nearer to one, the fuller the colour. The full
/// names are in the tool tips, the numbers tell without colour.
class CorrelationTable : public QTableWidget {
    Q_OBJECT
public:
    explicit CorrelationTable(QWidget* parent = nullptr);

    void showView(const app::SelfCalibrationView& view);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();

    app::SelfCalibrationView view_;
};

}  // namespace pmts::gui
