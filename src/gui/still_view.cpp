#include "still_view.hpp"

#include "live_panel.hpp"

namespace pmts::gui {

StillView::StillView(app::LivePresenter& live, QWidget* parent) : ImageView(parent), live_(live) {
    setAccessibleName(tr("Still"));
    setObjectName(QStringLiteral("still_view"));
    connect(&live_, &app::LivePresenter::stillCaptured, this, &StillView::showStill);
    connect(&live_, &app::LivePresenter::captureWaiting, this, &StillView::showWaiting);
    connect(&live_, &app::LivePresenter::placesChanged, this, &StillView::showStill);
    showStill();
}

void StillView::showStill() {
    const auto& still = live_.still();
    if (!still) {
        setNotice(tr("No still yet. Capture (C) freezes the picture with its HA and VA."));
        return;
    }
    setFrame(still->frame);
    ImageOverlay overlay =
        overlayOf(live_.overlayFor(still->pointing), live_.reticleFor(still->pointing), selected_row_id_, {});
    addParallax(overlay, live_.parallaxFor(still->pointing));
    setOverlay(std::move(overlay));
    setCaption(tr("Still %1   HA %2   VA %3").arg(still->number).arg(still->ha_text, still->va_text));
    setNotice({});
    Q_EMIT overlayChanged();
}

void StillView::selectPoint(qint64 row_id) {
    selected_row_id_ = row_id;
    showStill();
}

void StillView::showWaiting(const QString& reason) {
    if (reason.isEmpty()) {
        showStill();
    } else {
        setNotice(reason);
    }
}

}  // namespace pmts::gui
