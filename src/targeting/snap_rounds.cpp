#include "snap_rounds.hpp"

#include "cubic_sampling.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmts::targeting {
namespace {

constexpr double kRound = 0.93;  // ratio of the axes above which it is called a circle
constexpr int kRays = 64;

SnapCandidate asMark(const cv::RotatedRect& box) {
    const bool wide = box.size.width >= box.size.height;
    const double longer = 0.5 * std::max(box.size.width, box.size.height);
    const double shorter = 0.5 * std::min(box.size.width, box.size.height);
    return {.kind = shorter >= kRound * longer ? SnapKind::kCircle : SnapKind::kEllipse,
            .px = {box.center.x, box.center.y},
            .half_axes_px = {longer, shorter},
            .axis_angle_rad = std::remainder((box.angle + (wide ? 0.0 : 90.0)) * CV_PI / 180, CV_PI)};
}

bool isPlausible(const SnapCandidate& mark, const cv::Size& window, const SnapSettings& settings) {
    constexpr double kSmallest_px = 2.5;
    constexpr double kFlattest = 0.25;
    const double longer = mark.half_axes_px.x();
    const double shorter = mark.half_axes_px.y();
    return shorter >= kSmallest_px && shorter >= kFlattest * longer &&
           longer <= settings.largest_half_axis_px && mark.px.x() >= 0 && mark.px.y() >= 0 &&
           mark.px.x() < window.width && mark.px.y() < window.height;
}

/// A place on the outline and the direction outwards from it.
struct OutlineSpot {
    Eigen::Vector2d px, outwards;
};

OutlineSpot outlineAt(const SnapCandidate& mark, double turn_rad) {
    const double c = std::cos(mark.axis_angle_rad);
    const double s = std::sin(mark.axis_angle_rad);
    const Eigen::Matrix2d axes{{c, -s}, {s, c}};
    const Eigen::Vector2d unit(std::cos(turn_rad), std::sin(turn_rad));
    return {mark.px + axes * unit.cwiseProduct(mark.half_axes_px),
            (axes * unit.cwiseQuotient(mark.half_axes_px)).normalized()};
}

/// Grey values along a line through an outline spot, inside to outside.
std::vector<float> profileAt(const cv::Mat& grey, const OutlineSpot& spot, double reach_px, double step_px) {
    const int steps = cvRound(2 * reach_px / step_px) + 1;
    cv::Mat places(1, steps, CV_32FC2);
    for (int i = 0; i < steps; ++i) {
        const Eigen::Vector2d px = spot.px + (i * step_px - reach_px) * spot.outwards;
        places.at<cv::Vec2f>(0, i) = {static_cast<float>(px.x()), static_cast<float>(px.y())};
    }
    const cv::Mat values = cubicSampled(grey, places);
    return {values.begin<float>(), values.end<float>()};
}

/// The edge nearest to the middle of a profile: where it crosses the mean of its two ends; signed step in
/// grey.
struct Edge {
    double at_px;
    double step_grey;
};

std::optional<Edge> edgeOf(const std::vector<float>& profile, double step_px, double least_step_grey) {
    const double inside = profile.front();
    const double outside = profile.back();
    if (std::abs(outside - inside) < least_step_grey) {
        return std::nullopt;
    }
    const double half = 0.5 * (inside + outside);
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double before = profile[i - 1] - half;
        const double after = profile[i] - half;
        if (before * after <= 0 && before != after) {
            const double index = static_cast<double>(i) - 1 + before / (before - after);
            return Edge{step_px * (index - 0.5 * static_cast<double>(profile.size() - 1)), outside - inside};
        }
    }
    return std::nullopt;
}

/// The outline found to a part of a pixel along the normals, and how much of it is there.
std::optional<SnapCandidate> refinedMark(const cv::Mat& grey, const SnapCandidate& rough,
                                         const SnapSettings& settings) {
    constexpr double kStep_px = 0.5;
    constexpr double kLeastCoverage = 0.75;
    const double reach_px = std::min(3.0, 0.6 * rough.half_axes_px.y());
    std::vector<cv::Point2f> outline;
    int brighter_outside = 0;
    for (int ray = 0; ray < kRays; ++ray) {
        const OutlineSpot spot = outlineAt(rough, 2 * CV_PI * ray / kRays);
        if (const auto edge =
                edgeOf(profileAt(grey, spot, reach_px, kStep_px), kStep_px, settings.least_contrast_grey)) {
            const Eigen::Vector2d px = spot.px + edge->at_px * spot.outwards;
            outline.emplace_back(static_cast<float>(px.x()), static_cast<float>(px.y()));
            brighter_outside += edge->step_grey > 0;
        }
    }
    const double coverage = static_cast<double>(outline.size()) / kRays;
    const double one_sided =
        std::abs(2.0 * brighter_outside / std::max<double>(1.0, static_cast<double>(outline.size())) - 1.0);
    if (coverage < kLeastCoverage || one_sided < kLeastCoverage) {
        return std::nullopt;
    }
    SnapCandidate mark = asMark(cv::fitEllipseDirect(outline));
    if (!isPlausible(mark, grey.size(), settings)) {
        return std::nullopt;
    }
    double sum2 = 0;
    for (const cv::Point2f& p : outline) {
        sum2 += std::pow(distanceToOutline_px(mark, {p.x, p.y}), 2);
    }
    const double rms_px = std::sqrt(sum2 / static_cast<double>(outline.size()));
    const double tolerated_px = 0.25 + 0.01 * mark.half_axes_px.x();
    mark.confidence = coverage * std::clamp(1.0 - rms_px / (2 * tolerated_px), 0.0, 1.0);
    return mark;
}

void keepBest(std::vector<SnapCandidate>& marks, const SnapCandidate& mark) {
    for (SnapCandidate& known : marks) {
        if ((known.px - mark.px).norm() < 1.5 && (known.half_axes_px - mark.half_axes_px).norm() < 3.0) {
            known = known.confidence >= mark.confidence ? known : mark;
            return;
        }
    }
    marks.push_back(mark);
}

}  // namespace

double distanceToOutline_px(const SnapCandidate& mark, const Eigen::Vector2d& px) {
    const double c = std::cos(mark.axis_angle_rad);
    const double s = std::sin(mark.axis_angle_rad);
    const Eigen::Vector2d from_centre = px - mark.px;
    const Eigen::Vector2d along(c * from_centre.x() + s * from_centre.y(),
                                -s * from_centre.x() + c * from_centre.y());
    const Eigen::Vector2d unit = along.cwiseQuotient(mark.half_axes_px);
    const double f = unit.norm() - 1.0;  // first order: value over gradient
    const double gradient =
        along.cwiseQuotient(mark.half_axes_px.cwiseAbs2()).norm() / std::max(unit.norm(), 1e-9);
    return std::abs(f) / std::max(gradient, 1e-9);
}

std::vector<SnapCandidate> roundMarks(const cv::Mat& grey, const SnapSettings& settings) {
    constexpr int kLevels = 5;
    double darkest = 0, brightest = 0;
    cv::minMaxLoc(grey, &darkest, &brightest);
    std::vector<SnapCandidate> marks;
    if (brightest - darkest < settings.least_contrast_grey) {
        return marks;
    }
    cv::Mat values;
    grey.convertTo(values, CV_32F);
    for (int level = 1; level <= kLevels; ++level) {
        cv::Mat bright;
        cv::threshold(grey, bright, darkest + (brightest - darkest) * level / (kLevels + 1), 255,
                      cv::THRESH_BINARY);
        std::vector<std::vector<cv::Point>> outlines;
        cv::findContours(bright, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
        for (const auto& outline : outlines) {
            if (outline.size() < 10) {
                continue;
            }
            const SnapCandidate rough = asMark(cv::fitEllipseDirect(outline));
            const double area = CV_PI * rough.half_axes_px.prod();
            if (!isPlausible(rough, grey.size(), settings) ||
                std::abs(cv::contourArea(outline) / area - 1) > 0.35) {
                continue;
            }
            if (const auto mark = refinedMark(values, rough, settings)) {
                keepBest(marks, *mark);
            }
        }
    }
    return marks;
}

}  // namespace pmts::targeting
