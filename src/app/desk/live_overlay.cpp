// What the live presenter draws over a picture: points, planned points, target, reticle and the parallax curve.
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/geometry/polar.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

constexpr double kMarginPx = 40.0;  ///< labels of points just outside still reach into the picture

QPointF pointF(const Eigen::Vector2d& px) { return {px.x(), px.y()}; }

}  // namespace

void LivePresenter::placePoints() {
    placed_.clear();
    for (const survey::Point& point : points_.points()) {
        if (!point.struck_out && hasCoordinates(point)) {
            const survey::Coordinates& place = point.coordinates;
            placeGround({.kind = OverlayKind::kPoint, .p_station = {}, .label = point.id, .code = point.code,
                         .row_id = point.row_id},
                        place.e_m, place.n_m, place.h_m, point.observation.target_height_m);
        }
    }
    for (const survey::PlannedPoint& planned : planned_) {
        placeGround({.kind = OverlayKind::kPlanned, .p_station = {}, .label = planned.id, .code = planned.code,
                     .row_id = planned.row_id},
                    planned.e_m, planned.n_m, planned.h_m, 0.0);
    }
    refreshPlaces();
}

void LivePresenter::placeGround(OverlayPlace place, double e_m, double n_m, double h_m, double target_height_m) {
    place.p_station = survey::stationFrameFromGround(station_.station(), e_m, n_m, h_m, target_height_m);
    placed_.push_back(std::move(place));
}

void LivePresenter::setPlannedPoints(std::vector<survey::PlannedPoint> planned) {
    planned_ = std::move(planned);
    placePoints();
}

void LivePresenter::setExtraPlaces(std::vector<OverlayPlace> extra) {
    extra_ = std::move(extra);
    refreshPlaces();
}

std::optional<OverlayPlace> LivePresenter::placeOf(OverlayKind kind, qint64 row_id) const {
    for (const auto* places : {&placed_, &extra_}) {
        const auto found = std::ranges::find_if(
            *places, [&](const OverlayPlace& place) { return place.kind == kind && place.row_id == row_id; });
        if (found != places->end()) {
            return *found;
        }
    }
    return std::nullopt;
}

void LivePresenter::refreshPlaces() {
    refreshScene();
    Q_EMIT placesChanged();
}

void LivePresenter::refreshScene() {
    const auto newest = instrument_.track().newest();
    scene_.range = range_.rangeAt(newest ? std::optional(newest->pointing) : std::nullopt);
    scene_.range_text = rangeText(scene_.range, preferences_.units());
    scene_.reticle_px = scene_.pointing ? reticleFor(*scene_.pointing) : std::nullopt;
    scene_.overlay = scene_.pointing ? overlayFor(*scene_.pointing) : std::vector<OverlayItem>{};
    scene_.parallax = scene_.pointing ? parallaxFor(*scene_.pointing) : ParallaxCurve{};
    Q_EMIT sceneChanged();
}

bool LivePresenter::isInPicture(const Eigen::Vector2d& px) const {
    return px.x() > -kMarginPx && px.y() > -kMarginPx && px.x() < model_.rig().width_px + kMarginPx &&
           px.y() < model_.rig().height_px + kMarginPx;
}

std::vector<OverlayItem> LivePresenter::overlayFor(const geometry::Pointing& pointing) const {
    std::vector<OverlayItem> items;
    const auto draw = [&](const OverlayPlace& place) {
        if (const auto px = model_.pixelForPoint(place.p_station, pointing); px && isInPicture(*px)) {
            items.push_back({.kind = place.kind, .px = pointF(*px), .label = place.label, .code = place.code,
                             .row_id = place.row_id, .move = MoveState::kNone});
        }
    };
    const DepthFilter& depth = preferences_.settings().image_tools.depth;
    for (const OverlayPlace& place : placed_) {
        if (depth.passes(place.p_station.norm())) {
            draw(place);
        }
    }
    std::ranges::for_each(extra_, draw);
    if (target_) {
        const Eigen::Vector3d p_target =
            geometry::stationFromPolar({.pointing = *target_, .slope_distance_m = target_range_m_});
        if (const auto px = model_.pixelForPoint(p_target, pointing); px && isInPicture(*px)) {
            items.push_back({.kind = OverlayKind::kTarget, .px = pointF(*px), .label = {}, .code = {}, .row_id = 0,
                             .move = target_state_});
        }
    }
    return items;
}

/// A picture taken elsewhere has its own place on the plane; without one it shares the range in use.
RangeAssumption LivePresenter::rangeFor(const geometry::Pointing& pointing) const {
    return range_.plane() ? range_.rangeAt(pointing) : scene_.range;
}

std::optional<QPointF> LivePresenter::reticleFor(const geometry::Pointing& pointing) const {
    const auto px = model_.reticlePixel(pointing, rangeFor(pointing).slope_distance_m);
    return px ? std::optional(pointF(*px)) : std::nullopt;
}

ParallaxCurve LivePresenter::parallaxFor(const geometry::Pointing& pointing) const {
    const ImageToolSettings& tools = preferences_.settings().image_tools;
    return parallaxCurve(model_, pointing, tools.parallax_near_m, tools.parallax_far_m, rangeFor(pointing).slope_distance_m,
                         preferences_.units());
}

void LivePresenter::setTarget(const std::optional<geometry::Pointing>& target, double slope_distance_m, MoveState state) {
    target_ = target;
    target_range_m_ = slope_distance_m;
    target_state_ = state;
    refreshPlaces();
}

}  // namespace pmts::app
