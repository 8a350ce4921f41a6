#include "pmts/calibration/mount_check.hpp"

#include <QCoreApplication>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::ErrorKind;
using Eigen::Vector2d;

constexpr int kHalf_px = 15;             ///< of the patch that is looked for again
constexpr double kLeastMove_px = 8.0;
constexpr double kLargestMove = 1.0 / 3;  ///< of the picture's height
constexpr int kMostDetails = 60;
constexpr std::size_t kLeastDetails = 8;
constexpr double kLeastGrey = 6.0;  ///< standard deviation in a patch
constexpr double kLeastScore = 0.8;
constexpr double kMostLookAlike = 0.97;
constexpr double kWrongLens = 0.35;  ///< the scale of the lens may be this far off
constexpr double kSlack_px = 2.0;
constexpr double kAgreed = 0.75;

QString text(const char* sentence) { return QCoreApplication::translate("MountCheck", sentence); }

core::Error nothingToFollow() {
    return {.kind = ErrorKind::kUndefined,
            .happened = text("The picture shows too little to follow."),
            .remedy = text("Turn to something with detail, such as a facade, and check again."),
            .info_code = std::nullopt,
            .detail = {}};
}

cv::Mat greyOf(const cv::Mat& picture) {
    cv::Mat grey = picture;
    if (picture.channels() == 3) {
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    }
    cv::GaussianBlur(grey, grey, {}, 1.0);
    return grey;
}

/// How far a pixel moves when the camera is on the telescope; the scene far away.
class TelescopeMotion {
public:
    TelescopeMotion(const camera::Rig& rig, const geometry::Pointing& before, const geometry::Pointing& after)
        : lens_(rig.lens) {
        camera::Mount mount = rig.mount;
        mount.kind = MountKind::kTelescope;
        after_from_before_ = camera::cameraPose(mount, after).station_from_camera.transpose() *
                             camera::cameraPose(mount, before).station_from_camera;
    }
    [[nodiscard]] std::optional<Vector2d> of(const Vector2d& px) const {
        const auto ray = lens_.cameraFromPixel(px);
        const auto there = ray ? lens_.pixelFromCamera(after_from_before_ * *ray) : core::Result<Vector2d>(Vector2d());
        return ray && there ? std::optional<Vector2d>(*there - px) : std::nullopt;
    }

private:
    const camera::Lens& lens_;
    Eigen::Matrix3d after_from_before_;
};

/// The patch's place in the second picture, anywhere between staying and moving a third too far either way.
std::optional<Vector2d> foundAgain(const cv::Mat& before, const cv::Mat& after, const cv::Point& at, const Vector2d& expected) {
    const cv::Rect picture({0, 0}, before.size());
    const cv::Rect patch(at.x - kHalf_px, at.y - kHalf_px, 2 * kHalf_px + 1, 2 * kHalf_px + 1);
    const int reach = 12 + static_cast<int>((1 + kWrongLens) * expected.norm());
    const cv::Rect window = cv::Rect(patch.x - reach, patch.y - reach, patch.width + 2 * reach, patch.height + 2 * reach) & picture;
    cv::Scalar mean, spread;
    if ((patch & picture) != patch) {
        return std::nullopt;
    }
    cv::meanStdDev(before(patch), mean, spread);
    if (spread[0] < kLeastGrey) {
        return std::nullopt;
    }
    cv::Mat scores;
    cv::matchTemplate(after(window), before(patch), scores, cv::TM_CCOEFF_NORMED);
    double best = 0, other = 0;
    cv::Point place;
    cv::minMaxLoc(scores, nullptr, &best, nullptr, &place);
    cv::circle(scores, place, 6, cv::Scalar(-1), cv::FILLED);
    cv::minMaxLoc(scores, nullptr, &other, nullptr, nullptr);
    if (best < kLeastScore || other > kMostLookAlike * best) {
        return std::nullopt;
    }
    return Vector2d(window.x + place.x - patch.x, window.y + place.y - patch.y);
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

MountCheck judged(std::vector<MovedDetail> details) {
    MountCheck check;
    std::vector<double> along, expected;
    std::size_t telescope = 0, handle = 0;
    for (const MovedDetail& detail : details) {
        const double far_px = detail.expected_px.norm();
        along.push_back(detail.moved_px.dot(detail.expected_px) / far_px);
        expected.push_back(far_px);
        telescope += (detail.moved_px - detail.expected_px).norm() < kWrongLens * far_px + kSlack_px ? 1U : 0U;
        handle += detail.moved_px.norm() < 0.1 * far_px + kSlack_px ? 1U : 0U;
    }
    check.confidence = static_cast<double>(std::max(telescope, handle)) / static_cast<double>(details.size());
    if (check.confidence >= kAgreed) {
        check.kind = telescope > handle ? MountKind::kTelescope : MountKind::kHandle;
    }
    check.moved_px = median(along);
    check.expected_px = median(expected);
    check.details = std::move(details);
    return check;
}

}  // namespace

core::Result<MountCheck> mountFromMotion(const cv::Mat& before, const geometry::Pointing& at_before, const cv::Mat& after,
                                         const geometry::Pointing& at_after, const camera::Rig& rig) {
    if (before.empty() || before.size() != after.size()) {
        return core::fail(ErrorKind::kBadInput, text("The two pictures do not belong together."), text("Check again."));
    }
    const TelescopeMotion motion(rig, at_before, at_after);
    const auto middle = motion.of({before.cols / 2.0, before.rows / 2.0});
    if (!middle || middle->norm() < kLeastMove_px || middle->norm() > kLargestMove * before.rows) {
        return core::fail(ErrorKind::kLimit, text("This turn does not tell one mount from the other."),
                          text("Choose a turn of VA that moves the picture by about a tenth of its height."));
    }
    const cv::Mat grey_before = greyOf(before);
    const cv::Mat grey_after = greyOf(after);
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(grey_before, corners, kMostDetails, 0.01, 40.0);
    std::vector<MovedDetail> details;
    for (const cv::Point2f& corner : corners) {
        const auto expected = motion.of({corner.x, corner.y});
        const auto moved = expected ? foundAgain(grey_before, grey_after, cv::Point(corner), *expected) : std::nullopt;
        if (moved) {
            details.push_back({.px = {corner.x, corner.y}, .moved_px = *moved, .expected_px = *expected});
        }
    }
    if (details.size() < kLeastDetails) {
        return tl::unexpected(nothingToFollow());
    }
    return judged(std::move(details));
}

}  // namespace pmts::calibration
