#pragma once

#include "plot_widget.hpp"

#include <QPointF>
#include <QSize>

#include <optional>
#include <vector>

namespace pmts::gui {

/// What a calibration leaves over: where a spot was seen, and modelled less seen pixel.
struct DrawnResidual {
    enum class Role {
        kUsed,
        kLeftOut,  ///< an outlier
        kHeldOut,  ///< not used in the fit, for its test
    };
    QPointF px, residual_px;
    Role role = Role::kUsed;
    std::optional<int> spot{};  ///< from 1
};

struct DrawnResiduals {
    std::vector<DrawnResidual> residuals;
    QSize frame_px;
    QPointF centre_px;
};

/// Residuals of a calibration: as arrows over the frame, magnified by a number that is shown, or their lengths against the
/// radius. Those left out are crosses, those held out squares.
class ResidualPlot : public PlotWidget {
    Q_OBJECT
public:
    enum class Kind { kVectors, kRadius };
    explicit ResidualPlot(Kind kind, QWidget* parent = nullptr);

    void showResiduals(const DrawnResiduals& shown);
    /// `column_px,row_px,residual_x_px,residual_y_px,spot,left_out,held_out`, a line each.
    [[nodiscard]] QString csv() const override;

protected:
    void draw() override;
    [[nodiscard]] QString textAt(const QPoint& at) const override;

private:
    void drawVectors();
    void drawRadius();
    [[nodiscard]] bool has(DrawnResidual::Role role) const;
    [[nodiscard]] double magnification() const;
    [[nodiscard]] double highest() const;  ///< of the lengths shown against the radius
    [[nodiscard]] QPointF placeOf(const DrawnResidual& residual) const;

    Kind kind_;
    DrawnResiduals shown_;
};

}  // namespace pmts::gui
