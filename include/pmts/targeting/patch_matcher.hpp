#pragma once

#include "pmts/core/result.hpp"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <functional>
#include <optional>

namespace pmts::targeting {

/// What somebody clicked: the picture around it, and how much of that is needed to know it again.
struct Patch {
    cv::Mat grey;                   ///< the whole picture, CV_32F, slightly smoothed
    Eigen::Vector2d click_px;       ///< in that picture, sub-pixel
    int half_side_px = 0;           ///< the part that is measured: just large enough for expected_sigma_px
    int identity_half_side_px = 0;  ///< the part that tells it from its look-alikes, >= half_side_px
    double look_alike = 0.0;        ///< best score of anything else in its own picture
    double expected_sigma_px =
        0;  ///< one sigma of a match in the patch's weaker direction, from its gradients
};

/// Where the old picture should be in the new one.
struct Expectation {
    /// Pixel of the new picture that shows what this pixel of the old one showed; from the rig model.
    std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d& old_px)> seen;
    double search_radius_px = 60.0;  ///< in the old picture's pixels
};

struct Match {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();  ///< place of the click in the new picture, sub-pixel
    double score = 0.0;      ///< correlation coefficient of the refined fit, 1 is perfect
    double runner_up = 0.0;  ///< best score of anything else, in either picture
    double sigma_px = 0.0;   ///< one sigma of px, from the grey values left over and the gradients
};

struct MatcherSettings {
    double least_score = 0.80;
    /// A match leaves at most this share of the variance its best look-alike leaves; else it is ambiguous.
    double ambiguity_share = 0.5;
    double most_look_alike = 0.95;    ///< a click that resembles another spot this much is refused
    double noise_grey = 3.0;          ///< assumed of the camera
    double most_sigma_px = 0.03;      ///< a patch grows until it promises this
    double weakest_sigma_px = 0.045;  ///< what the largest patch must promise
    double worst_sigma_px = 0.085;    ///< a match less certain than this is refused
    double most_unrest_px = 0.08;     ///< parts of a patch that move on by more than this tear it
    double least_kept = 0.8;        ///< of a patch: what else is in it must not be a fifth
    double most_deformation = 0.05;   ///< 2 degrees are 0.035; more is two surfaces, not one
    double edge_px = 8.0;             ///< a click nearer to the edge than this cannot be found again
};

/// Finds a clicked patch again: normalised correlation over the search window, then ECC with a Euclidean
/// warp, so that exposure, contrast, mild blur and 2 degrees of rotation do not matter. OpenCV does the work.
/// Values in, values out: callable on any thread.
class PatchMatcher {
public:
    explicit PatchMatcher(MatcherSettings settings = {}) : settings_(settings) {}

    /// kLimit when the click is too near to the edge; kUndefined where nothing can be recognised (sky, plain
    /// wall, an edge without a corner); kNotReached where other spots look the same.
    [[nodiscard]] core::Result<Patch> take(const cv::Mat& bgr, const Eigen::Vector2d& click_px) const;
    /// kNotReached with a sentence when the patch is lost, ambiguous, out of the picture, torn by an edge in
    /// depth or too blurred; Error::detail starts with `lost`, `ambiguous`, `outside`, `torn` or `blurred`.
    [[nodiscard]] core::Result<Match> find(const Patch& patch, const cv::Mat& bgr,
                                           const Expectation& expected) const;

private:
    MatcherSettings settings_;
};

}  // namespace pmts::targeting
