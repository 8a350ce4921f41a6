#include "pmts/targeting/patch_matcher.hpp"

#include "picture_map.hpp"
#include "shift_fit.hpp"

#include <QCoreApplication>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::targeting {
namespace {

using core::ErrorKind;

constexpr std::array kHalfSides_px{12, 16, 24, 36, 48};           // what is measured
constexpr std::array kIdentityHalfSides_px{20, 32, 48, 80, 128};  // what is recognised
constexpr double kCoarse_px = 2.0;                                // recognising takes every other pixel
constexpr double kLeastCoarseScore = 0.6;
constexpr double kNarrower = 0.6;  // where the whole patch does not move as one
constexpr double kWider = 1.6;     // where it says too little
constexpr std::array kTurns_deg{0.0, -1.0, 1.0, -2.0, 2.0};

QString sentence(const char* text) { return QCoreApplication::translate("Targeting", text); }

tl::unexpected<core::Error> outside() {
    return core::fail(ErrorKind::kNotReached, sentence("The target is outside the picture."),
                      sentence("Check the range and the rig profile, then click it again."), "outside");
}

tl::unexpected<core::Error> lost(double score) {
    return core::fail(ErrorKind::kNotReached,
                      sentence("The clicked spot was not found again (match %1).").arg(score, 0, 'f', 2),
                      sentence("The instrument stays where it is. Click the target again."),
                      QStringLiteral("lost %1").arg(score));
}

tl::unexpected<core::Error> ambiguous(double score, double runner_up) {
    return core::fail(
        ErrorKind::kNotReached,
        sentence("Several spots look like the clicked one, so it cannot be told which is meant."),
        sentence("The instrument stays where it is. Click a spot that differs from its "
                 "neighbours, or turn closer first."),
        QStringLiteral("ambiguous %1 %2").arg(score).arg(runner_up));
}

tl::unexpected<core::Error> torn(double unrest_px) {
    return core::fail(ErrorKind::kNotReached,
                      sentence("The clicked spot is at the edge of something nearer or farther, which moves "
                               "against its background."),
                      sentence("The instrument stays where it is. Click a little beside the edge."),
                      QStringLiteral("torn %1").arg(unrest_px));
}

tl::unexpected<core::Error> blurred(double sigma_px) {
    return core::fail(ErrorKind::kNotReached,
                      sentence("The picture is too dark, blurred or noisy to place the target better than "
                               "%1 px.")
                          .arg(sigma_px, 0, 'f', 2),
                      sentence("Set the exposure and the focus, then click the target again."),
                      QStringLiteral("blurred %1").arg(sigma_px));
}

/// One grey channel; the smoothing takes most of the noise and makes differences of sharpness small.
cv::Mat smoothGrey(const cv::Mat& picture) {
    cv::Mat grey = picture;
    if (picture.channels() == 3) {
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    }
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, {7, 7}, 1.0);
    smooth.convertTo(grey, CV_32F);
    return grey;
}

/// Offsets from the click, in steps, that stay inside the old picture and within `half_px`.
cv::Rect offsetsAround(const Patch& patch, int half_px, double step_px) {
    const auto steps = [step_px, half_px](double room_px) {
        return static_cast<int>(std::floor(std::min<double>(half_px, room_px) / step_px));
    };
    const int left = steps(patch.click_px.x());
    const int up = steps(patch.click_px.y());
    const int right = steps(patch.grey.cols - 1 - patch.click_px.x());
    const int down = steps(patch.grey.rows - 1 - patch.click_px.y());
    return {-left, -up, left + right + 1, up + down + 1};
}

cv::Mat part(const Patch& patch, int half_px, double step_px) {
    return PictureMap::identityAt(patch.click_px)
        .sampled(patch.grey, offsetsAround(patch, half_px, step_px), step_px);
}

double unexplained(double score) { return 1.0 - std::max(score, 0.0) * std::max(score, 0.0); }

/// The best match leaves much less unexplained than the next best; twins never do.
bool standsOut(double score, double runner_up, double share) {
    constexpr double kTwin = 0.995;
    return runner_up < kTwin && unexplained(score) <= share * unexplained(runner_up);
}

struct Peaks {
    cv::Point best;
    double best_score = -1.0;
    double runner_up = -1.0;  ///< the highest other hill, not the shoulder of the best one
};

Peaks peaksOf(const cv::Mat& scores) {
    Peaks peaks;
    cv::minMaxLoc(scores, nullptr, &peaks.best_score, nullptr, &peaks.best);
    cv::Mat highest_around;
    cv::dilate(scores, highest_around, cv::Mat::ones(5, 5, CV_8U));
    cv::Mat other_hills = scores >= highest_around;
    const cv::Rect around(peaks.best.x - 3, peaks.best.y - 3, 7, 7);
    other_hills(around & cv::Rect({0, 0}, scores.size())).setTo(0);
    if (cv::countNonZero(other_hills) > 0) {
        cv::minMaxLoc(scores, nullptr, &peaks.runner_up, nullptr, nullptr, other_hills);
    }
    return peaks;
}

cv::Mat scoresOf(const cv::Mat& window, const cv::Mat& searched) {
    cv::Mat scores;
    cv::matchTemplate(window, searched, scores, cv::TM_CCOEFF_NORMED);
    cv::patchNaNs(scores, -1.0);
    scores.setTo(-1.0, scores > 1.001);  // a flat window divides nothing by nothing
    return scores;
}

/// Best score of anything else in the patch's own picture.
double lookAlike(const Patch& patch, int half_px) {
    const PictureMap here = PictureMap::identityAt(patch.click_px);
    const cv::Mat searched = part(patch, half_px, kCoarse_px);
    const cv::Rect everywhere = offsetsAround(patch, std::max(patch.grey.cols, patch.grey.rows), kCoarse_px);
    return peaksOf(scoresOf(here.sampled(patch.grey, everywhere, kCoarse_px), searched)).runner_up;
}

/// Where the patch is, coarsely.
struct Sighted {
    PictureMap map;
    Eigen::Vector2d offset_px;
    double score;
    double runner_up;
};

Sighted searched(const Patch& patch, const cv::Mat& grey, const PictureMap& map, double radius_px) {
    const cv::Rect offsets = offsetsAround(patch, patch.identity_half_side_px, kCoarse_px);
    const int radius = cvCeil(radius_px / kCoarse_px);
    const cv::Rect wider(offsets.x - radius, offsets.y - radius, offsets.width + 2 * radius,
                         offsets.height + 2 * radius);
    const Peaks peaks = peaksOf(
        scoresOf(map.sampled(grey, wider, kCoarse_px), part(patch, patch.identity_half_side_px, kCoarse_px)));
    return {map, kCoarse_px * Eigen::Vector2d(peaks.best.x - radius, peaks.best.y - radius), peaks.best_score,
            std::max(peaks.runner_up, patch.look_alike)};
}

/// Looks again with the picture turned a little when the first look does not decide.
Sighted bestSighted(const Patch& patch, const cv::Mat& grey, const PictureMap& map, double radius_px,
                    double share) {
    std::optional<Sighted> best;
    for (const double turn_deg : kTurns_deg) {
        const Sighted sighted = searched(patch, grey, map.turned(turn_deg * CV_PI / 180), radius_px);
        if (!best || sighted.score > best->score) {
            best = sighted;
        }
        if (standsOut(best->score, best->runner_up, share)) {
            break;
        }
    }
    return *best;
}

/// The part that is measured, with the place of the click in it and the weights of its pixels.
struct MeasuredPart {
    cv::Rect offsets;
    cv::Mat grey, weights;
    cv::Point2d click;

    MeasuredPart(const Patch& patch, int half_px)
        : offsets(offsetsAround(patch, half_px, 1.0)), click(-offsets.tl()) {
        grey = part(patch, half_px, 1.0);
        weights = bellWeights(offsets.size(), click, half_px);
    }
};

/// ECC with a Euclidean warp: brings the shift and the turn within reach of the least squares, which start
/// from the coarse place where it does not converge.
PatchWarp approached(const MeasuredPart& measured, const cv::Mat& window, double margin_px) {
    const auto margin = static_cast<float>(margin_px);
    const Eigen::Vector2d click(measured.click.x, measured.click.y);
    cv::Mat warp = (cv::Mat_<float>(2, 3) << 1, 0, margin, 0, 1, margin);
    const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 1e-4);
    try {
        cv::findTransformECC(measured.grey, window, warp, cv::MOTION_EUCLIDEAN, enough, cv::noArray(), 1);
    } catch (const cv::Exception&) {
        return {Eigen::Matrix2d::Identity(), click + Eigen::Vector2d::Constant(margin_px)};
    }
    const Eigen::Matrix2d turn{{warp.at<float>(0, 0), warp.at<float>(0, 1)},
                               {warp.at<float>(1, 0), warp.at<float>(1, 1)}};
    return {turn, turn * click + Eigen::Vector2d(warp.at<float>(0, 2), warp.at<float>(1, 2))};
}

/// What the least squares say about a part of the patch, in offsets from the click.
struct Measured {
    Eigen::Vector2d offset_px;
    ShiftFit fit;
};

/// From the coarse place to a small part of a pixel; absent when it does not settle there.
std::optional<Measured> measured(const Patch& patch, int half_px, const cv::Mat& grey,
                                 const Sighted& sighted) {
    constexpr int kMargin_px = 6;
    const MeasuredPart own(patch, half_px);
    const cv::Rect wider(own.offsets.x + cvRound(sighted.offset_px.x()) - kMargin_px,
                         own.offsets.y + cvRound(sighted.offset_px.y()) - kMargin_px,
                         own.offsets.width + 2 * kMargin_px, own.offsets.height + 2 * kMargin_px);
    const cv::Mat window = sighted.map.sampled(grey, wider, 1.0);
    const auto fit = fitShift(own.grey, own.click, own.weights, window, approached(own, window, kMargin_px));
    if (!fit) {
        return std::nullopt;
    }
    const Eigen::Vector2d offset_px = fit->warp.at + Eigen::Vector2d(wider.x, wider.y);
    if ((offset_px - sighted.offset_px).norm() > 2.0 * kCoarse_px) {
        return std::nullopt;  // slid away to something else
    }
    return Measured{offset_px, *fit};
}

/// Which verdicts a fit passes.
struct Judge {
    const MatcherSettings& settings;

    /// A small patch is deformed by how its few pixels were sampled: what counts is how far that moves its
    /// pixels. Nor can a patch that is explained but for a hundredth have lost a fifth to something else.
    [[nodiscard]] bool movesAsOne(const ShiftFit& fit, int half_px) const {
        constexpr double kSampling_px = 0.5;
        constexpr double kAlmostWhole = 0.99;
        const double lever_px = 0.5 * half_px;  // under the bell of the weights
        return fit.unrest_px <= settings.most_unrest_px &&
               fit.deformation <= std::max(settings.most_deformation, kSampling_px / lever_px) &&
               (fit.kept >= settings.least_kept || fit.score >= kAlmostWhole);
    }
    [[nodiscard]] bool isSure(const ShiftFit& fit) const {
        return fit.score >= settings.least_score && fit.sigma_px <= settings.worst_sigma_px;
    }
    [[nodiscard]] bool passes(const std::optional<Measured>& m, int half_px) const {
        return m && isSure(m->fit) && movesAsOne(m->fit, half_px);
    }
    /// Both may be right: they differ by what their sigmas allow.
    [[nodiscard]] static bool agree(const Measured& a, const Measured& b) {
        constexpr double kAlways_px = 0.1;
        return (a.offset_px - b.offset_px).norm() <=
               kAlways_px + 3.0 * std::hypot(a.fit.sigma_px, b.fit.sigma_px);
    }
};

/// The patch as it was taken, when its inner part agrees and it moves as one surface; more than it where it
/// says too little.
core::Result<Measured> place(const Patch& patch, const cv::Mat& grey, const Sighted& sighted,
                             const MatcherSettings& settings) {
    const Judge judge{settings};
    const auto half_of = [&](double share) { return cvRound(share * patch.half_side_px); };
    const auto part_of = [&](double share) { return measured(patch, half_of(share), grey, sighted); };
    const auto own = part_of(1.0);
    const auto inner = part_of(kNarrower);
    if (own && own->fit.score < settings.least_score) {
        return lost(own->fit.score);
    }
    if (own && ((inner && !Judge::agree(*own, *inner)) || !judge.movesAsOne(own->fit, half_of(1.0)))) {
        return torn(own->fit.unrest_px);
    }
    if (judge.passes(own, half_of(1.0))) {
        return *own;
    }
    // What is right far from the click must be right at the click too, or it is the background that was
    // found.
    constexpr double kLeastInnerScore = 0.93;
    const auto more = part_of(kWider);
    if (judge.passes(more, half_of(kWider)) && inner && inner->fit.score >= kLeastInnerScore && Judge::agree(*more, *inner)) {
        return *more;
    }
    return own ? blurred(own->fit.sigma_px) : lost(sighted.score);
}

bool isInside(const cv::Mat& picture, const Eigen::Vector2d& px, double edge_px) {
    return px.x() >= edge_px && px.y() >= edge_px && px.x() <= picture.cols - 1 - edge_px &&
           px.y() <= picture.rows - 1 - edge_px;
}

}  // namespace

core::Result<Patch> PatchMatcher::take(const cv::Mat& bgr, const Eigen::Vector2d& click_px) const {
    if (!isInside(bgr, click_px, settings_.edge_px)) {
        return core::fail(ErrorKind::kLimit,
                          sentence("The click is too near to the edge of the picture to be found again."),
                          sentence("Turn towards the target first, then click it."), "edge");
    }
    Patch patch{.grey = smoothGrey(bgr), .click_px = click_px};
    for (const int half_px : kHalfSides_px) {
        patch.half_side_px = half_px;
        const MeasuredPart own(patch, half_px);
        patch.expected_sigma_px = expectedSigma_px(own.grey, own.click, own.weights, settings_.noise_grey);
        if (patch.expected_sigma_px <= settings_.most_sigma_px) {
            break;
        }
    }
    if (patch.expected_sigma_px > settings_.weakest_sigma_px) {
        return core::fail(ErrorKind::kUndefined,
                          sentence("There is too little detail at the click to find it again."),
                          sentence("Click a corner, a mark or a textured spot."), "plain");
    }
    constexpr double kWellApart = 0.75;
    patch.look_alike = 2.0;
    for (const int half_px : kIdentityHalfSides_px) {
        if (half_px < patch.half_side_px || patch.look_alike <= kWellApart) {
            continue;
        }
        if (const double alike = lookAlike(patch, half_px); alike < patch.look_alike) {
            patch.look_alike = alike;
            patch.identity_half_side_px = half_px;
        }
    }
    if (patch.look_alike > settings_.most_look_alike) {
        return ambiguous(1.0, patch.look_alike);
    }
    return patch;
}

core::Result<Match> PatchMatcher::find(const Patch& patch, const cv::Mat& bgr,
                                       const Expectation& expected) const {
    const auto predicted = expected.seen(patch.click_px);
    if (!predicted || !isInside(bgr, *predicted, settings_.edge_px)) {
        return outside();
    }
    const double reach_px = patch.identity_half_side_px + expected.search_radius_px;
    const auto map = PictureMap::fitted(expected, patch.click_px, reach_px);
    if (!map) {
        return outside();
    }
    const cv::Mat grey = smoothGrey(bgr);
    const Sighted sighted =
        bestSighted(patch, grey, *map, expected.search_radius_px, settings_.ambiguity_share);
    if (sighted.score < kLeastCoarseScore) {
        return lost(sighted.score);
    }
    if (!standsOut(sighted.score, sighted.runner_up, settings_.ambiguity_share)) {
        return ambiguous(sighted.score, sighted.runner_up);
    }
    const auto placed = place(patch, grey, sighted, settings_);
    PMTS_TRY(placed);
    const Match match{.px = sighted.map.at(placed->offset_px),
                      .score = placed->fit.score,
                      .runner_up = sighted.runner_up,
                      .sigma_px = placed->fit.sigma_px};
    return isInside(bgr, match.px, 0.0) ? core::Result<Match>(match) : outside();
}

}  // namespace pmts::targeting
