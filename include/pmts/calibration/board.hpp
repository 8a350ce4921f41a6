#pragma once

#include "pmts/camera/lens.hpp"
#include "pmts/core/result.hpp"

#include <Eigen/Core>
#include <QString>
#include <QStringList>
#include <opencv2/core/mat.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace pmts::calibration {

/// A printed board. Its inner corners count, as OpenCV counts them: a 9x6 board has 10x7 squares.
struct BoardPattern {
    int columns = 9;         ///< inner corners across
    int rows = 6;            ///< inner corners down
    double square_m = 0.025;
    QString dictionary{};      ///< ChArUco: `DICT_4X4_50` ...; empty: a plain chessboard
    double marker_m = 0.0;   ///< ChArUco: side of a marker; 0: as boardModules() draws it

    [[nodiscard]] bool isCharuco() const { return !dictionary.isEmpty(); }
    [[nodiscard]] bool operator==(const BoardPattern&) const = default;
};

/// Names of the ChArUco dictionaries.
[[nodiscard]] QStringList boardDictionaries();
/// kBadInput with the reason: fewer than 3x3 corners, a dictionary that is unknown or has too few markers.
[[nodiscard]] core::Result<void> usablePattern(const BoardPattern& pattern);

/// The board as black (0) and white (255) cells, the smallest picture that shows it exactly; `cells_per_square` wide each square.
struct BoardModules {
    cv::Mat cells;
    int cells_per_square = 1;
};
[[nodiscard]] core::Result<BoardModules> boardModules(const BoardPattern& pattern);

/// One picture with a board: corners in it and where they are on the board (metres, z = 0).
struct BoardView {
    QString name;
    int width_px = 0;
    int height_px = 0;
    std::vector<Eigen::Vector2d> px;
    std::vector<Eigen::Vector2d> board_m;
    double sharpness = 0.0;  ///< grey values per px across the squares' edges, as a share of their contrast
};

/// Finds the board's corners in a picture (8-bit, BGR or grey), subpixel. kUndefined with the reason when it is not
/// there, covers too little of the picture or is blurred.
[[nodiscard]] core::Result<BoardView> findBoard(const cv::Mat& picture, const BoardPattern& pattern, const QString& name = {});

/// True when the board stands clearly elsewhere than in all these views: worth another one.
[[nodiscard]] bool isNewView(const BoardView& view, const std::vector<BoardView>& others);

}  // namespace pmts::calibration
