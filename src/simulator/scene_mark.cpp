#include "scene_texture.hpp"

#include <algorithm>

namespace pmts::simulator {

cv::Mat drawQuadrants(int size_px) {
    const int half = size_px / 2;
    cv::Mat board(2 * half, 2 * half, CV_8UC3, cv::Scalar::all(18));
    board(cv::Rect(0, 0, half, half)).setTo(cv::Scalar::all(240));
    board(cv::Rect(half, half, half, half)).setTo(cv::Scalar::all(240));
    return board;
}

cv::Mat drawPlumbLine(double width_m, double height_m, double texel_m) {
    constexpr double kCord_m = 0.006, kBob_m = 0.05, kBobAt_m = 0.25;
    Canvas board(width_m, height_m, texel_m, cv::Scalar(226, 230, 232));
    const double middle_m = board.widthM() / 2;
    board.fill({middle_m - kCord_m / 2, kBobAt_m, kCord_m, board.heightM() - kBobAt_m}, {38, 40, 44});
    board.disc({middle_m, kBobAt_m}, kBob_m, {52, 96, 128});
    board.fill({middle_m - kBob_m / 4, kBobAt_m + kBob_m / 2, kBob_m / 2, kBob_m}, {44, 70, 96});
    return board.image();
}

cv::Mat drawChessboard(int columns, int rows, double width_m, double height_m, double texel_m) {
    Canvas board(width_m, height_m, texel_m, {232, 236, 236});
    const double square_m = std::min(board.widthM() / (columns + 2), board.heightM() / (rows + 2));
    const double left_m = (board.widthM() - square_m * (columns + 1)) / 2;
    const double bottom_m = (board.heightM() - square_m * (rows + 1)) / 2;
    for (int row = 0; row <= rows; ++row) {
        for (int column = row % 2; column <= columns; column += 2) {
            board.fill({left_m + column * square_m, bottom_m + row * square_m, square_m, square_m}, {28, 28, 28});
        }
    }
    return board.image();
}

cv::Mat drawPrism(int size_px) {
    constexpr int kShift = 4;
    const cv::Scalar housing(40, 190, 235);
    cv::Mat prism(size_px, size_px, CV_8UC3, cv::Scalar(30, 32, 34));
    const int centre = cvRound((size_px / 2.0 - 0.5) * (1 << kShift));
    const auto ring = [&](double radius, const cv::Scalar& colour) {
        cv::circle(prism, {centre, centre}, cvRound(radius * size_px * (1 << kShift)), colour, cv::FILLED,
                   cv::LINE_AA, kShift);
    };
    ring(0.48, housing);
    ring(0.34, {25, 25, 25});
    ring(0.31, {205, 170, 140});
    for (int edge = 0; edge < 6; ++edge) {  // the corner cube's edges and their images
        const cv::Point2d along(std::cos(edge * CV_PI / 3), std::sin(edge * CV_PI / 3));
        const cv::Point2d end = cv::Point2d(centre, centre) + along * (0.31 * size_px * (1 << kShift));
        cv::line(prism, {centre, centre}, end, {95, 75, 60}, 1, cv::LINE_AA, kShift);
    }
    return prism;
}

}  // namespace pmts::simulator
