#include "still_view.hpp"

#include "lab/filter_popup.hpp"
#include "parts/lab_parts.hpp"
#include "live_panel.hpp"

namespace pmts::gui {

StillView::StillView(app::LivePresenter& live, app::StillFilters& filters, QWidget* parent)
    : ImageView(parent), live_(live), filters_(filters), filter_(labButton(tr("Filter"), "still_filter", this)) {
    filter_->setToolTip(tr("Contrast, sharpness, edges and bands of the still, for the eye"));
    filter_->setFocusPolicy(Qt::NoFocus);
    auto* const popup = new FilterPopup(live, filters, this);
    connect(filter_, &QPushButton::clicked, popup, [this, popup] { popup->openAt(filter_->mapToGlobal(QPoint(0, 0))); });
    connect(&filters_, &app::StillFilters::changed, this, &StillView::showStill);
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
        filter_->hide();
        setNotice(tr("No still yet. Capture (C) freezes the picture with its HA and VA."));
        return;
    }
    setFrame(still->frame);
    setShown(filters_.shown(still->number, still->frame));
    ImageOverlay overlay =
        overlayOf(live_.overlayFor(still->pointing), live_.reticleFor(still->pointing), selected_row_id_, {});
    addParallax(overlay, live_.parallaxFor(still->pointing));
    setOverlay(std::move(overlay));
    setCaption(tr("Still %1   HA %2   VA %3").arg(still->number).arg(still->ha_text, still->va_text));
    setNotice({});
    filter_->show();
    const bool filtered = !filters_.of(still->number).isNone();
    filter_->setText(filtered ? tr("Filter on") : tr("Filter"));
    placeFilterButton();
    Q_EMIT overlayChanged();
}

void StillView::resizeEvent(QResizeEvent* event) {
    ImageView::resizeEvent(event);
    placeFilterButton();
}

void StillView::placeFilterButton() {
    constexpr int kEdge_px = 6;
    filter_->adjustSize();
    filter_->move(width() - filter_->width() - kEdge_px, kEdge_px);
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
