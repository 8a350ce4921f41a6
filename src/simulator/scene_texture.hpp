#pragma once

#include "scene_canvas.hpp"

#include <opencv2/core.hpp>

#include <string>

namespace pmts::simulator {

enum class Wall { kPlaster, kBrick, kStone, kTimber };

/// The front of a house.
struct Facade {
    Wall wall = Wall::kPlaster;
    cv::Scalar colour{170, 190, 205};  ///< BGR
    cv::Scalar trim{215, 225, 230};    ///< window surrounds, cornice
    cv::Scalar shutter{70, 90, 60};    ///< shutters and door
    int storeys = 3;
    int bays = 4;
    bool shutters = false;
    bool arched = false;   ///< ground floor with arches
    std::string sign{};    ///< above the ground floor; empty: none
    std::string number{};  ///< house number at the door
    double light = 1.0;    ///< 1 in the sun, 0.7 in the shade
};

[[nodiscard]] Canvas drawWall(Wall wall, const cv::Scalar& colour, double width_m, double height_m,
                              double texel_m, cv::RNG& rng);
[[nodiscard]] cv::Mat drawFacade(const Facade& facade, double width_m, double height_m, double texel_m,
                                 cv::RNG& rng);
[[nodiscard]] cv::Mat drawPaving(double width_m, double height_m, double texel_m, cv::RNG& rng);
[[nodiscard]] cv::Mat drawRoof(const cv::Scalar& colour, double width_m, double height_m, double texel_m,
                               cv::RNG& rng);
[[nodiscard]] cv::Mat drawTower(double width_m, double height_m, double texel_m, double light, cv::RNG& rng);
[[nodiscard]] cv::Mat drawBlackBoard(double width_m, double height_m, double texel_m, cv::RNG& rng);
/// Dark green foliage with light on top, for hedges.
[[nodiscard]] cv::Mat drawHedge(double width_m, double height_m, double texel_m, cv::RNG& rng);
/// Poster column or board with coloured bills.
[[nodiscard]] cv::Mat drawPosters(double width_m, double height_m, double texel_m, double light,
                                  cv::RNG& rng);

/// A white board with a dark cord of 6 mm hanging exactly before its middle, a bob at its end.
[[nodiscard]] cv::Mat drawPlumbLine(double width_m, double height_m, double texel_m);

/// A chessboard of this many inner corners across and down on white paper, its margin as wide as half a square.
[[nodiscard]] cv::Mat drawChessboard(int columns, int rows, double width_m, double height_m, double texel_m);

/// Black and white quadrants meeting exactly in the middle of the image; white at the top left.
[[nodiscard]] cv::Mat drawQuadrants(int size_px);
/// A round prism in its yellow housing, its centre exactly in the middle of the image.
[[nodiscard]] cv::Mat drawPrism(int size_px);

}  // namespace pmts::simulator
