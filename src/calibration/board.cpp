#include "pmts/calibration/board.hpp"

#include <Eigen/LU>
#include <QCoreApplication>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::calibration {
namespace {

using core::ErrorKind;

QString text(const char* sentence) { return QCoreApplication::translate("Board", sentence); }

struct NamedDictionary {
    const char* name;
    cv::aruco::PREDEFINED_DICTIONARY_NAME id;
};
constexpr std::array kDictionaries{
    NamedDictionary{"DICT_4X4_50", cv::aruco::DICT_4X4_50},     NamedDictionary{"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    NamedDictionary{"DICT_4X4_250", cv::aruco::DICT_4X4_250},   NamedDictionary{"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    NamedDictionary{"DICT_5X5_100", cv::aruco::DICT_5X5_100},   NamedDictionary{"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    NamedDictionary{"DICT_6X6_50", cv::aruco::DICT_6X6_50},     NamedDictionary{"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    NamedDictionary{"DICT_6X6_250", cv::aruco::DICT_6X6_250},   NamedDictionary{"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    NamedDictionary{"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
};

constexpr int kMargin_cells = 1;  ///< white round a marker
constexpr int kBorder_cells = 1;  ///< black round its bits

cv::Ptr<cv::aruco::Dictionary> dictionaryOf(const BoardPattern& pattern) {
    for (const NamedDictionary& known : kDictionaries) {
        if (pattern.dictionary == QLatin1String(known.name)) {
            return cv::aruco::getPredefinedDictionary(known.id);
        }
    }
    return {};
}

int cellsPerSquare(const cv::aruco::Dictionary& dictionary) { return dictionary.markerSize + 2 * (kBorder_cells + kMargin_cells); }

cv::Ptr<cv::aruco::CharucoBoard> charucoOf(const BoardPattern& pattern) {
    const auto dictionary = dictionaryOf(pattern);
    const double cells = cellsPerSquare(*dictionary);
    const double marker_m = pattern.marker_m > 0 ? pattern.marker_m : pattern.square_m * (cells - 2 * kMargin_cells) / cells;
    return cv::aruco::CharucoBoard::create(pattern.columns + 1, pattern.rows + 1, static_cast<float>(pattern.square_m),
                                           static_cast<float>(marker_m), dictionary);
}

cv::Mat greyOf(const cv::Mat& picture) {
    cv::Mat grey = picture;
    if (picture.channels() == 3) {
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    }
    return grey;
}

core::Result<BoardView> notThere() {
    return core::fail(ErrorKind::kUndefined, text("The board is not in this picture."),
                      text("Show it whole, evenly lit and flat."));
}

/// Shortest distance in the picture between neighbours on the board: the width of a square there.
double squareIn(const BoardView& view, double square_m) {
    double narrowest_px = 1e9;
    for (std::size_t i = 1; i < view.px.size(); ++i) {
        if ((view.board_m[i] - view.board_m[i - 1]).norm() < 1.01 * square_m) {
            narrowest_px = std::min(narrowest_px, (view.px[i] - view.px[i - 1]).norm());
        }
    }
    return narrowest_px;
}

/// Saddle points once more, in a window that sees two edges and nothing else within `share` of a square.
void refine(const cv::Mat& grey, BoardView& view, double square_m, double share) {
    const int half_px = std::clamp(static_cast<int>(squareIn(view, square_m) * share), 2, 11);
    std::vector<cv::Point2f> corners;
    for (const Eigen::Vector2d& px : view.px) {
        corners.emplace_back(static_cast<float>(px.x()), static_cast<float>(px.y()));
    }
    cv::cornerSubPix(grey, corners, {half_px, half_px}, {-1, -1}, {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 60, 1e-3});
    for (std::size_t i = 0; i < corners.size(); ++i) {
        view.px[i] = {corners[i].x, corners[i].y};
    }
}

core::Result<BoardView> findChessboard(const cv::Mat& grey, const BoardPattern& pattern) {
    const cv::Size size(pattern.columns, pattern.rows);
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCorners(grey, size, corners,
                                   cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK)) {
        return notThere();
    }
    BoardView view;
    for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
        const cv::Point2f& at = corners[static_cast<std::size_t>(i)];
        view.px.emplace_back(at.x, at.y);
        view.board_m.emplace_back(pattern.square_m * (i % pattern.columns), pattern.square_m * (i / pattern.columns));
    }
    refine(grey, view, pattern.square_m, 0.35);
    return view;
}

core::Result<BoardView> findCharuco(const cv::Mat& grey, const BoardPattern& pattern) {
    constexpr int kLeastCorners = 6;
    const auto board = charucoOf(pattern);
    std::vector<int> ids;
    std::vector<std::vector<cv::Point2f>> markers;
    cv::aruco::detectMarkers(grey, board->dictionary, markers, ids);
    if (ids.empty()) {
        return notThere();
    }
    std::vector<cv::Point2f> corners;
    std::vector<int> corner_ids;
    cv::aruco::interpolateCornersCharuco(markers, ids, grey, board, corners, corner_ids);
    if (static_cast<int>(corners.size()) < kLeastCorners) {
        return notThere();
    }
    BoardView view;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int id = corner_ids[i];
        view.px.emplace_back(corners[i].x, corners[i].y);
        view.board_m.emplace_back(pattern.square_m * (id % pattern.columns), pattern.square_m * (id / pattern.columns));
    }
    // Between a corner and the nearest marker is a margin of white; OpenCV's own window looks past it.
    refine(grey, view, pattern.square_m, 0.9 * (1 - board->getMarkerLength() / board->getSquareLength()) / 2);
    return view;
}

cv::Rect2d boundsOf(const BoardView& view) {
    Eigen::Vector2d least = view.px.front();
    Eigen::Vector2d most = view.px.front();
    for (const Eigen::Vector2d& px : view.px) {
        least = least.cwiseMin(px);
        most = most.cwiseMax(px);
    }
    return {least.x(), least.y(), most.x() - least.x(), most.y() - least.y()};
}

/// Steepest slope beside each corner over the contrast there, median: 0.5 for a step between two pixels, less when blurred.
double sharpnessAt(const cv::Mat& grey, const BoardView& view) {
    constexpr int kHalf_px = 5;
    std::vector<double> slopes;
    cv::Mat across;
    cv::Mat down;
    for (const Eigen::Vector2d& px : view.px) {
        const cv::Rect around = cv::Rect(cvRound(px.x()) - kHalf_px, cvRound(px.y()) - kHalf_px, 2 * kHalf_px + 1, 2 * kHalf_px + 1) &
                                cv::Rect({0, 0}, grey.size());
        if (around.width < kHalf_px || around.height < kHalf_px) {
            continue;
        }
        double dark = 0;
        double light = 0;
        cv::minMaxLoc(grey(around), &dark, &light);
        cv::Sobel(grey(around), across, CV_32F, 1, 0, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
        cv::Sobel(grey(around), down, CV_32F, 0, 1, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
        cv::Mat steepness;
        cv::magnitude(across, down, steepness);
        double steepest = 0;
        cv::minMaxLoc(steepness, nullptr, &steepest);
        slopes.push_back(light > dark ? steepest / (light - dark) : 0.0);
    }
    if (slopes.empty()) {
        return 0.0;
    }
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

core::Result<BoardView> judged(BoardView view) {
    constexpr double kLeastShare = 0.02;
    constexpr double kLeastSharpness = 0.12;  // an edge smeared over 8 px
    const cv::Rect2d bounds = boundsOf(view);
    if (bounds.area() < kLeastShare * view.width_px * view.height_px) {
        return core::fail(ErrorKind::kUndefined, text("The board covers only %1 % of this picture.")
                              .arg(100 * bounds.area() / (view.width_px * view.height_px), 0, 'f', 1),
                          text("Bring it nearer."));
    }
    if (view.sharpness < kLeastSharpness) {
        return core::fail(ErrorKind::kUndefined, text("The board is blurred in this picture."),
                          text("Hold it still, and check the focus."));
    }
    return view;
}

}  // namespace

QStringList boardDictionaries() {
    QStringList names;
    for (const NamedDictionary& known : kDictionaries) {
        names.append(QLatin1String(known.name));
    }
    return names;
}

core::Result<void> usablePattern(const BoardPattern& pattern) {
    constexpr int kFewest = 3;
    constexpr int kMost = 60;
    const auto bad = [](const QString& happened, const QString& remedy) { return core::fail(ErrorKind::kBadInput, happened, remedy); };
    if (std::min(pattern.columns, pattern.rows) < kFewest || std::max(pattern.columns, pattern.rows) > kMost || !(pattern.square_m > 0)) {
        return bad(text("A board has 3x3 to 60x60 inner corners and squares of some size."), text("Count the inner corners, e.g. 9x6."));
    }
    if (!pattern.isCharuco()) {
        if (pattern.columns == pattern.rows) {
            return bad(text("A square chessboard looks the same from four sides."), text("Use one with more corners across than down."));
        }
        return {};
    }
    const auto dictionary = dictionaryOf(pattern);
    if (!dictionary) {
        return bad(text("The marker dictionary “%1” is not known.").arg(pattern.dictionary),
                   text("Known: %1.").arg(boardDictionaries().join(QStringLiteral(", "))));
    }
    const int markers = (pattern.columns + 1) * (pattern.rows + 1) / 2;
    if (markers > dictionary->bytesList.rows) {
        return bad(text("%1 has too few markers for this board: %2 are needed.").arg(pattern.dictionary).arg(markers),
                   text("Choose a larger dictionary or fewer squares."));
    }
    if (pattern.marker_m < 0 || pattern.marker_m >= pattern.square_m) {
        return bad(text("A marker is smaller than its square."), text("Measure both again."));
    }
    return {};
}

core::Result<BoardModules> boardModules(const BoardPattern& pattern) {
    PMTS_TRY(usablePattern(pattern));
    if (!pattern.isCharuco()) {
        cv::Mat cells(pattern.rows + 1, pattern.columns + 1, CV_8U);
        for (int row = 0; row < cells.rows; ++row) {
            for (int column = 0; column < cells.cols; ++column) {
                cells.at<uchar>(row, column) = (row + column) % 2 == 0 ? 0 : 255;
            }
        }
        return BoardModules{.cells = cells, .cells_per_square = 1};
    }
    const int per_square = cellsPerSquare(*dictionaryOf(pattern));
    const cv::Size size((pattern.columns + 1) * per_square, (pattern.rows + 1) * per_square);
    BoardPattern exact = pattern;
    exact.marker_m = 0;  // whole cells
    cv::Mat cells;
    charucoOf(exact)->draw(size, cells, 0, kBorder_cells);
    cv::threshold(cells, cells, 127, 255, cv::THRESH_BINARY);
    return BoardModules{.cells = cells, .cells_per_square = per_square};
}

core::Result<BoardView> findBoard(const cv::Mat& picture, const BoardPattern& pattern, const QString& name) {
    PMTS_TRY(usablePattern(pattern));
    if (picture.empty() || picture.depth() != CV_8U) {
        return core::fail(ErrorKind::kBadInput, text("This is no picture that can be searched."), text("Use 8-bit pictures."));
    }
    try {
        const cv::Mat grey = greyOf(picture);
        auto view = pattern.isCharuco() ? findCharuco(grey, pattern) : findChessboard(grey, pattern);
        PMTS_TRY(view);
        view->name = name;
        view->width_px = grey.cols;
        view->height_px = grey.rows;
        view->sharpness = sharpnessAt(grey, *view);
        return judged(*std::move(view));
    } catch (const cv::Exception& trouble) {
        return core::fail(ErrorKind::kUndefined, text("The board is not in this picture."), text("Show it whole, evenly lit and flat."),
                          QString::fromStdString(trouble.err));
    }
}

bool isNewView(const BoardView& view, const std::vector<BoardView>& others) {
    constexpr double kMoved = 0.12;  // of the picture's width
    const auto shape = [](const BoardView& of) {
        const cv::Rect2d bounds = boundsOf(of);
        // Where it is, how large, and how it leans: the places of the first and last corner within the bounds.
        Eigen::Matrix<double, 8, 1> numbers;
        numbers << bounds.x, bounds.y, bounds.x + bounds.width, bounds.y + bounds.height, of.px.front(), of.px.back();
        return Eigen::Matrix<double, 8, 1>(numbers / of.width_px);
    };
    return std::none_of(others.begin(), others.end(), [&](const BoardView& other) {
        return (shape(view) - shape(other)).lpNorm<Eigen::Infinity>() < kMoved;
    });
}

}  // namespace pmts::calibration
