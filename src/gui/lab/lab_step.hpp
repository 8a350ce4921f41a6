#pragma once

#include "window/listed_page.hpp"

#include <QPointF>
#include <QTransform>

class QPainter;

namespace pmts::gui {

/// One step of the laboratory: the panel at the right of the live view.
class LabStep : public ListedPage {
    Q_OBJECT
public:
    using ListedPage::ListedPage;

    /// A click in the live view, pixels of the frame; false leaves it to aiming.
    virtual bool pictureClicked(const QPointF& frame_px);
    /// Now a spot under the reticle is to be clicked: nothing may be drawn over it.
    [[nodiscard]] virtual bool wantsClearCentre() const { return false; }
    /// Over the live view, after its own overlay.
    virtual void paintOver(QPainter& painter, const QTransform& widget_from_frame);

Q_SIGNALS:
    void overlayChanged();
};

}  // namespace pmts::gui
