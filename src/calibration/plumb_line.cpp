#include "pmts/calibration/plumb_line.hpp"

#include <QCoreApplication>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pmts::calibration {
namespace {

using core::ErrorKind;
using Eigen::Vector2d;

constexpr int kRowStep = 2;       ///< rows that vote
constexpr double kBin_px = 2.0;   ///< of the vote, across
constexpr double kSlopeBin = 0.006;
constexpr double kNearLine_px = 4.0;
constexpr double kOtherLine_px = 15.0;
constexpr double kAsLong = 0.85;  ///< a second line with this share of the votes makes it ambiguous
constexpr int kProfile_px = 16;   ///< half of what is read across the line
constexpr int kWidest_px = 8;     ///< half of what may belong to the line itself

QString text(const char* sentence) { return QCoreApplication::translate("PlumbLine", sentence); }

core::Error noLine() {
    return {.kind = ErrorKind::kNotReached,
            .happened = text("No plumb line is to be seen."),
            .remedy = text("Hang it before a plain ground, put it in focus, and let it come to rest."),
            .info_code = std::nullopt,
            .detail = QStringLiteral("none")};
}

core::Error severalLines() {
    return {.kind = ErrorKind::kNotReached,
            .happened = text("Several upright lines are to be seen."),
            .remedy = text("Click the plumb line."),
            .info_code = std::nullopt,
            .detail = QStringLiteral("several")};
}

/// The picture without distortion: pixels of a pinhole camera with the lens's own centre and scale.
class Pinhole {
public:
    explicit Pinhole(const camera::Lens& lens) : lens_(lens), centre_(lens.principalPoint()), f_(lens.focalLengthPx()) {}
    [[nodiscard]] std::optional<Vector2d> straightened(const Vector2d& px) const {
        const auto ray = lens_.cameraFromPixel(px);
        return ray && ray->z() > 0.05 ? std::optional<Vector2d>(centre_ + f_ * ray->head<2>() / ray->z()) : std::nullopt;
    }
    [[nodiscard]] std::optional<Vector2d> bent(const Vector2d& straight_px) const {
        const Vector2d xy = (straight_px - centre_) / f_;
        const auto px = lens_.pixelFromCamera({xy.x(), xy.y(), 1.0});
        return px ? std::optional<Vector2d>(*px) : std::nullopt;
    }

private:
    const camera::Lens& lens_;
    Vector2d centre_;
    double f_;
};

struct Ridge {
    Vector2d px;  ///< straightened
};

/// How much a column of `width`-wide boxes stands out from both its sides; the sign is lost on purpose.
cv::Mat standsOut(const cv::Mat& grey, int width) {
    cv::Mat box, left, right, out;
    cv::blur(grey, box, {width, 3});
    const cv::Mat to_left = (cv::Mat_<double>(2, 3) << 1, 0, width, 0, 1, 0);
    const cv::Mat to_right = (cv::Mat_<double>(2, 3) << 1, 0, -width, 0, 1, 0);
    cv::warpAffine(box, left, to_left, box.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    cv::warpAffine(box, right, to_right, box.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    // Darker than both sides: less than the darker of them; lighter likewise.
    cv::Mat darkest, lightest;
    cv::min(left, right, darkest);
    cv::max(left, right, lightest);
    cv::max(cv::Mat(darkest - box), cv::Mat(box - lightest), out);
    return out;
}

std::vector<Ridge> ridgesOf(const cv::Mat& grey, const Pinhole& pinhole, double least_grey) {
    cv::Mat response = standsOut(grey, 3);
    cv::max(response, standsOut(grey, 7), response);
    std::vector<Ridge> ridges;
    for (int row = 0; row < response.rows; row += kRowStep) {
        const auto* value = response.ptr<float>(row);
        for (int col = 8; col + 8 < response.cols; ++col) {
            if (value[col] < least_grey || value[col] < value[col - 1] || value[col] <= value[col + 1]) {
                continue;
            }
            if (const auto px = pinhole.straightened({col, row})) {
                ridges.push_back({*px});
            }
        }
    }
    return ridges;
}

/// x = at_middle + slope (y - middle), straightened pixels.
struct Line {
    double at_middle = 0.0;
    double slope = 0.0;
    double middle = 0.0;

    [[nodiscard]] double x(double y) const { return at_middle + slope * (y - middle); }
    [[nodiscard]] double off(const Vector2d& px) const { return std::abs(px.x() - x(px.y())); }
};

/// Votes of all ridges for lines, and the best of them.
class Vote {
public:
    Vote(const std::vector<Ridge>& ridges, cv::Size size, double most_slope) : ridges_(ridges), middle_(size.height / 2.0) {
        slopes_ = 2 * static_cast<int>(std::ceil(most_slope / kSlopeBin)) + 1;
        left_ = -size.width / 4.0;
        votes_ = cv::Mat::zeros(slopes_, static_cast<int>(1.5 * size.width / kBin_px), CV_32S);
        for (const Ridge& ridge : ridges) {
            for (int s = 0; s < slopes_; ++s) {
                const double x = ridge.px.x() - slope(s) * (ridge.px.y() - middle_);
                const int bin = static_cast<int>((x - left_) / kBin_px);
                if (bin >= 0 && bin < votes_.cols) {
                    ++votes_.at<int>(s, bin);
                }
            }
        }
        votes_.convertTo(smooth_, CV_32F);
        cv::boxFilter(smooth_, smooth_, -1, {3, 1}, {-1, -1}, false);
    }
    struct Winner {
        Line line;
        double votes = 0.0;
    };
    [[nodiscard]] Winner best(const std::function<bool(const Line&)>& counts) const {
        Winner winner;
        for (int s = 0; s < slopes_; ++s) {
            const auto* row = smooth_.ptr<float>(s);
            for (int bin = 0; bin < smooth_.cols; ++bin) {
                if (row[bin] > winner.votes) {
                    const Line line{left_ + (bin + 0.5) * kBin_px, slope(s), middle_};
                    if (counts(line)) {
                        winner = {line, row[bin]};
                    }
                }
            }
        }
        return winner;
    }
    /// Least squares of the ridges along it.
    [[nodiscard]] Line refined(Line line) const {
        for (const double near_px : {kNearLine_px, kNearLine_px / 2, kNearLine_px / 2}) {
            double n = 0, sy = 0, sx = 0, syy = 0, sxy = 0;
            for (const Ridge& ridge : ridges_) {
                if (line.off(ridge.px) < near_px) {
                    const double y = ridge.px.y() - middle_;
                    n += 1, sy += y, sx += ridge.px.x(), syy += y * y, sxy += y * ridge.px.x();
                }
            }
            const double determinant = n * syy - sy * sy;
            if (n < 3 || determinant < 1e-9) {
                return line;
            }
            line.slope = (n * sxy - sy * sx) / determinant;
            line.at_middle = (sx - line.slope * sy) / n;
        }
        return line;
    }

private:
    [[nodiscard]] double slope(int s) const { return (s - slopes_ / 2) * kSlopeBin; }

    const std::vector<Ridge>& ridges_;
    double middle_;
    int slopes_ = 0;
    double left_ = 0.0;
    cv::Mat votes_, smooth_;
};

/// The line's middle in one row: centroid of what differs from the ground at both sides.
struct Across {
    double x = 0.0;
    double contrast_grey = 0.0;
};

std::optional<Across> across(const cv::Mat& grey, int row, double about_x) {
    const int middle = static_cast<int>(std::lround(about_x));
    if (middle - kProfile_px < 0 || middle + kProfile_px >= grey.cols) {
        return std::nullopt;
    }
    const float* value = grey.ptr<float>(row) + middle;
    const auto ground = [value](int from, int to) {
        std::vector<float> side(value + from, value + to);
        std::nth_element(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(side.size() / 2), side.end());
        return side[side.size() / 2];
    };
    const double left = ground(-kProfile_px, -kWidest_px + 1);
    const double right = ground(kWidest_px, kProfile_px + 1);
    double peak = 0;
    for (int i = -3; i <= 3; ++i) {
        const double here = value[i] - (left + (right - left) * (i + kProfile_px) / (2.0 * kProfile_px));
        peak = std::abs(here) > std::abs(peak) ? here : peak;
    }
    const double sign = peak < 0 ? -1 : 1;
    double sum = 0, moment = 0;
    for (int i = -kWidest_px; i <= kWidest_px; ++i) {
        const double here = sign * (value[i] - (left + (right - left) * (i + kProfile_px) / (2.0 * kProfile_px)));
        const double weight = std::max(0.0, here - 0.15 * std::abs(peak));
        sum += weight;
        moment += weight * i;
    }
    return sum > 0 ? std::optional(Across{middle + moment / sum, peak}) : std::nullopt;
}

PictureLine placesAlong(const cv::Mat& grey, const Pinhole& pinhole, const Line& line, double least_grey) {
    PictureLine found;
    std::vector<double> contrasts;
    for (int row = 1; row + 1 < grey.rows; ++row) {
        const auto about = pinhole.bent({line.x(row), static_cast<double>(row)});
        if (!about || about->y() < 0 || about->y() > grey.rows - 1) {
            continue;
        }
        // The bent line at exactly this row: one step of the way back suffices, the slope is small.
        const auto place = across(grey, row, about->x() + line.slope * (row - about->y()));
        if (place && std::abs(place->contrast_grey) >= least_grey) {
            const auto straight = pinhole.straightened({place->x, static_cast<double>(row)});
            if (straight && line.off(*straight) < kNearLine_px) {
                found.places_px.emplace_back(place->x, row);
                contrasts.push_back(std::abs(place->contrast_grey));
            }
        }
    }
    if (!found.places_px.empty()) {
        std::nth_element(contrasts.begin(), contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() / 2), contrasts.end());
        found.contrast_grey = contrasts[contrasts.size() / 2];
        found.length_px = (found.places_px.back() - found.places_px.front()).norm();
    }
    return found;
}

}  // namespace

core::Result<PictureLine> findPlumbLine(const cv::Mat& bgr, const camera::Lens& lens,
                                        const std::optional<Vector2d>& clicked_px, const PlumbLineSettings& settings) {
    if (bgr.empty()) {
        return tl::unexpected(noLine());
    }
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(grey, CV_32F);
    const Pinhole pinhole(lens);
    const std::vector<Ridge> ridges = ridgesOf(grey, pinhole, settings.least_contrast_grey);
    const double most_slope = std::tan(core::Angle::fromGon(settings.most_lean_gon).rad());
    const Vote vote(ridges, bgr.size(), most_slope);
    const auto clicked = clicked_px ? pinhole.straightened(*clicked_px) : std::nullopt;
    const auto winner = vote.best([&](const Line& line) { return !clicked || line.off(*clicked) < settings.near_px; });
    const double least_rows = settings.least_length * bgr.rows / kRowStep;
    if (winner.votes < least_rows / 2) {
        return tl::unexpected(noLine());
    }
    const Line line = vote.refined(winner.line);
    PictureLine found = placesAlong(grey, pinhole, line, settings.least_contrast_grey);
    if (static_cast<double>(found.places_px.size()) < settings.least_length * bgr.rows) {
        return tl::unexpected(noLine());
    }
    const double half = bgr.rows / 2.0;
    const auto second = vote.best([&](const Line& other) {
        const double apart = std::min({std::abs(other.x(half / 2) - line.x(half / 2)), std::abs(other.x(half) - line.x(half)),
                                       std::abs(other.x(1.5 * half) - line.x(1.5 * half))});
        return apart > kOtherLine_px;
    });
    if (!clicked && second.votes > kAsLong * winner.votes) {
        return tl::unexpected(severalLines());
    }
    return found;
}

}  // namespace pmts::calibration
