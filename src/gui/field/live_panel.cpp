#include "live_panel.hpp"

#include "field_actions.hpp"
#include "parts/line_icon.hpp"
#include "window/message_area.hpp"
#include "window/progress_overlay.hpp"
#include "ui_view_bar.h"

#include <QVBoxLayout>

#include <utility>

namespace pmts::gui {
namespace {

constexpr double kZoomStep = 1.5;

std::optional<TargetLook> lookOf(app::MoveState state) {
    switch (state) {
        case app::MoveState::kNone:
            return std::nullopt;
        case app::MoveState::kAimed:
            return TargetLook::kClicked;
        case app::MoveState::kQueued:
            return TargetLook::kQueued;
        case app::MoveState::kTurning:
            return TargetLook::kTurning;
        case app::MoveState::kRecentring:
            return TargetLook::kRecentring;
        case app::MoveState::kArrived:
            return TargetLook::kArrived;
        case app::MoveState::kLost:
            break;
    }
    return TargetLook::kLost;
}

/// HA and VA beside the target until it is reached: from then on the readings say them.
QString targetNote(const std::optional<app::Target>& target) {
    const bool ahead = target && target->state != app::MoveState::kArrived;
    return ahead ? QStringLiteral("HA %1  VA %2").arg(target->ha_text, target->va_text) : QString();
}

std::optional<ImageOverlay::Point> pointOf(const app::OverlayItem& item, qint64 selected_row_id) {
    const auto drawn = [&](PointLook look, bool selected) {
        return ImageOverlay::Point{
            .px = item.px, .label = item.label, .selected = selected, .look = look, .row_id = item.row_id};
    };
    switch (item.kind) {
        case app::OverlayKind::kPoint:
            return drawn(PointLook::kRecorded, item.row_id == selected_row_id);
        case app::OverlayKind::kPlanned:
            return drawn(PointLook::kPlanned, false);
        case app::OverlayKind::kMark:
            return drawn(PointLook::kMark, false);
        case app::OverlayKind::kTarget:
            break;
    }
    return std::nullopt;
}

}  // namespace

void addParallax(ImageOverlay& overlay, const app::ParallaxCurve& curve) {
    overlay.parallax = curve.px;
    for (const app::ParallaxCurve::Mark& mark : curve.marks) {
        overlay.parallax_marks.push_back({mark.px, mark.label});
    }
}

ImageOverlay overlayOf(const std::vector<app::OverlayItem>& items, const std::optional<QPointF>& reticle_px,
                       qint64 selected_row_id, const QString& target_note) {
    ImageOverlay overlay{.reticle = reticle_px};
    for (const app::OverlayItem& item : items) {
        if (const auto point = pointOf(item, selected_row_id)) {
            overlay.points.push_back(*point);
        } else if (const auto look = lookOf(item.move)) {
            overlay.target = {item.px, *look, target_note};
        }
    }
    return overlay;
}

LivePanel::LivePanel(app::LivePresenter& live, app::TargetingPresenter& targeting, QWidget* parent)
    : QWidget(parent),
      live_(live),
      targeting_(targeting),
      bar_(std::make_unique<Ui::ViewBar>()),
      view_(new ImageView(this)) {
    auto* const bar = new QWidget(this);
    bar_->setupUi(bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(bar);
    view_->setAccessibleName(tr("Live view"));
    view_->setObjectName(QStringLiteral("live_view"));
    toast_ = new Toast(view_);
    progress_ = new ProgressOverlay(view_);
    connect(progress_, &ProgressOverlay::cancelled, this, &LivePanel::cancelRequested);
    wireView();
    showScene();
    showCameraStatus();
}

LivePanel::~LivePanel() = default;

void LivePanel::wireView() {
    connect(view_, &ImageView::framePainted, this,
            [this](const camera::FramePtr& frame) { live_.framePainted(frame->captured_at); });
    connect(view_, &ImageView::zoomChanged, this,
            [this](double zoom) { bar_->zoom->setText(QStringLiteral("x%1").arg(zoom, 0, 'g', 2)); });
    connect(&live_, &app::LivePresenter::sceneChanged, this, [this] {
        if (isVisible() || !window()->isVisible()) {  // not behind another workspace
            showScene();
        }
    });
    connect(&targeting_, &app::TargetingPresenter::targetChanged, this, &LivePanel::showScene);
    connect(&live_, &app::LivePresenter::statisticsChanged, this, &LivePanel::showStatistics);
    connect(&live_, &app::LivePresenter::cameraStatusChanged, this, &LivePanel::showCameraStatus);
    connect(bar_->points, &QToolButton::toggled, this, &LivePanel::showScene);
    connect(bar_->range, &QToolButton::clicked, this, &LivePanel::rangeRequested);
    connect(bar_->depth, &QToolButton::clicked, this, [this] { Q_EMIT depthRequested(*bar_->depth); });
}

void LivePanel::setActions(const FieldActions& actions) {
    bar_->zoom_in->setIcon(lineIcon(QStringLiteral("zoom-in")));
    bar_->zoom_out->setIcon(lineIcon(QStringLiteral("zoom-out")));
    bar_->fit->setIcon(lineIcon(QStringLiteral("fit")));
    bar_->points->setIcon(lineIcon(QStringLiteral("overlay")));
    bar_->depth->setIcon(lineIcon(QStringLiteral("depth")));
    const std::pair<QToolButton*, QAction*> tools[] = {{bar_->pause, actions.pause_camera},
                                                       {bar_->snap, actions.snap},
                                                       {bar_->drag_turns, actions.drag_turns},
                                                       {bar_->zoom_box, actions.zoom_box},
                                                       {bar_->mark, actions.mark}};
    for (const auto& [button, action] : tools) {
        button->setDefaultAction(action);
    }
    connect(bar_->zoom_in, &QToolButton::clicked, actions.zoom_in, &QAction::trigger);
    connect(bar_->zoom_out, &QToolButton::clicked, actions.zoom_out, &QAction::trigger);
    connect(bar_->fit, &QToolButton::clicked, actions.fit, &QAction::trigger);
    connect(actions.zoom_in, &QAction::triggered, view_,
            [this] { view_->setZoom(view_->zoom() * kZoomStep); });
    connect(actions.zoom_out, &QAction::triggered, view_,
            [this] { view_->setZoom(view_->zoom() / kZoomStep); });
    connect(actions.fit, &QAction::triggered, view_, &ImageView::fit);
}

void LivePanel::hideFieldTools() {
    bar_->zoom_box->hide();
    bar_->mark->hide();
}

void LivePanel::selectPoint(qint64 row_id) {
    selected_row_id_ = row_id;
    showScene();
}

void LivePanel::showToast(const QString& text) { toast_->showText(text); }

void LivePanel::showBusy(bool busy, const QString& text, double fraction) {
    if (busy) {
        progress_->showBusy(text, fraction);
    } else {
        progress_->hide();
    }
}

void LivePanel::setReticleShown(bool shown) {
    if (std::exchange(reticle_shown_, shown) != shown) {
        showScene();
    }
}

void LivePanel::showScene() {
    const app::LiveScene& scene = live_.scene();
    if (scene.frame != view_->frame()) {
        view_->setFrame(scene.frame);
        showCameraStatus();
    }
    ImageOverlay overlay =
        overlayOf(scene.overlay, scene.reticle_px, selected_row_id_, targetNote(targeting_.target()));
    if (!bar_->points->isChecked()) {
        std::erase_if(overlay.points, [](const auto& point) { return point.look != PointLook::kMark; });
    }
    if (reticle_shown_) {
        addParallax(overlay, scene.parallax);
    } else {
        overlay.reticle.reset();
    }
    view_->setOverlay(std::move(overlay));
    Q_EMIT overlayChanged();
    view_->setCaption(targeting_.target() ? targeting_.target()->sentence : QString());
    bar_->range->setText(scene.range_text.isEmpty() ? QString() : tr("Range %1").arg(scene.range_text));
}

void LivePanel::showStatistics(const app::LiveStatistics& statistics) {
    bar_->rate->setText(statistics.text);
    bar_->rate->setToolTip(tr("Capture to screen %1 ms, %2 frames, %3 lost, %4 pauses for the instrument")
                               .arg(statistics.paint_latency_ms, 0, 'f', 0)
                               .arg(statistics.delivered)
                               .arg(statistics.lost)
                               .arg(statistics.gate.pauses));
}

void LivePanel::showCameraStatus() {
    const app::StatusItem& status = live_.cameraStatus();
    const bool fine = status.state == app::DeviceState::kGood && live_.scene().frame;
    view_->setNotice(fine ? QString() : status.details);
}

}  // namespace pmts::gui
