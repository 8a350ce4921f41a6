// Wall, ground and roof surfaces.
#include "scene_noise.hpp"
#include "scene_texture.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::simulator {
namespace {

cv::Scalar varied(const cv::Scalar& colour, double brightness, double hue, cv::RNG& rng) {
    const double factor = 1.0 + rng.uniform(-brightness, brightness);
    const double warm = rng.uniform(-hue, hue);
    return {std::clamp(colour[0] * factor * (1.0 - warm), 0.0, 255.0),
            std::clamp(colour[1] * factor, 0.0, 255.0),
            std::clamp(colour[2] * factor * (1.0 + warm), 0.0, 255.0)};
}

/// Grain of every size from metres to single texels: what image matching lives on.
void weather(Canvas& wall, double blotches, double grain, cv::RNG& rng) {
    shadeBy(wall.image(), GrainPatch(Grain::kBlotches, wall.texelM() / 0.0125, rng), blotches);
    shadeBy(wall.image(), GrainPatch(Grain::kFine, 1.0, rng), grain);
}

/// Courses of blocks in running bond; each block has its own shade.
void layBlocks(Canvas& wall, const cv::Scalar& colour, double length_m, double course_m, double joint_m,
               double spread, cv::RNG& rng) {
    int course = 0;
    for (double bottom = 0.0; bottom < wall.heightM(); bottom += course_m, ++course) {
        const double shift = course % 2 == 0 ? 0.0 : -length_m / 2;
        for (double left = shift; left < wall.widthM(); left += length_m) {
            wall.fill({left + joint_m / 2, bottom + joint_m / 2, length_m - joint_m, course_m - joint_m},
                      varied(colour, spread, spread / 4, rng));
        }
    }
}

/// Dark streaks that rain leaves below an edge, and the wet foot of the wall.
void streak(Canvas& wall, cv::RNG& rng) {
    cv::Mat& image = wall.image();
    const cv::Mat columns =
        noiseField({image.cols, 1}, {.widest_px = 0.5 / wall.texelM(), .octaves = 4}, rng);
    for (int row = 0; row < image.rows; ++row) {
        const double up_m = (image.rows - row) * wall.texelM();
        const double down_m = row * wall.texelM();
        const auto foot = static_cast<float>(1.0 - 0.27 * std::exp(-up_m / 0.5));
        const auto fade = static_cast<float>(0.18 * std::exp(-down_m / 2.5));
        auto* pixel = image.ptr<cv::Vec3b>(row);
        for (int col = 0; col < image.cols; ++col) {
            const float factor = std::max(0.2F, foot - fade * std::max(0.0F, columns.at<float>(0, col)));
            for (int channel = 0; channel < 3; ++channel) {
                pixel[col][channel] = static_cast<uchar>(static_cast<float>(pixel[col][channel]) * factor);
            }
        }
    }
}

/// Patches where the plaster fell off and the bricks show.
void exposeBricks(Canvas& wall, cv::RNG& rng) {
    Canvas bricks(wall.widthM(), wall.heightM(), wall.texelM(), {140, 150, 155});
    layBlocks(bricks, {75, 95, 150}, 0.25, 0.075, 0.012, 0.2, rng);
    const GrainPatch where(Grain::kBlotches, wall.texelM() / 0.0125, rng);
    for (int row = 0; row < std::min(wall.image().rows, bricks.image().rows); ++row) {
        for (int col = 0; col < std::min(wall.image().cols, bricks.image().cols); ++col) {
            if (where.at(row, col) > 2.1) {
                wall.image().at<cv::Vec3b>(row, col) = bricks.image().at<cv::Vec3b>(row, col);
            }
        }
    }
}

void raiseTimber(Canvas& wall, cv::RNG& rng) {
    const cv::Scalar oak(38, 50, 66);
    constexpr double kBeam_m = 0.2;
    const double storey_m = 2.9;
    for (double bottom = 0.1; bottom < wall.heightM(); bottom += storey_m) {
        wall.line({0, bottom}, {wall.widthM(), bottom}, varied(oak, 0.15, 0.05, rng), kBeam_m);
        const double top = std::min(bottom + storey_m, wall.heightM());
        const int posts = std::max(3, cvRound(wall.widthM() / 1.4));
        for (int post = 0; post <= posts; ++post) {
            const double at = wall.widthM() * post / posts;
            wall.line({at, bottom}, {at, top}, varied(oak, 0.15, 0.05, rng), kBeam_m);
        }
        const double bay = wall.widthM() / posts;
        wall.line({0, bottom}, {bay, top}, varied(oak, 0.15, 0.05, rng), kBeam_m * 0.8);
        wall.line({wall.widthM(), bottom}, {wall.widthM() - bay, top}, varied(oak, 0.15, 0.05, rng),
                  kBeam_m * 0.8);
    }
}

}  // namespace

Canvas drawWall(Wall wall, const cv::Scalar& colour, double width_m, double height_m, double texel_m,
                cv::RNG& rng) {
    Canvas canvas(
        width_m, height_m, texel_m,
        wall == Wall::kBrick || wall == Wall::kStone ? colour * 0.75 + cv::Scalar::all(40) : colour);
    if (wall == Wall::kBrick) {
        layBlocks(canvas, colour, 0.25, 0.083, 0.014, 0.22, rng);
    } else if (wall == Wall::kStone) {
        layBlocks(canvas, colour, 0.62, 0.31, 0.02, 0.10, rng);
    } else if (wall == Wall::kPlaster) {
        exposeBricks(canvas, rng);
    } else {
        raiseTimber(canvas, rng);
    }
    weather(canvas, wall == Wall::kPlaster ? 0.07 : 0.05, 0.05, rng);
    streak(canvas, rng);
    return canvas;
}

cv::Mat drawPaving(double width_m, double height_m, double texel_m, cv::RNG& rng) {
    Canvas ground(width_m, height_m, texel_m, {62, 68, 72});
    constexpr double kStone_m = 0.125;
    int row = 0;
    for (double y = 0.0; y < height_m; y += kStone_m, ++row) {
        for (double x = row % 2 == 0 ? 0.0 : -kStone_m / 2; x < width_m; x += kStone_m) {
            ground.fill({x + rng.uniform(0.006, 0.014), y + rng.uniform(0.006, 0.014), kStone_m - 0.022,
                         kStone_m - 0.022},
                        varied({118, 124, 130}, 0.2, 0.03, rng));
        }
    }
    weather(ground, 0.10, 0.06, rng);
    return ground.image();
}

cv::Mat drawRoof(const cv::Scalar& colour, double width_m, double height_m, double texel_m, cv::RNG& rng) {
    Canvas roof(width_m, height_m, texel_m, colour * 0.45);
    layBlocks(roof, colour, 0.22, 0.2, 0.03, 0.2, rng);
    weather(roof, 0.12, 0.05, rng);
    return roof.image();
}

cv::Mat drawBlackBoard(double width_m, double height_m, double texel_m, cv::RNG& rng) {
    Canvas board(width_m, height_m, texel_m, {18, 17, 17});
    weather(board, 0.15, 0.12, rng);
    board.frame({0.03, 0.03, width_m - 0.06, height_m - 0.06}, {70, 80, 88}, 0.06);
    return board.image();
}

cv::Mat drawHedge(double width_m, double height_m, double texel_m, cv::RNG& rng) {
    Canvas hedge(width_m, height_m, texel_m, {52, 86, 68});
    shadeBy(hedge.image(), GrainPatch(Grain::kBlotches, texel_m / 0.006, rng), 0.2);
    shadeBy(hedge.image(), GrainPatch(Grain::kFine, 0.5, rng), 0.35);
    return hedge.image();
}

}  // namespace pmts::simulator
