#pragma once

#include "pmts/app/device_state.hpp"

#include <QPointF>
#include <QTransform>
#include <QWidget>

class QPainter;

namespace pmts::gui {

/// One step of the laboratory: the panel at the right of the live view.
class LabStep : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0;  ///< one or two words in the list of steps
    virtual void entered() {}                         ///< it is shown now
    virtual void left() {}                            ///< another step or workspace is shown
    /// A click in the live view, pixels of the frame; false leaves it to aiming.
    virtual bool pictureClicked(const QPointF& frame_px);
    /// Now a spot under the reticle is to be clicked: nothing may be drawn over it.
    [[nodiscard]] virtual bool wantsClearCentre() const { return false; }
    /// Over the live view, after its own overlay.
    virtual void paintOver(QPainter& painter, const QTransform& widget_from_frame);

Q_SIGNALS:
    void overlayChanged();
    void stateChanged(pmts::app::DeviceState state);  ///< lamp beside the title
};

}  // namespace pmts::gui
