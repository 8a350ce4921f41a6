#pragma once

#include "pmts/calibration/board.hpp"
#include "pmts/camera/lens.hpp"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace pmts::test {

/// Where a board stands before the camera: p_camera = camera_from_board * p_board + shift_m. The board's origin is its first
/// inner corner, x along its rows, y down.
struct BoardPlace {
    Eigen::Matrix3d camera_from_board = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift_m{0, 0, 0.5};
};

/// Draws boards as a known lens sees them: for each of 4x4 parts of a pixel the lens's own ray is cut with the board, so
/// that no corner is drawn where only our detector would look for it.
class BoardPictures {
public:
    BoardPictures(camera::Lens lens, int width_px, int height_px) : lens_(std::move(lens)), size_(width_px, height_px) {
        // Rays through the corners of the pixels; linear between them is right to 1e-6 of a pixel.
        rays_.create(height_px + 1, width_px + 1, CV_64FC3);
        for (int v = 0; v <= height_px; ++v) {
            for (int u = 0; u <= width_px; ++u) {
                const auto ray = lens_.cameraFromPixel({u - 0.5, v - 0.5});
                rays_.at<cv::Vec3d>(v, u) = ray ? cv::Vec3d(ray->x(), ray->y(), ray->z()) : cv::Vec3d(0, 0, -1);
            }
        }
    }

    [[nodiscard]] cv::Mat draw(const calibration::BoardPattern& pattern, const BoardPlace& place, double noise = 2.0, unsigned seed = 1) const {
        const auto modules = calibration::boardModules(pattern);
        cv::Mat picture(size_, CV_8U);
        const Eigen::Matrix3d board_from_camera = place.camera_from_board.transpose();
        const Eigen::Vector3d eye = -(board_from_camera * place.shift_m);
        for (int v = 0; v < size_.height; ++v) {
            for (int u = 0; u < size_.width; ++u) {
                picture.at<uchar>(v, u) = cv::saturate_cast<uchar>(shade(*modules, pattern, board_from_camera, eye, u, v));
            }
        }
        cv::Mat grain(size_, CV_8S);
        cv::RNG(seed).fill(grain, cv::RNG::NORMAL, 0, noise);
        cv::add(picture, grain, picture, cv::noArray(), CV_8U);
        cv::Mat bgr;
        cv::cvtColor(picture, bgr, cv::COLOR_GRAY2BGR);
        return bgr;
    }

    /// Where the corners truly are, row by row.
    [[nodiscard]] std::vector<Eigen::Vector2d> corners(const calibration::BoardPattern& pattern, const BoardPlace& place) const {
        std::vector<Eigen::Vector2d> pixels;
        for (int row = 0; row < pattern.rows; ++row) {
            for (int column = 0; column < pattern.columns; ++column) {
                const Eigen::Vector3d on_board(column * pattern.square_m, row * pattern.square_m, 0);
                pixels.push_back(lens_.pixelFromCamera(place.camera_from_board * on_board + place.shift_m).value());
            }
        }
        return pixels;
    }

private:
    [[nodiscard]] double shade(const calibration::BoardModules& modules, const calibration::BoardPattern& pattern,
                               const Eigen::Matrix3d& board_from_camera, const Eigen::Vector3d& eye, int u, int v) const {
        constexpr int kParts = 4;
        const auto& a = rays_.at<cv::Vec3d>(v, u);
        const auto& b = rays_.at<cv::Vec3d>(v, u + 1);
        const auto& c = rays_.at<cv::Vec3d>(v + 1, u);
        const auto& d = rays_.at<cv::Vec3d>(v + 1, u + 1);
        double sum = 0.0;
        for (int j = 0; j < kParts; ++j) {
            for (int i = 0; i < kParts; ++i) {
                const double s = (i + 0.5) / kParts;
                const double t = (j + 0.5) / kParts;
                const cv::Vec3d ray = (a * (1 - s) + b * s) * (1 - t) + (c * (1 - s) + d * s) * t;
                sum += shadeAt(modules, pattern, eye, board_from_camera * Eigen::Vector3d(ray[0], ray[1], ray[2]));
            }
        }
        return sum / (kParts * kParts);
    }

    static double shadeAt(const calibration::BoardModules& modules, const calibration::BoardPattern& pattern,
                          const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) {
        constexpr double kWall = 120;
        constexpr double kPaper = 215;
        constexpr double kInk = 35;
        const double along = -eye.z() / ray.z();
        if (!(along > 0)) {
            return kWall;
        }
        const double x = (eye.x() + along * ray.x()) / pattern.square_m + 1;  // squares from the board's outer corner
        const double y = (eye.y() + along * ray.y()) / pattern.square_m + 1;
        const int columns = pattern.columns + 1;
        const int rows = pattern.rows + 1;
        if (x < -0.7 || y < -0.7 || x > columns + 0.7 || y > rows + 0.7) {
            return kWall;
        }
        if (x < 0 || y < 0 || x >= columns || y >= rows) {
            return kPaper;
        }
        const int cell_x = static_cast<int>(x * modules.cells_per_square);
        const int cell_y = static_cast<int>(y * modules.cells_per_square);
        return modules.cells.at<uchar>(cell_y, cell_x) > 127 ? kPaper : kInk;
    }

    camera::Lens lens_;
    cv::Size size_;
    cv::Mat rays_;
};

/// Places that fill the picture of a lens with this focal length: middle, corners and tilts to all sides.
inline std::vector<BoardPlace> boardPlaces(const calibration::BoardPattern& pattern, double f_px, int width_px, int count) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    const double board_m = (pattern.columns + 1) * pattern.square_m;
    const double near_m = f_px / width_px * board_m;  // there the board is as wide as the picture
    std::vector<BoardPlace> places;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * M_PI * i / count;
        const double tilt_x = 0.55 * std::sin(2.0 * turn + 0.3);
        const double tilt_y = 0.55 * std::cos(3.0 * turn);
        const double distance_m = near_m * (1.5 + 0.5 * std::sin(5.0 * turn));
        const double reach = 0.28 * (distance_m / near_m - 0.55);
        BoardPlace place;
        place.camera_from_board = (AngleAxisd(0.15 * std::sin(turn), Vector3d::UnitZ()) * AngleAxisd(tilt_x, Vector3d::UnitX()) *
                                   AngleAxisd(tilt_y, Vector3d::UnitY())).toRotationMatrix();
        const Vector3d middle((pattern.columns - 1) * pattern.square_m / 2, (pattern.rows - 1) * pattern.square_m / 2, 0);
        const double side_x = i % 5 == 0 ? 0.0 : std::cos(turn * 2);
        const double side_y = i % 5 == 0 ? 0.0 : std::sin(turn * 2 + 0.8);
        place.shift_m = Vector3d(reach * board_m * side_x * 1.2, reach * board_m * side_y * 0.7, distance_m) - place.camera_from_board * middle;
        places.push_back(place);
    }
    return places;
}

}  // namespace pmts::test
