#include "pmts/targeting/snap.hpp"

#include "cubic_sampling.hpp"
#include "snap_rounds.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::targeting {
namespace {

/// Grey values on a circle around a spot, and how often they go from dark to bright or back.
struct Ring {
    double contrast_grey = 0.0;
    int changes = 0;
};

Ring ringAround(const cv::Mat& values, const cv::Point2f& spot, float radius_px) {
    constexpr int kPlaces = 48;
    cv::Mat places(1, kPlaces, CV_32FC2);
    for (int i = 0; i < kPlaces; ++i) {
        const double turn = 2 * CV_PI * i / kPlaces;
        places.at<cv::Vec2f>(0, i) = {spot.x + radius_px * static_cast<float>(std::cos(turn)),
                                      spot.y + radius_px * static_cast<float>(std::sin(turn))};
    }
    const cv::Mat ring = cubicSampled(values, places);
    double darkest = 0, brightest = 0;
    cv::Point start;
    cv::minMaxLoc(ring, &darkest, &brightest, nullptr, &start);
    Ring result{.contrast_grey = brightest - darkest};
    // A fifth of the contrast as hysteresis, so that noise is no change.
    const double high = darkest + 0.6 * (brightest - darkest);
    const double low = darkest + 0.4 * (brightest - darkest);
    bool is_bright = true;  // at the brightest place, where the round starts and ends
    for (int i = 1; i <= kPlaces; ++i) {
        const float value = ring.at<float>(0, (start.x + i) % kPlaces);
        if (is_bright ? value < low : value > high) {
            is_bright = !is_bright;
            ++result.changes;
        }
    }
    return result;
}

/// How much of the picture around a spot is looked at.
struct CornerScale {
    int half_px;                ///< of the window in which the spot is made exact
    float near_px, far_px;      ///< radii of the two rings
    int least_changes;          ///< on the inner ring
    double surely_seen_grey;    ///< contrast of the inner ring
    double apart_px;            ///< of the places the search starts from
    double drift_px;            ///< a spot found this far from such a place is worth nothing
};

constexpr CornerScale kUsual{6, 4.0f, 6.0f, 2, 40.0, 3.0, 6.0};
/// A mark of some 8 px, 0.2 m at 30 m: its own outer corners would pull the usual window. Quadrants only, and black on
/// white, for texture is full of small corners. The search may
/// find no place to start from in the middle of one, and come to it from beside.
constexpr CornerScale kSmallMark{3, 2.0f, 3.0f, 4, 80.0, 1.5, 12.0};

/// Two changes are a corner, four and more are lines or quadrants that cross; none is an edge's end or noise.
std::optional<SnapCandidate> asCorner(const cv::Mat& values, const cv::Point2f& spot, double moved_px,
                                      const CornerScale& scale, const SnapSettings& settings) {
    const Ring near = ringAround(values, spot, scale.near_px);
    const Ring far = ringAround(values, spot, scale.far_px);
    if (std::min(near.contrast_grey, far.contrast_grey) < settings.least_contrast_grey ||
        near.changes < scale.least_changes) {
        return std::nullopt;
    }
    const double seen = std::min(1.0, near.contrast_grey / scale.surely_seen_grey);
    const double steady = std::clamp(1.0 - moved_px / scale.drift_px, 0.0, 1.0);
    const double alike = near.changes == far.changes ? 1.0 : 0.75;
    return SnapCandidate{.kind = near.changes >= 4 ? SnapKind::kCrossing : SnapKind::kCorner,
                         .px = {spot.x, spot.y},
                         .confidence = seen * steady * alike};
}

/// A straight edge also looks like a corner to the sub-pixel search; its two gradient directions are one.
bool hasTwoDirections(const cv::Mat& grey, const cv::Point2f& spot) {
    constexpr int kHalf_px = 5;
    const cv::Rect around(cvRound(spot.x) - kHalf_px, cvRound(spot.y) - kHalf_px, 2 * kHalf_px + 1,
                          2 * kHalf_px + 1);
    const cv::Rect inside = around & cv::Rect({0, 0}, grey.size());
    if (inside.area() < around.area() / 2) {
        return false;
    }
    cv::Mat dx, dy;
    cv::Scharr(grey(inside), dx, CV_32F, 1, 0);
    cv::Scharr(grey(inside), dy, CV_32F, 0, 1);
    const double xx = dx.dot(dx), xy = dx.dot(dy), yy = dy.dot(dy);
    const double root = std::hypot(xx - yy, 2 * xy);
    return xx + yy - root > 0.15 * (xx + yy + root);
}

/// Several starts end on one corner.
void keepSurest(std::vector<SnapCandidate>& found, const SnapCandidate& corner) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const SnapCandidate& other) {
        return (other.px - corner.px).norm() < 2.0;
    });
    if (same == found.end()) {
        found.push_back(corner);
    } else if (corner.confidence > same->confidence) {
        *same = corner;
    }
}

std::vector<SnapCandidate> cornersAt(const cv::Mat& grey, const CornerScale& scale, const SnapSettings& settings) {
    constexpr int kMost = 60;
    std::vector<cv::Point2f> whole;
    cv::goodFeaturesToTrack(grey, whole, kMost, 0.02, scale.apart_px, cv::noArray(), 3);
    if (whole.empty()) {
        return {};
    }
    const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 60, 1e-3);
    std::vector<cv::Point2f> exact = whole;
    cv::cornerSubPix(grey, exact, {scale.half_px, scale.half_px}, {1, 1}, enough);
    cv::Mat values;
    grey.convertTo(values, CV_32F);
    std::vector<SnapCandidate> found;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto corner = asCorner(values, exact[i], cv::norm(exact[i] - whole[i]), scale, settings);
        if (corner && hasTwoDirections(grey, exact[i])) {
            keepSurest(found, *corner);
        }
    }
    std::erase_if(found, [&](const SnapCandidate& corner) { return corner.confidence < settings.least_confidence; });
    return found;
}

/// A small mark's crossing, unless the usual window finds the same place from more pixels.
std::vector<SnapCandidate> corners(const cv::Mat& grey, const SnapSettings& settings) {
    constexpr double kSamePlace_px = 0.5, kPulled_px = 2.0;
    std::vector<SnapCandidate> found = cornersAt(grey, kUsual, settings);
    for (const SnapCandidate& small : cornersAt(grey, kSmallMark, settings)) {
        const auto away_px = [&](const SnapCandidate& usual) { return (usual.px - small.px).norm(); };
        if (std::ranges::none_of(found, [&](const auto& usual) { return away_px(usual) < kSamePlace_px; })) {
            std::erase_if(found, [&](const auto& usual) { return away_px(usual) < kPulled_px; });
            found.push_back(small);
        }
    }
    return found;
}

/// A field of a small chessboard is as round as a circle of its size; the crossing at its corner tells them apart.
bool isQuadrant(const SnapCandidate& mark, const std::vector<SnapCandidate>& sharp) {
    constexpr double kTooSmallToTell_px = 6.0;
    return mark.half_axes_px.x() < kTooSmallToTell_px &&
           std::ranges::any_of(sharp, [&](const SnapCandidate& corner) {
               return corner.kind == SnapKind::kCrossing && distanceToOutline_px(mark, corner.px) < 3.0;
           });
}

/// Smaller is sooner taken. A crossing is what marks are made for: it is preferred to the outer corners of its mark.
double claim(const SnapCandidate& candidate, const Eigen::Vector2d& cursor_px) {
    const double away_px = (candidate.px - cursor_px).norm();
    const bool is_round = candidate.half_axes_px.y() > 0;
    const bool is_inside = is_round && away_px < candidate.half_axes_px.y();
    return is_inside || candidate.kind == SnapKind::kCrossing ? 0.5 * away_px : away_px;
}

}  // namespace

std::vector<SnapCandidate> snapCandidates(const cv::Mat& bgr, const Eigen::Vector2d& cursor_px,
                                          const SnapSettings& settings) {
    const int half = cvCeil(settings.radius_px + settings.largest_half_axis_px + 4);
    const cv::Rect picture({0, 0}, bgr.size());
    const cv::Rect window =
        cv::Rect(cvRound(cursor_px.x()) - half, cvRound(cursor_px.y()) - half, 2 * half + 1, 2 * half + 1) &
        picture;
    if (window.width < 16 || window.height < 16) {
        return {};
    }
    cv::Mat grey = bgr(window);
    if (bgr.channels() == 3) {
        cv::cvtColor(bgr(window), grey, cv::COLOR_BGR2GRAY);
    }
    cv::GaussianBlur(grey, grey, {3, 3}, 0.7);
    std::vector<SnapCandidate> found = roundMarks(grey, settings);
    std::erase_if(found,
                  [&](const SnapCandidate& mark) { return mark.confidence < settings.least_confidence; });
    const std::vector<SnapCandidate> sharp = corners(grey, settings);
    std::erase_if(found, [&](const SnapCandidate& mark) { return isQuadrant(mark, sharp); });
    const std::vector<SnapCandidate> marks = found;
    for (const SnapCandidate& corner : sharp) {
        const auto on_outline = [&](const SnapCandidate& mark) {
            return distanceToOutline_px(mark, corner.px) < 3.0;
        };
        if (std::none_of(marks.begin(), marks.end(), on_outline)) {
            found.push_back(corner);
        }
    }
    for (SnapCandidate& candidate : found) {
        candidate.px += Eigen::Vector2d(window.x, window.y);
    }
    std::erase_if(found, [&](const SnapCandidate& candidate) {
        return (candidate.px - cursor_px).norm() > settings.radius_px;
    });
    std::sort(found.begin(), found.end(), [&](const SnapCandidate& a, const SnapCandidate& b) {
        return claim(a, cursor_px) < claim(b, cursor_px);
    });
    return found;
}

std::optional<SnapCandidate> snapped(const cv::Mat& bgr, const Eigen::Vector2d& cursor_px,
                                     const SnapSettings& settings) {
    const auto candidates = snapCandidates(bgr, cursor_px, settings);
    return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

}  // namespace pmts::targeting
