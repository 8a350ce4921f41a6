#include "still_view.hpp"

#include "live_panel.hpp"

namespace pmts::gui {

StillView::StillView(app::LivePresenter& live, app::TargetingPresenter& targeting, QWidget* parent)
    : ImageView(parent), live_(live) {
    setAccessibleName(tr("Still"));
    setObjectName(QStringLiteral("still_view"));
    connect(this, &ImageView::pixelClicked, &targeting, &app::TargetingPresenter::clickStillPixel);
    connect(this, &ImageView::pixelDoubleClicked, &targeting, &app::TargetingPresenter::moveToStillPixel);
    connect(&live_, &app::LivePresenter::stillCaptured, this, &StillView::showStill);
    connect(&live_, &app::LivePresenter::captureWaiting, this, &StillView::showWaiting);
    connect(&targeting, &app::TargetingPresenter::targetChanged, this, &StillView::showStill);
    showStill();
}

void StillView::showStill() {
    const auto& still = live_.still();
    if (!still) {
        setNotice(tr("No still yet. Capture (C) freezes the picture with its HA and VA."));
        return;
    }
    setFrame(still->frame);
    setOverlay(overlayOf(live_.overlayFor(still->pointing), live_.reticleFor(still->pointing), 0, {}));
    setCaption(tr("Still %1   HA %2   VA %3").arg(still->number).arg(still->ha_text, still->va_text));
    setNotice({});
}

void StillView::showWaiting(const QString& reason) {
    if (reason.isEmpty()) {
        showStill();
    } else {
        setNotice(reason);
    }
}

}  // namespace pmts::gui
