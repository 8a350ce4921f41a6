#include "pmts/calibration/board_calibration.hpp"

#include "board_adjustment.hpp"

#include <QCoreApplication>
#include <QDir>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace pmts::calibration {
namespace {

using core::ErrorKind;

QString text(const char* sentence) { return QCoreApplication::translate("Board", sentence); }

std::vector<std::vector<cv::Point3f>> boardPoints(const std::vector<BoardView>& views) {
    std::vector<std::vector<cv::Point3f>> all;
    for (const BoardView& view : views) {
        auto& points = all.emplace_back();
        for (const Eigen::Vector2d& at : view.board_m) {
            points.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F);
        }
    }
    return all;
}

std::vector<std::vector<cv::Point2f>> picturePoints(const std::vector<BoardView>& views) {
    std::vector<std::vector<cv::Point2f>> all;
    for (const BoardView& view : views) {
        auto& points = all.emplace_back();
        for (const Eigen::Vector2d& px : view.px) {
            points.emplace_back(static_cast<float>(px.x()), static_cast<float>(px.y()));
        }
    }
    return all;
}

cv::Size sizeOf(const std::vector<BoardView>& views) { return {views.front().width_px, views.front().height_px}; }

/// Focal length from the boards' perspective (Zhang 2000 through OpenCV), centre in the middle, no distortion.
BoardIntrinsics startOf(const std::vector<BoardView>& views) {
    const cv::Size size = sizeOf(views);
    const cv::Mat k = cv::initCameraMatrix2D(boardPoints(views), picturePoints(views), size, 1.0);
    const double f_px = k.at<double>(0, 0);
    const double usual_px = size.width;
    const bool is_sound = std::isfinite(f_px) && f_px > 0.2 * usual_px && f_px < 20 * usual_px;
    return {is_sound ? f_px : usual_px, (size.width - 1) / 2.0, (size.height - 1) / 2.0, 0, 0, 0, 0, 0};
}

std::vector<BoardPose> posesOf(const std::vector<BoardView>& views, const BoardIntrinsics& lens) {
    const cv::Matx33d k(lens[0], 0, lens[1], 0, lens[0], lens[2], 0, 0, 1);
    const auto on_board = boardPoints(views);
    const auto seen = picturePoints(views);
    std::vector<BoardPose> poses;
    for (std::size_t v = 0; v < views.size(); ++v) {
        cv::Vec3d turn;
        cv::Vec3d shift;
        cv::solvePnP(on_board[v], seen[v], k, cv::noArray(), turn, shift);
        poses.push_back({turn[0], turn[1], turn[2], shift[0], shift[1], shift[2]});
    }
    return poses;
}

std::optional<BoardAdjustment> adjusted(const std::vector<BoardView>& views, bool free_k3) {
    const BoardIntrinsics start = startOf(views);
    return adjustBoards(views, start, posesOf(views, start), free_k3);
}

double rmsOf(const std::vector<Eigen::Vector2d>& residuals_px) {
    double sum = 0.0;
    for (const Eigen::Vector2d& residual : residuals_px) {
        sum += residual.squaredNorm();
    }
    return std::sqrt(sum / (2.0 * static_cast<double>(residuals_px.size())));
}

/// The view that fits worst, when it is far outside the others.
std::optional<std::size_t> misfit(const BoardAdjustment& solution, double refuse_above) {
    constexpr double kNeverBelow_px = 0.3;  // a good fit has no bad views
    std::vector<double> rms_px;
    for (const auto& residuals : solution.residuals_px) {
        rms_px.push_back(rmsOf(residuals));
    }
    const auto worst = std::max_element(rms_px.begin(), rms_px.end());
    std::vector<double> sorted = rms_px;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double median_px = sorted[sorted.size() / 2];
    return *worst > std::max(kNeverBelow_px, refuse_above * median_px) ? std::optional(static_cast<std::size_t>(worst - rms_px.begin()))
                                                                     : std::nullopt;
}

camera::Lens lensOf(const BoardIntrinsics& l) {
    return camera::Lens(camera::BrownLens{.f_px = l[0], .cx_px = l[1], .cy_px = l[2], .k1 = l[3], .k2 = l[4], .k3 = l[5], .p1 = l[6], .p2 = l[7]});
}

/// OpenCV's own calibration of the same corners with the same unknowns: the second opinion.
void addOpenCv(BoardCalibration& result, const std::vector<BoardView>& views, bool free_k3) {
    cv::Mat k = cv::Mat::eye(3, 3, CV_64F);
    cv::Mat d = cv::Mat::zeros(1, 5, CV_64F);
    std::vector<cv::Mat> turns;
    std::vector<cv::Mat> shifts;
    const int flags = cv::CALIB_FIX_ASPECT_RATIO | (free_k3 ? 0 : cv::CALIB_FIX_K3);
    // OpenCV counts points, we count coordinates.
    result.opencv_rms_px = cv::calibrateCamera(boardPoints(views), picturePoints(views), sizeOf(views), k, d, turns, shifts, flags) / std::sqrt(2.0);
    result.opencv_lens = lensOf({k.at<double>(0, 0), k.at<double>(0, 2), k.at<double>(1, 2), d.at<double>(0), d.at<double>(1),
                                 d.at<double>(4), d.at<double>(2), d.at<double>(3)});
}

void addCoverage(BoardCalibration& result, const std::vector<BoardView>& views) {
    constexpr int kColumns = 8;
    constexpr int kRows = 6;
    const Eigen::Vector2d middle((result.width_px - 1) / 2.0, (result.height_px - 1) / 2.0);
    std::set<std::pair<int, int>> fields;
    for (const BoardView& view : views) {
        for (const Eigen::Vector2d& px : view.px) {
            fields.emplace(std::clamp(static_cast<int>(px.x() * kColumns / result.width_px), 0, kColumns - 1),
                           std::clamp(static_cast<int>(px.y() * kRows / result.height_px), 0, kRows - 1));
            result.reach = std::max(result.reach, (px - middle).norm() / middle.norm());
        }
    }
    result.coverage = static_cast<double>(fields.size()) / (kColumns * kRows);
}

void addWarnings(BoardCalibration& result) {
    constexpr double kMostOfF = 0.005;
    constexpr double kLeastCoverage = 0.6;
    const auto& f = result.parameters.front();
    if (!f.standard_deviation || *f.standard_deviation > kMostOfF * f.value) {
        result.warnings.append(text("The views leave the focal length open: tilt the board in several directions."));
    }
    if (result.coverage < kLeastCoverage) {
        result.warnings.append(text("The boards cover %1 % of the picture: bring them to its edges and corners too.")
                                   .arg(100 * result.coverage, 0, 'f', 0));
    }
    if (std::abs(result.rms_px / result.opencv_rms_px - 1) > 0.05) {
        result.warnings.append(text("OpenCV's own calibration of these corners differs (%1 px).").arg(result.opencv_rms_px, 0, 'f', 3));
    }
}

void addParameters(BoardCalibration& result, const BoardAdjustment& solution, bool free_k3) {
    constexpr std::array kOrder{RigParameter::kFocalLength, RigParameter::kCentreX, RigParameter::kCentreY, RigParameter::kK1,
                                RigParameter::kK2,          RigParameter::kK3,      RigParameter::kP1,      RigParameter::kP2};
    for (std::size_t i = 0; i < kOrder.size(); ++i) {
        if (free_k3 || kOrder[i] != RigParameter::kK3) {
            result.parameters.push_back({kOrder[i], solution.intrinsics[i], solution.deviations[i]});
        }
    }
}

core::Result<BoardCalibration> reportOf(const BoardAdjustment& solution, const std::vector<BoardView>& views, bool free_k3) {
    if (!(solution.intrinsics[0] > 0)) {
        return core::fail(ErrorKind::kUndefined, text("The calibration does not settle."), text("Tilt the board in several directions."));
    }
    BoardCalibration result{.lens = lensOf(solution.intrinsics), .width_px = views.front().width_px,
                            .height_px = views.front().height_px, .rms_px = solution.rms_px, .opencv_lens = {}};
    addOpenCv(result, views, free_k3);
    addParameters(result, solution, free_k3);
    addCoverage(result, views);
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto& residuals = solution.residuals_px[v];
        result.views.push_back({views[v].name, static_cast<int>(residuals.size()), rmsOf(residuals)});
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            result.residuals.push_back({views[v].px[i], residuals[i]});
        }
    }
    addWarnings(result);
    return result;
}

core::Result<void> usable(const std::vector<BoardView>& views, std::size_t least) {
    if (views.size() < least) {
        return core::fail(ErrorKind::kBadInput, text("There are %1 views of the board; at least %2 are needed.").arg(views.size()).arg(least),
                          text("Show the board in other places and tilts."));
    }
    const auto other = std::find_if(views.begin(), views.end(), [&](const BoardView& view) {
        return view.width_px != views.front().width_px || view.height_px != views.front().height_px;
    });
    if (other != views.end()) {
        return core::fail(ErrorKind::kBadInput, text("“%1” has another size than the other pictures.").arg(other->name),
                          text("Calibrate one mode of the camera at a time."));
    }
    return {};
}

}  // namespace

core::Result<BoardCalibration> calibrateBoard(const std::vector<BoardView>& given, const BoardOptions& options) {
    PMTS_TRY(usable(given, options.least_views));
    std::vector<BoardView> views = given;
    std::vector<RefusedView> refused;
    try {
        auto solution = adjusted(views, options.free_k3);
        for (auto bad = solution ? misfit(*solution, options.refuse_above) : std::nullopt;
             bad && views.size() > options.least_views; bad = misfit(*solution, options.refuse_above)) {
            refused.push_back({views[*bad].name, text("it does not fit the others (%1 px)").arg(rmsOf(solution->residuals_px[*bad]), 0, 'f', 2)});
            views.erase(views.begin() + static_cast<std::ptrdiff_t>(*bad));
            solution = adjusted(views, options.free_k3);
            if (!solution) {
                break;
            }
        }
        if (solution) {
            auto result = reportOf(*solution, views, options.free_k3);
            PMTS_TRY(result);
            result->refused = std::move(refused);
            return result;
        }
    } catch (const cv::Exception& trouble) {
        return core::fail(ErrorKind::kUndefined, text("The calibration does not settle."), text("Tilt the board in several directions."),
                          QString::fromStdString(trouble.err));
    }
    return core::fail(ErrorKind::kUndefined, text("The calibration does not settle."), text("Tilt the board in several directions."));
}

core::Result<BoardCalibration> calibrateBoardFolder(const QString& folder, const BoardPattern& pattern, const BoardOptions& options,
                                                    const std::function<bool(int, int)>& go_on) {
    PMTS_TRY(usablePattern(pattern));
    const QStringList kinds{QStringLiteral("*.png"), QStringLiteral("*.jpg"), QStringLiteral("*.jpeg"), QStringLiteral("*.bmp"), QStringLiteral("*.tif"), QStringLiteral("*.tiff")};
    const QStringList names = QDir(folder).entryList(kinds, QDir::Files, QDir::Name);
    if (names.isEmpty()) {
        return core::fail(ErrorKind::kBadInput, text("There are no pictures in “%1”.").arg(folder), text("Give a folder of png, jpg, bmp or tif pictures."));
    }
    std::vector<BoardView> views;
    std::vector<RefusedView> refused;
    for (int i = 0; i < names.size(); ++i) {
        if (go_on && !go_on(i, static_cast<int>(names.size()))) {
            return core::cancelled();
        }
        const cv::Mat picture = cv::imread(QDir(folder).filePath(names[i]).toStdString(), cv::IMREAD_GRAYSCALE);
        auto view = findBoard(picture, pattern, names[i]);
        if (view) {
            views.push_back(*std::move(view));
        } else {
            refused.push_back({names[i], view.error().happened});
        }
    }
    auto result = calibrateBoard(views, options);
    if (!result && !refused.empty()) {
        core::Error error = result.error();
        error.happened += u' ' + text("%1 pictures were refused, “%2”: %3").arg(refused.size()).arg(refused.front().name, refused.front().reason);
        return tl::unexpected(error);
    }
    PMTS_TRY(result);
    result->refused.insert(result->refused.begin(), refused.begin(), refused.end());
    return result;
}

QString boardCalibrationText(const BoardCalibration& result) {
    QStringList lines;
    lines.append(text("Picture %1x%2, %3 views, %4 corners").arg(result.width_px).arg(result.height_px).arg(result.views.size()).arg(result.residuals.size()));
    lines.append(text("rms %1 px over coordinates (OpenCV on the same corners %2 px)").arg(result.rms_px, 0, 'f', 4).arg(result.opencv_rms_px, 0, 'f', 4));
    for (const ParameterEstimate& parameter : result.parameters) {
        const QString deviation = parameter.standard_deviation ? QString::number(*parameter.standard_deviation, 'g', 3) : text("not determined");
        lines.append(QStringLiteral("%1 = %2  ± %3").arg(parameterName(parameter.parameter), QString::number(parameter.value, 'g', 8), deviation));
    }
    lines.append(text("coverage %1 %, reach %2 % of the half diagonal").arg(100 * result.coverage, 0, 'f', 0).arg(100 * result.reach, 0, 'f', 0));
    for (const BoardViewResult& view : result.views) {
        lines.append(text("%1: %2 corners, rms %3 px").arg(view.name).arg(view.corners).arg(view.rms_px, 0, 'f', 4));
    }
    for (const RefusedView& view : result.refused) {
        lines.append(text("refused %1: %2").arg(view.name, view.reason));
    }
    for (const QString& warning : result.warnings) {
        lines.append(text("note: %1").arg(warning));
    }
    return lines.join(u'\n');
}

}  // namespace pmts::calibration
