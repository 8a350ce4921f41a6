// House fronts: openings, trim and signs on a wall.
#include "scene_noise.hpp"
#include "scene_texture.hpp"

#include <algorithm>

namespace pmts::simulator {
namespace {

const cv::Scalar kIron(46, 48, 50);

/// Glass: dark room below, sky reflected above, and a curtain now and then.
void glaze(Canvas& wall, const Patch_m& pane, cv::RNG& rng) {
    constexpr int kBands = 8;
    const double sky = rng.uniform(0.2, 0.8);
    for (int band = 0; band < kBands; ++band) {
        const double share = sky * band / kBands;
        const cv::Scalar colour = cv::Scalar(58, 52, 46) * (1.0 - share) + cv::Scalar(200, 178, 160) * share;
        wall.fill({pane.left, pane.bottom + pane.height * band / kBands, pane.width, pane.height / kBands},
                  colour);
    }
    if (rng.uniform(0, 3) == 0) {
        const double drawn = pane.width * rng.uniform(0.15, 0.4);
        wall.fill({pane.left, pane.bottom, drawn, pane.height}, {178, 190, 200});
        wall.fill({pane.right() - drawn, pane.bottom, drawn, pane.height}, {170, 184, 196});
    }
}

void glazingBars(Canvas& wall, const Patch_m& pane, int columns, int rows, const cv::Scalar& colour) {
    for (int column = 1; column < columns; ++column) {
        const double x = pane.left + pane.width * column / columns;
        wall.line({x, pane.bottom}, {x, pane.top()}, colour, 0.045);
    }
    for (int row = 1; row < rows; ++row) {
        const double y = pane.bottom + pane.height * row / rows;
        wall.line({pane.left, y}, {pane.right(), y}, colour, 0.04);
    }
}

void louvres(Canvas& wall, const Patch_m& leaf, const cv::Scalar& colour) {
    wall.fill(leaf, colour);
    for (double y = leaf.bottom + 0.08; y < leaf.top() - 0.05; y += 0.06) {
        wall.line({leaf.left + 0.05, y}, {leaf.right() - 0.05, y}, colour * 0.65, 0.02);
    }
    wall.frame(leaf.shrunk(0.02), colour * 0.8, 0.03);
}

void window(Canvas& wall, const Patch_m& opening, const Facade& style, cv::RNG& rng) {
    wall.fill(opening.shrunk(-0.10), style.trim);
    wall.frame(opening.shrunk(-0.10), style.trim * 0.72, 0.02);
    wall.fill(opening, cv::Scalar(60, 62, 64));  // the reveal in shadow
    const Patch_m pane = {opening.left + 0.05, opening.bottom + 0.03, opening.width - 0.10,
                          opening.height - 0.13};
    glaze(wall, pane, rng);
    glazingBars(wall, pane, 2, 3, style.trim * 0.95);
    wall.frame(pane, style.trim * 0.95, 0.05);
    wall.fill({opening.left - 0.16, opening.bottom - 0.14, opening.width + 0.32, 0.1},
              style.trim * 1.05);  // sill
    wall.fill({opening.left - 0.16, opening.bottom - 0.19, opening.width + 0.32, 0.05}, style.trim * 0.45);
    if (style.shutters) {
        const double leaf = opening.width / 2;
        louvres(wall, {opening.left - leaf - 0.03, opening.bottom, leaf, opening.height}, style.shutter);
        louvres(wall, {opening.right() + 0.03, opening.bottom, leaf, opening.height}, style.shutter);
    }
}

void door(Canvas& wall, const Patch_m& opening, const Facade& style, cv::RNG& rng) {
    wall.fill(opening.shrunk(-0.16), style.trim * 0.9);
    wall.fill(opening, style.shutter * 0.9);
    const Patch_m light = {opening.left + 0.08, opening.top() - 0.5, opening.width - 0.16, 0.4};
    glaze(wall, light, rng);
    glazingBars(wall, light, 4, 1, style.shutter);
    for (const double side : {0.0, 0.5}) {
        const double left = opening.left + side * opening.width;
        wall.frame({left + 0.09, opening.bottom + 0.15, opening.width / 2 - 0.18, 0.6}, style.shutter * 0.55,
                   0.03);
        wall.frame({left + 0.09, opening.bottom + 0.9, opening.width / 2 - 0.18, opening.height - 1.6},
                   style.shutter * 0.55, 0.03);
    }
    wall.line({opening.left + opening.width / 2, opening.bottom},
              {opening.left + opening.width / 2, opening.top() - 0.55}, style.shutter * 0.5, 0.03);
    wall.disc({opening.left + opening.width / 2 + 0.09, opening.bottom + 1.05}, 0.04, {90, 170, 200});
    if (!style.number.empty()) {
        const Patch_m plate = {opening.right() + 0.28, opening.bottom + 1.6, 0.34, 0.26};
        wall.fill(plate, {120, 60, 30});
        wall.write(style.number, plate.shrunk(0.05), {240, 240, 240});
    }
}

void archway(Canvas& wall, const Patch_m& opening, const Facade& style, cv::RNG& rng) {
    const cv::Point2d spring(opening.left + opening.width / 2, opening.top() - opening.width / 2);
    wall.arch(spring, opening.width / 2 + 0.2, style.trim * 0.92);
    wall.fill({opening.left - 0.2, opening.bottom, opening.width + 0.4, spring.y - opening.bottom},
              style.trim * 0.92);
    wall.arch(spring, opening.width / 2, cv::Scalar(52, 54, 58));
    const Patch_m pane = {opening.left, opening.bottom, opening.width, spring.y - opening.bottom};
    glaze(wall, pane, rng);
    glazingBars(wall, pane, 3, 2, kIron);
    wall.fill({opening.left + opening.width / 2 - 0.12, opening.top() - 0.05, 0.24, 0.4},
              style.trim * 1.05);  // keystone
}

void shopWindow(Canvas& wall, const Patch_m& opening, const Facade& style, cv::RNG& rng) {
    wall.fill(opening.shrunk(-0.12), style.shutter * 0.8);
    glaze(wall, opening, rng);
    for (int item = 0; item < 9; ++item) {  // goods on display
        const double width = rng.uniform(0.08, 0.22);
        const cv::Scalar colour(rng.uniform(40, 220), rng.uniform(40, 220), rng.uniform(60, 240));
        wall.fill({opening.left + rng.uniform(0.05, opening.width - 0.3),
                   opening.bottom + 0.04 + rng.uniform(0, 2) * 0.45, width, rng.uniform(0.12, 0.34)},
                  colour);
    }
    glazingBars(wall, opening, 3, 1, style.shutter * 0.7);
}

void groundFloor(Canvas& wall, const Facade& style, double height_m, cv::RNG& rng) {
    const double bay = wall.widthM() / style.bays;
    const int door_bay = rng.uniform(0, style.bays);
    for (int i = 0; i < style.bays; ++i) {
        const double left = bay * i;
        if (i == door_bay) {
            door(wall, {left + bay / 2 - 0.65, 0.0, 1.3, std::min(2.75, height_m - 0.5)}, style, rng);
        } else if (style.arched) {
            archway(wall, {left + 0.45, 0.0, bay - 0.9, std::min(2.3 + bay / 4, height_m - 0.55)}, style,
                    rng);
        } else {
            shopWindow(wall, {left + 0.3, 0.65, bay - 0.6, std::min(1.9, height_m - 1.4)}, style, rng);
        }
    }
}

void signBoard(Canvas& wall, const Facade& style, double bottom_m) {
    const double width = std::min(wall.widthM() * 0.8, 0.42 * static_cast<double>(style.sign.size()) + 0.8);
    const Patch_m board = {(wall.widthM() - width) / 2, bottom_m, width, 0.52};
    wall.fill({board.left + 0.03, board.bottom - 0.05, board.width, board.height}, {40, 40, 40});
    wall.fill(board, style.shutter * 0.7);
    wall.frame(board.shrunk(0.05), {110, 190, 215}, 0.025);
    wall.write(style.sign, board.shrunk(0.12), {165, 225, 240});
}

void upperFloors(Canvas& wall, const Facade& style, double ground_m, double storey_m, cv::RNG& rng) {
    const double bay = wall.widthM() / style.bays;
    for (int floor = 1; floor < style.storeys; ++floor) {
        const double sill = ground_m + storey_m * (floor - 1) + 0.85;
        const double height = std::min(1.7, storey_m - 1.15);
        const double width = std::min(style.shutters ? bay * 0.4 : bay * 0.52, 1.15);
        for (int i = 0; i < style.bays; ++i) {
            window(wall, {bay * (i + 0.5) - width / 2, sill, width, height}, style, rng);
        }
    }
}

void cornices(Canvas& wall, const Facade& style, double ground_m) {
    for (const double bottom : {ground_m - 0.02, wall.heightM() - 0.42}) {
        wall.fill({0, bottom - 0.08, wall.widthM(), 0.08}, style.trim * 0.42);
        wall.fill({0, bottom, wall.widthM(), 0.22}, style.trim);
        wall.fill({0, bottom + 0.15, wall.widthM(), 0.03}, style.trim * 0.7);
    }
    for (double left = 0.1; left < wall.widthM(); left += 0.5) {
        wall.fill({left, wall.heightM() - 0.2, 0.22, 0.2}, style.trim * 0.8);
    }
}

/// Light and a last grain over everything, so that no glass, door or sign is a flat colour.
cv::Mat finished(Canvas& wall, double light, cv::RNG& rng) {
    shadeBy(wall.image(), GrainPatch(Grain::kFine, 0.7, rng), 0.035, light);
    return wall.image();
}

}  // namespace

cv::Mat drawFacade(const Facade& facade, double width_m, double height_m, double texel_m, cv::RNG& rng) {
    Canvas wall = drawWall(facade.wall, facade.colour, width_m, height_m, texel_m, rng);
    const double ground_m = std::min(4.0, height_m / std::max(1, facade.storeys) + 0.5);
    const double storey_m =
        facade.storeys > 1 ? (height_m - ground_m - 0.4) / (facade.storeys - 1) : height_m;
    groundFloor(wall, facade, ground_m, rng);
    upperFloors(wall, facade, ground_m, storey_m, rng);
    cornices(wall, facade, ground_m);
    if (!facade.sign.empty()) {
        signBoard(wall, facade, ground_m - 0.62);
    }
    return finished(wall, facade.light, rng);
}

cv::Mat drawTower(double width_m, double height_m, double texel_m, double light, cv::RNG& rng) {
    Canvas wall = drawWall(Wall::kStone, {138, 156, 168}, width_m, height_m, texel_m, rng);
    const double middle = width_m / 2;
    const double face = std::min(width_m * 0.3, 1.7);
    const cv::Point2d clock(middle, height_m - 9.0);
    wall.disc(clock, face + 0.2, {60, 120, 150});
    wall.disc(clock, face, {225, 232, 235});
    for (int hour = 0; hour < 12; ++hour) {
        const cv::Point2d spoke(std::sin(hour * CV_PI / 6), std::cos(hour * CV_PI / 6));
        wall.line(clock + spoke * (face * 0.8), clock + spoke * (face * 0.95), kIron, 0.12);
    }
    wall.line(clock, clock + cv::Point2d(-0.45, 0.3) * face, kIron, 0.16);
    wall.line(clock, clock + cv::Point2d(0.35, 0.75) * face, kIron, 0.1);
    for (const double side : {-0.22, 0.22}) {  // belfry openings
        const double x = middle + side * width_m;
        wall.fill({x - 0.5, height_m - 5.6, 1.0, 2.6}, {40, 42, 46});
        wall.arch({x, height_m - 3.0}, 0.5, {40, 42, 46});
    }
    for (const double course : {height_m - 6.4, height_m - 12.0, height_m - 1.0}) {
        wall.fill({0, course, width_m, 0.35}, {165, 180, 190});
        wall.fill({0, course - 0.1, width_m, 0.1}, {70, 80, 86});
    }
    return finished(wall, light, rng);
}

cv::Mat drawPosters(double width_m, double height_m, double texel_m, double light, cv::RNG& rng) {
    static const char* const kBills[] = {"CIRCUS",    "MARKET",  "JAZZ",  "OPERA",
                                         "BOOK FAIR", "THEATRE", "CHESS", "CYCLE"};
    Canvas board = drawWall(Wall::kPlaster, {150, 165, 160}, width_m, height_m, texel_m, rng);
    int bill = rng.uniform(0, 8);
    for (double bottom = 0.35; bottom < height_m - 0.8; bottom += 0.95) {
        for (double left = 0.06; left < width_m - 0.6; left += 0.68, ++bill) {
            const Patch_m paper = {left + rng.uniform(0.0, 0.04), bottom + rng.uniform(0.0, 0.08), 0.6, 0.82};
            const cv::Scalar colour(rng.uniform(60, 230), rng.uniform(90, 230), rng.uniform(120, 250));
            board.fill(paper, colour);
            board.write(kBills[bill % 8], {paper.left + 0.05, paper.top() - 0.25, 0.5, 0.18}, colour * 0.25);
            board.disc({paper.left + 0.3, paper.bottom + 0.32}, rng.uniform(0.1, 0.2), colour * 0.55);
            for (int row = 0; row < 3; ++row) {
                board.line({paper.left + 0.08, paper.bottom + 0.06 + row * 0.035},
                           {paper.left + 0.5, paper.bottom + 0.06 + row * 0.035}, colour * 0.3, 0.01);
            }
        }
    }
    return finished(board, light, rng);
}

}  // namespace pmts::simulator
