#pragma once

#include "pmts/calibration/board.hpp"
#include "pmts/calibration/rig_fit.hpp"

namespace pmts::calibration {

struct BoardViewResult {
    QString name;
    int corners = 0;
    double rms_px = 0.0;  ///< over coordinates
};

struct RefusedView {
    QString name;
    QString reason;
};

struct BoardResidual {
    Eigen::Vector2d px;
    Eigen::Vector2d residual_px;  ///< modelled less observed
};

struct BoardCalibration {
    camera::Lens lens;                 ///< BrownLens
    int width_px = 0;
    int height_px = 0;
    double rms_px = 0.0;               ///< over coordinates, ours
    double opencv_rms_px = 0.0;        ///< cv::calibrateCamera on the same corners, same model, over coordinates
    camera::Lens opencv_lens{};
    std::vector<BoardViewResult> views{};
    std::vector<RefusedView> refused{};
    std::vector<ParameterEstimate> parameters{};  ///< f, cx, cy and the distortion that was free
    double coverage = 0.0;             ///< share of 8x6 fields of the picture with a corner in them
    double reach = 0.0;                ///< farthest corner from the middle, of the half diagonal
    std::vector<BoardResidual> residuals{};
    QStringList warnings{};              ///< what the views cannot tell, in sentences
};

struct BoardOptions {
    bool free_k3 = false;              ///< worth it for wide lenses only
    double refuse_above = 3.0;         ///< views with an rms above this many times the median are left out
    std::size_t least_views = 4;
};

/// Lens from views of a board: our own adjustment of f, cx, cy, k1, k2, p1, p2 (k3) and a pose for each view, started from
/// cv::initCameraMatrix2D, and OpenCV's beside it as the second opinion. Views that do not fit are refused with the reason.
/// kBadInput with too few views or views of different sizes; kUndefined when it does not settle or all boards stand alike.
[[nodiscard]] core::Result<BoardCalibration> calibrateBoard(const std::vector<BoardView>& views, const BoardOptions& options = {});

/// All pictures of a folder (png, jpg, bmp, tif), the ones without a board among `refused`. `go_on` is told how many are read; false
/// ends it with kCancelled.
[[nodiscard]] core::Result<BoardCalibration> calibrateBoardFolder(const QString& folder, const BoardPattern& pattern,
                                                                  const BoardOptions& options = {},
                                                                  const std::function<bool(int done, int of)>& go_on = {});

/// The result as a text of lines, for the command line and the clipboard.
[[nodiscard]] QString boardCalibrationText(const BoardCalibration& result);

}  // namespace pmts::calibration
