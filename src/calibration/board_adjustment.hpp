#pragma once

#include "pmts/calibration/board.hpp"

#include <array>
#include <vector>

namespace pmts::calibration {

/// f, cx, cy, k1, k2, k3, p1, p2 as one block: the order of BoardIntrinsics below.
constexpr int kBoardIntrinsics = 8;
using BoardIntrinsics = std::array<double, kBoardIntrinsics>;
/// Rotation vector and translation, camera from board, OpenCV's.
using BoardPose = std::array<double, 6>;

struct BoardAdjustment {
    BoardIntrinsics intrinsics{};
    std::array<std::optional<double>, kBoardIntrinsics> deviations{};
    std::vector<BoardPose> poses;
    std::vector<std::vector<Eigen::Vector2d>> residuals_px;  ///< view by view, modelled less observed
    double rms_px = 0.0;
};

/// Least squares over all corners from these starting values; nothing when it does not settle.
[[nodiscard]] std::optional<BoardAdjustment> adjustBoards(const std::vector<BoardView>& views, const BoardIntrinsics& start,
                                                          const std::vector<BoardPose>& poses, bool free_k3);

}  // namespace pmts::calibration
