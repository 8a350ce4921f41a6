#include "picture_input.hpp"

#include "picture_callout.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

using Tool = PictureTools::Tool;

constexpr double kMostSnap_px = 15.0;
constexpr double kLeastSnap_px = 4.0;

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

SnapLook lookOf(app::SnapKind kind) {
    switch (kind) {
        case app::SnapKind::kCorner:
            return SnapLook::kCorner;
        case app::SnapKind::kCrossing:
            return SnapLook::kCrossing;
        case app::SnapKind::kCircle:
            return SnapLook::kCircle;
        case app::SnapKind::kEllipse:
            break;
    }
    return SnapLook::kEllipse;
}

app::OverlayKind kindOf(PointLook look) {
    return look == PointLook::kPlanned
               ? app::OverlayKind::kPlanned
               : (look == PointLook::kMark ? app::OverlayKind::kMark : app::OverlayKind::kPoint);
}

}  // namespace

PictureInput::PictureInput(ImageView& view, app::Picture picture, app::Workbench& bench, PictureTools& tools)
    : QObject(&view),
      view_(view),
      picture_(picture),
      bench_(bench),
      tools_(tools),
      callout_(new PictureCallout(&view)) {
    view_.setDragPolicy(
        [this](const QPointF& px, Qt::KeyboardModifiers modifiers) { return useOfDrag(px, modifiers); });
    connect(&view_, &ImageView::pixelClicked, this, &PictureInput::click);
    connect(&view_, &ImageView::pixelDoubleClicked, this, &PictureInput::doubleClick);
    connect(&view_, &ImageView::hovered, this, &PictureInput::hover);
    connect(&view_, &ImageView::hoverEnded, this, [this] { bench_.snap.lookAway(); });
    connect(&view_, &ImageView::zoomChanged, callout_, &QWidget::hide);
    connect(&view_, &ImageView::dragMoved, this, &PictureInput::dragMoved);
    connect(&view_, &ImageView::dragEnded, this, &PictureInput::dragEnded);
    connect(&view_, &ImageView::dragCancelled, this, &PictureInput::clearDrag);
    connect(&tools_, &PictureTools::touched, this, [this](const QObject* by) {
        if (by != this) {
            callout_->hide();
        }
    });
    connect(&tools_, &PictureTools::toolChanged, &view_, &ImageView::cancelDrag);
    connect(&bench_.snap, &app::SnapPresenter::spotChanged, this, &PictureInput::showSnap);
    connect(&bench_.targeting, &app::TargetingPresenter::movingChanged, callout_, &QWidget::hide);
}

void PictureInput::setPicture(app::Picture picture) {
    if (picture != picture_) {
        picture_ = picture;
        callout_->hide();
        showSnap();
    }
}

double PictureInput::reach_px() const {
    return std::clamp(kSnapReach / view_.scale(), kLeastSnap_px, kMostSnap_px);
}

void PictureInput::hover(const QPointF& px) { bench_.snap.look(picture_, view_.frame(), px, reach_px()); }

void PictureInput::showSnap() {
    ToolOverlay tools = view_.toolOverlay();
    const auto spot = bench_.snap.spotIn(picture_);
    if (!spot && !tools.snap) {
        return;
    }
    tools.snap = spot ? std::optional(ToolOverlay::Snap{.px = spot->px,
                                                        .look = lookOf(spot->kind),
                                                        .half_axes_px = spot->half_axes_px,
                                                        .axis_angle_rad = spot->axis_angle_rad})
                      : std::nullopt;
    view_.setToolOverlay(tools);
}

const ImageOverlay::Point* PictureInput::pointAt(const QPointF& px) const {
    const auto away = [&](const ImageOverlay::Point& point) {
        return distance(point.px, px) * view_.scale();
    };
    const auto& points = view_.overlay().points;
    const auto nearest = std::ranges::min_element(points, {}, away);
    return nearest != points.end() && away(*nearest) <= kPointReach ? &*nearest : nullptr;
}

void PictureInput::click(const QPointF& px, Qt::KeyboardModifiers modifiers) {
    callout_->hide();
    tools_.touch(*this);
    if (tools_.tool() == Tool::kZoomBox || (first_use_ && first_use_(px))) {
        return;  // a box is dragged
    }
    const ImageOverlay::Point* const point = modifiers & Qt::ControlModifier ? nullptr : pointAt(px);
    if (point != nullptr && point->look == PointLook::kMark) {
        return chooseMark(*point);
    }
    if (tools_.tool() == Tool::kMark) {
        return bench_.snap.choose(picture_, view_.frame(), px, reach_px(),
                                  [this](QPointF at) { drawMark(at); });
    }
    if (point != nullptr) {
        return choosePoint(*point);
    }
    const bool only_aims = modifiers & Qt::ControlModifier;
    bench_.snap.choose(picture_, view_.frame(), px, reach_px(),
                       [this, only_aims](QPointF at) { aim(at, only_aims); });
}

void PictureInput::doubleClick(const QPointF& px, Qt::KeyboardModifiers modifiers) {
    if (tools_.tool() == Tool::kZoomBox || tools_.tool() == Tool::kMark) {
        return;
    }
    callout_->hide();
    const ImageOverlay::Point* const point = modifiers & Qt::ControlModifier ? nullptr : pointAt(px);
    if (point != nullptr) {
        return turnTo(kindOf(point->look), point->row_id);
    }
    bench_.snap.choose(picture_, view_.frame(), px, reach_px(), [this](QPointF at) { turn(at); });
}

void PictureInput::aim(const QPointF& px, bool only) {
    app::TargetingPresenter& targeting = bench_.targeting;
    if (picture_ == app::Picture::kLive) {
        only ? targeting.aimAtLivePixel(px) : targeting.clickLivePixel(px);
    } else {
        only ? targeting.aimAtStillPixel(px) : targeting.clickStillPixel(px);
    }
}

void PictureInput::turn(const QPointF& px) {
    picture_ == app::Picture::kLive ? bench_.targeting.moveToLivePixel(px)
                                    : bench_.targeting.moveToStillPixel(px);
}

void PictureInput::turnTo(app::OverlayKind kind, qint64 row_id) {
    const survey::PlannedPoint* const planned =
        kind == app::OverlayKind::kPlanned ? bench_.planned.find(row_id) : nullptr;
    planned != nullptr ? bench_.targeting.moveToPlanned(*planned)
                       : bench_.targeting.moveToPlace(kind, row_id);
}

void PictureInput::choosePoint(const ImageOverlay::Point& point) {
    const app::OverlayKind kind = kindOf(point.look);
    const qint64 row_id = point.row_id;
    const QString label = point.label;
    const QPointF at = view_.widgetFromImage(point.px);
    if (kind == app::OverlayKind::kPlanned) {
        Q_EMIT plannedChosen(row_id);
    } else {
        Q_EMIT pointChosen(row_id);
    }
    callout_->offer(at, {{tr("Turn to %1").arg(label), [this, kind, row_id] { turnTo(kind, row_id); }}});
}

void PictureInput::chooseMark(const ImageOverlay::Point& mark) {
    const qint64 id = mark.row_id;
    callout_->offerWithName(
        view_.widgetFromImage(mark.px), mark.label,
        [this, id](const QString& name) { bench_.marks.rename(id, name); },
        {{tr("Turn to"), [this, id] { bench_.targeting.moveToPlace(app::OverlayKind::kMark, id); }},
         {tr("Delete"), [this, id] { bench_.marks.remove(id); }}});
}

void PictureInput::drawMark(const QPointF& px) {
    const auto id = bench_.routines.pdraw(px.x(), px.y(), {}, picture_);
    if (!id) {
        return report(id.error());
    }
    const app::ImageMark* const mark = bench_.marks.find(*id);
    chooseMark({.px = px, .label = mark->label, .look = PointLook::kMark, .row_id = mark->id});
}

ImageView::DragUse PictureInput::useOfDrag(const QPointF& px, Qt::KeyboardModifiers modifiers) const {
    using Use = ImageView::DragUse;
    if (tools_.tool() == Tool::kZoomBox) {
        return Use::kTool;
    }
    if (tools_.tool() == Tool::kMark) {
        const ImageOverlay::Point* const point = pointAt(px);
        return point != nullptr && point->look == PointLook::kMark ? Use::kTool : Use::kPan;
    }
    if (picture_ != app::Picture::kLive || !bench_.live.scene().pointing) {
        return Use::kPan;
    }
    const bool asked = tools_.tool() == Tool::kDragTurn || (modifiers & Qt::ShiftModifier);
    return asked || view_.zoom() <= 1.0 ? Use::kTool : Use::kPan;
}

bool PictureInput::sticks(const QPointF& to_px) const {
    const auto& reticle = bench_.live.scene().reticle_px;
    return reticle && distance(*reticle, to_px) * view_.scale() <= kStick;
}

void PictureInput::dragMoved(const QPointF& from_px, const QPointF& to_px) {
    callout_->hide();
    ToolOverlay tools = view_.toolOverlay();
    if (tools_.tool() == Tool::kZoomBox) {
        tools.box = QRectF(from_px, to_px).normalized();
    } else if (tools_.tool() == Tool::kMark) {
        const ImageOverlay::Point* const grabbed = grabbed_mark_ == 0 ? pointAt(from_px) : nullptr;
        grabbed_mark_ = grabbed != nullptr ? grabbed->row_id : grabbed_mark_;
        tools.drag = QLineF(from_px, to_px);
    } else {
        tools.drag = QLineF(from_px, sticks(to_px) ? *bench_.live.scene().reticle_px : to_px);
    }
    view_.setToolOverlay(tools);
}

void PictureInput::dragEnded(const QPointF& from_px, const QPointF& to_px) {
    const qint64 mark = grabbed_mark_;
    clearDrag();
    if (tools_.tool() == Tool::kZoomBox) {
        const auto box = bench_.routines.zoomBox(from_px.x(), from_px.y(), to_px.x(), to_px.y(), picture_);
        return box ? tools_.putAway() : report(box.error());
    }
    if (tools_.tool() == Tool::kMark) {
        const auto moved = bench_.routines.moveMark(mark, to_px.x(), to_px.y(), picture_);
        return moved ? void() : report(moved.error());
    }
    if (sticks(to_px)) {
        bench_.targeting.moveToLivePixel(from_px);  // brought to the reticle: the telescope's axis goes there
    } else {
        bench_.targeting.bringToPixel(from_px, to_px);
    }
}

void PictureInput::clearDrag() {
    grabbed_mark_ = 0;
    ToolOverlay tools = view_.toolOverlay();
    tools.drag.reset();
    tools.box.reset();
    view_.setToolOverlay(tools);
}

void PictureInput::report(const core::Error& error) {
    bench_.messages.report(error, app::MessageAction::kNone, QStringLiteral("picture"));
}

}  // namespace pmts::gui
