// The built-in world: an old town square around the instrument, ground 1.6 m below it.
#include "pmts/simulator/scene.hpp"
#include "scene_texture.hpp"

#include <Eigen/Geometry>

#include <map>

namespace pmts::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kGround_m = -1.6;
constexpr double kSunny = 1.04, kHalf = 0.9, kShade = 0.74;

struct House {
    const char* name;
    double left_m[2];   ///< east, north of the left lower corner, seen from the square
    double right_m[2];  ///< of the right one
    double height_m;
    double texel_m;
    bool gable = false;  ///< a stepped gable instead of a roof
    Facade front;
};

/// The square's houses, clockwise from the north-west corner.
std::vector<House> houses() {
    const cv::Scalar white(222, 230, 233), sand(150, 184, 208), grey(170, 176, 178), green(70, 88, 52),
        red(48, 52, 128), blue(120, 84, 50), brown(40, 58, 84);
    return {
        {"bakery",
         {-27.5, 19.0},
         {-16.6, 21.2},
         10.6,
         0.0125,
         false,
         {.wall = Wall::kPlaster,
          .colour = {118, 178, 214},
          .trim = white,
          .shutter = green,
          .storeys = 3,
          .bays = 4,
          .shutters = true,
          .sign = "BAKERY",
          .number = "12",
          .light = kSunny}},
        {"inn",
         {-16.6, 21.2},
         {-6.2, 22.6},
         11.6,
         0.0125,
         false,
         {.wall = Wall::kTimber,
          .colour = {196, 214, 222},
          .trim = {70, 92, 112},
          .shutter = red,
          .storeys = 4,
          .bays = 4,
          .shutters = false,
          .sign = "THE GOLDEN PLUMB",
          .number = "13",
          .light = kSunny}},
        {"town hall",
         {-6.2, 23.6},
         {8.2, 24.0},
         13.2,
         0.0125,
         true,
         {.wall = Wall::kStone,
          .colour = {142, 170, 188},
          .trim = {186, 204, 214},
          .shutter = brown,
          .storeys = 3,
          .bays = 5,
          .arched = true,
          .sign = "TOWN HALL",
          .number = "1",
          .light = kSunny}},
        {"bookshop",
         {8.2, 22.6},
         {17.4, 21.6},
         11.0,
         0.0125,
         true,
         {.wall = Wall::kBrick,
          .colour = {72, 92, 158},
          .trim = white,
          .shutter = blue,
          .storeys = 3,
          .bays = 3,
          .sign = "BOOKS",
          .number = "2",
          .light = kSunny}},
        {"pharmacy",
         {21.6, 20.6},
         {30.6, 15.4},
         10.2,
         0.0125,
         false,
         {.wall = Wall::kPlaster,
          .colour = {168, 178, 218},
          .trim = white,
          .shutter = {92, 108, 96},
          .storeys = 3,
          .bays = 4,
          .shutters = true,
          .sign = "PHARMACY",
          .number = "3",
          .light = kHalf}},
        {"corner house",
         {39.0, 44.0},
         {51.0, 33.0},
         12.5,
         0.03,
         false,
         {.wall = Wall::kBrick,
          .colour = {96, 112, 150},
          .trim = sand,
          .shutter = green,
          .storeys = 4,
          .bays = 5,
          .number = "7",
          .light = kHalf}},
        {"post office",
         {34.0, 12.0},
         {34.4, -3.0},
         12.0,
         0.0225,
         false,
         {.wall = Wall::kBrick,
          .colour = {88, 120, 176},
          .trim = sand,
          .shutter = brown,
          .storeys = 3,
          .bays = 6,
          .arched = true,
          .sign = "POST",
          .number = "4",
          .light = kShade}},
        {"clockmaker",
         {34.4, -3.0},
         {32.0, -15.0},
         10.4,
         0.0225,
         false,
         {.wall = Wall::kTimber,
          .colour = {168, 196, 216},
          .trim = {64, 84, 104},
          .shutter = green,
          .storeys = 3,
          .bays = 4,
          .sign = "CLOCKS",
          .number = "5",
          .light = kShade}},
        {"school",
         {26.0, -30.0},
         {9.0, -34.0},
         11.2,
         0.0225,
         false,
         {.wall = Wall::kPlaster,
          .colour = {160, 190, 200},
          .trim = white,
          .shutter = red,
          .storeys = 3,
          .bays = 7,
          .number = "6",
          .light = kShade}},
        {"brewery",
         {9.0, -34.0},
         {-6.0, -35.0},
         13.0,
         0.0225,
         true,
         {.wall = Wall::kBrick,
          .colour = {80, 92, 140},
          .trim = sand,
          .shutter = brown,
          .storeys = 4,
          .bays = 5,
          .arched = true,
          .sign = "BREWERY",
          .number = "8",
          .light = kShade}},
        {"library",
         {-6.0, -35.0},
         {-22.0, -31.0},
         10.8,
         0.0225,
         false,
         {.wall = Wall::kStone,
          .colour = {150, 170, 180},
          .trim = grey,
          .shutter = blue,
          .storeys = 3,
          .bays = 6,
          .sign = "LIBRARY",
          .number = "9",
          .light = kShade}},
        {"saddler",
         {-29.0, -16.0},
         {-31.0, -2.0},
         10.0,
         0.0225,
         false,
         {.wall = Wall::kPlaster,
          .colour = {150, 206, 226},
          .trim = white,
          .shutter = brown,
          .storeys = 3,
          .bays = 5,
          .shutters = true,
          .sign = "SADDLER",
          .number = "10",
          .light = kSunny}},
        {"weigh house",
         {-31.0, -2.0},
         {-29.6, 13.0},
         12.2,
         0.0225,
         true,
         {.wall = Wall::kBrick,
          .colour = {70, 84, 136},
          .trim = white,
          .shutter = green,
          .storeys = 3,
          .bays = 5,
          .arched = true,
          .sign = "WEIGH HOUSE",
          .number = "11",
          .light = kSunny}},
    };
}

/// Collects the panels and marks of the square.
class SquareBuilder {
public:
    explicit SquareBuilder(unsigned seed) : rng_(seed * 7919ULL + 11ULL) {}

    void build() {
        ground();
        for (const House& house : houses()) {
            raise(house);
        }
        church();
        furniture();
        targets();
    }

    std::vector<Panel> panels;
    std::vector<Mark> marks;

private:
    void add(const char* name, const Vector3d& origin, const Vector3d& right, const Vector3d& up,
             cv::Mat texture, bool absorbing = false) {
        panels.push_back({QString::fromLatin1(name), origin, right, up, std::move(texture), absorbing});
    }

    void ground() {
        constexpr double kTile_m = 12.0;
        constexpr int kReach = 4;
        std::vector<cv::Mat> tiles;
        for (int i = 0; i < 3; ++i) {
            tiles.push_back(drawPaving(kTile_m, kTile_m, 0.0175, rng_));
        }
        for (int east = -kReach; east <= kReach; ++east) {
            for (int north = -kReach; north <= kReach; ++north) {
                const Vector3d corner((east - 0.5) * kTile_m, (north - 0.5) * kTile_m, kGround_m);
                add("paving", corner, {kTile_m, 0, 0}, {0, kTile_m, 0},
                    tiles[static_cast<std::size_t>(rng_.uniform(0, 3))]);
            }
        }
    }

    void raise(const House& house) {
        const Vector3d origin(house.left_m[0], house.left_m[1], kGround_m);
        const Vector3d right(house.right_m[0] - house.left_m[0], house.right_m[1] - house.left_m[1], 0.0);
        const Vector3d up(0, 0, house.height_m);
        add(house.name, origin, right, up,
            drawFacade(house.front, right.norm(), house.height_m, house.texel_m, rng_));
        fronts_[house.name] = {origin, right};
        const Vector3d back = Vector3d::UnitZ().cross(right).normalized();
        const cv::Scalar side_colour = house.front.colour * 0.8;
        const cv::Mat side = drawWall(Wall::kBrick, side_colour, 9.0, house.height_m, 0.05, rng_).image();
        add(house.name, origin + 9.0 * back, -9.0 * back, up, side);
        add(house.name, origin + right, 9.0 * back, up, side);
        const cv::Mat tiles = drawRoof({62, 78, 142}, right.norm(), 5.6, house.texel_m * 1.6, rng_);
        add(house.name, origin + up, right, 4.5 * back + Vector3d(0, 0, 3.4), tiles);
        gableEnds(origin + up, right, back, side);
        if (house.gable) {
            gable(house, origin + up, right, back);
        }
    }

    /// The triangles under a roof's ends, in steps; the ridge is 4.5 m behind the front.
    void gableEnds(const Vector3d& origin, const Vector3d& right, const Vector3d& back, const cv::Mat& side) {
        constexpr int kSteps = 6;
        for (int step = 0; step < kSteps; ++step) {
            const double half_m = 4.5 * (1.0 - (step + 0.5) / kSteps);
            const Vector3d low = (4.5 - half_m) * back + Vector3d(0, 0, 3.4 * step / kSteps);
            const Vector3d up(0, 0, 3.4 / kSteps);
            const cv::Mat strip =
                side.rowRange(side.rows * step / (2 * kSteps), side.rows * (step + 1) / (2 * kSteps));
            add("gable", origin + low + 2.0 * half_m * back, -2.0 * half_m * back, up, strip);
            add("gable", origin + right + low, 2.0 * half_m * back, up, strip);
        }
    }

    void gable(const House& house, const Vector3d& origin, const Vector3d& right, const Vector3d& back) {
        constexpr int kSteps = 5;
        constexpr double kRise_m = 0.95;
        for (int step = 0; step < kSteps; ++step) {
            const double margin = 0.07 + 0.085 * step;
            const double width = right.norm() * (1.0 - 2.0 * margin);
            Canvas wall =
                drawWall(house.front.wall, house.front.colour, width, kRise_m, house.texel_m * 1.5, rng_);
            wall.fill({0, kRise_m - 0.14, width, 0.14}, house.front.trim);
            wall.fill({0, kRise_m - 0.19, width, 0.05}, house.front.trim * 0.45);
            if (step == 1) {
                wall.fill({width / 2 - 0.3, 0.1, 0.6, 0.6}, {52, 56, 60});
            }
            add(house.name, origin + margin * right - 0.02 * back + Vector3d(0, 0, step * kRise_m),
                right * (1.0 - 2.0 * margin), {0, 0, kRise_m}, wall.image() * house.front.light);
        }
    }

    void church() {
        const Vector3d corner(33.0, 38.0, kGround_m);
        constexpr double kSide_m = 7.5, kHeight_m = 31.0;
        add("church tower", corner, {kSide_m, 0, 0}, {0, 0, kHeight_m},
            drawTower(kSide_m, kHeight_m, 0.025, kSunny, rng_));
        const cv::Mat flank = drawTower(kSide_m, kHeight_m, 0.04, kShade, rng_);
        add("church tower", corner + Vector3d(0, kSide_m, 0), {0, -kSide_m, 0}, {0, 0, kHeight_m}, flank);
        add("church tower", corner + Vector3d(kSide_m, 0, 0), {0, kSide_m, 0}, {0, 0, kHeight_m}, flank);
        const cv::Mat merlon = drawWall(Wall::kStone, {130, 150, 162}, 1.0, 1.2, 0.04, rng_).image();
        for (int i = 0; i < 4; ++i) {
            add("church tower", corner + Vector3d(0.25 + 2.0 * i, 0, kHeight_m), {1.0, 0, 0}, {0, 0, 1.2},
                merlon);
        }
        for (int layer = 0; layer < 9; ++layer) {  // the spire, in narrowing courses of slate
            const double half = 2.9 * (1.0 - layer / 9.0) + 0.1;
            const cv::Mat slate = drawRoof({104, 108, 96}, 2 * half, 1.5, 0.05, rng_);
            add("church tower", corner + Vector3d(kSide_m / 2 - half, 2.0, kHeight_m + 1.5 * layer),
                {2 * half, 0, 0}, {0, 0.25, 1.5}, slate);
        }
        add("church nave", {16.5, 41.0, kGround_m}, {16.5, 0, 0}, {0, 0, 15.0},
            drawWall(Wall::kStone, {132, 150, 160}, 16.5, 15.0, 0.04, rng_).image());
    }

    void box(const char* name, const Vector3d& corner, const Vector3d& size, const cv::Mat& front,
             const cv::Mat& side, const cv::Mat& top) {
        const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
        add(name, corner, x, z, front);
        add(name, corner + y, -y, z, side);
        add(name, corner + x, y, z, side);
        add(name, corner + z, x, y, top);
    }

    void furniture() {
        const cv::Mat basin = drawWall(Wall::kStone, {160, 176, 184}, 4.4, 0.75, 0.008, rng_).image();
        const cv::Mat water = drawWall(Wall::kPlaster, {150, 132, 96}, 4.4, 3.2, 0.02, rng_).image();
        box("fountain", {-2.4, 13.2, kGround_m}, {4.4, 3.2, 0.75}, basin, basin * 0.8, water);
        const cv::Mat pillar = drawWall(Wall::kStone, {150, 168, 176}, 0.8, 2.9, 0.008, rng_).image();
        box("fountain", {-0.6, 14.4, kGround_m}, {0.8, 0.8, 2.9}, pillar, pillar * 0.75, pillar);

        const cv::Mat bills = drawPosters(2.1, 2.9, 0.005, kSunny, rng_);
        add("poster wall", {-6.6, 5.6, kGround_m}, {1.5, 1.45, 0}, {0, 0, 2.9}, bills);

        const cv::Mat green = drawHedge(5.0, 0.9, 0.008, rng_);
        box("hedge", {7.4, 10.4, kGround_m}, {5.0, 0.8, 0.9}, green, green * 0.8, green * 1.15);
        box("hedge", {-12.4, 13.0, kGround_m}, {5.0, 0.8, 0.9}, green, green * 0.8, green * 1.15);

        const cv::Mat black = drawBlackBoard(1.4, 1.4, 0.005, rng_);
        add("black board", {2.9, 9.9, kGround_m + 0.9}, {1.34, -0.40, 0}, {0, 0, 1.4}, black, true);
        const cv::Mat legs = drawWall(Wall::kPlaster, {60, 80, 100}, 0.06, 0.9, 0.01, rng_).image();
        add("black board", {3.1, 9.84, kGround_m}, {0.06, -0.018, 0}, {0, 0, 0.9}, legs);
        add("black board", {3.98, 9.58, kGround_m}, {0.06, -0.018, 0}, {0, 0, 0.9}, legs);
    }

    /// A mark whose centre is at this place; its board stands upright along `right`.
    void mark(const QString& name, const Vector3d& centre, const Vector3d& right, double size_m,
              const cv::Mat& texture) {
        const Vector3d half = right.normalized() * size_m / 2;
        const Vector3d up(0, 0, size_m);
        panels.push_back({name, centre - half - up / 2, 2 * half, up, texture, false});
        marks.push_back({name, centre});
    }

    void onFront(const char* name, const char* house, double along_m, double up_m, double size_m) {
        const auto& [origin, right] = fronts_.at(house);
        const Vector3d off_wall = right.cross(Vector3d::UnitZ()).normalized() * 0.02;
        mark(QString::fromLatin1(name),
             origin + right.normalized() * along_m + Vector3d(0, 0, up_m) + off_wall, right, size_m,
             quadrants_);
    }

    void prismOnPole(const char* name, const Vector3d& centre) {
        const Vector3d right =
            Vector3d(centre.y(), -centre.x(), 0).normalized();  // square to the line of sight
        const double height = centre.z() - 0.07 - kGround_m;
        const cv::Mat pole = drawWall(Wall::kPlaster, {60, 70, 200}, 0.03, height, 0.01, rng_).image();
        const Vector3d behind = Vector3d(centre.x(), centre.y(), 0).normalized() * 0.02;
        add("range pole", Vector3d(centre.x(), centre.y(), kGround_m) - right * 0.015 + behind, right * 0.03,
            {0, 0, height}, pole);
        mark(QString::fromLatin1(name), centre, right, 0.14, drawPrism(140));
    }

    void targets() {
        onFront("T1", "bakery", 3.4, 1.8, 0.2);
        onFront("T2", "bakery", 8.1, 7.3, 0.2);
        onFront("T3", "inn", 5.2, 4.15, 0.2);
        onFront("T4", "town hall", 2.9, 4.6, 0.2);
        onFront("T5", "town hall", 11.5, 8.4, 0.2);
        onFront("T6", "bookshop", 3.1, 1.7, 0.2);
        onFront("T7", "bookshop", 6.1, 7.2, 0.2);
        onFront("T8", "pharmacy", 4.5, 4.8, 0.2);
        onFront("T9", "post office", 5.0, 4.7, 0.2);
        onFront("T14", "clockmaker", 5.0, 4.2, 0.2);
        onFront("T15", "library", 5.0, 4.6, 0.2);
        onFront("T10", "brewery", 6.0, 4.9, 0.2);
        onFront("T11", "weigh house", 6.0, 4.7, 0.2);
        mark(QStringLiteral("T12"), {-6.6 + 0.75 + 0.014, 5.6 + 0.725 - 0.014, kGround_m + 2.6},
             {1.5, 1.45, 0}, 0.15, quadrants_);
        mark(QStringLiteral("T13"), {1.3, 13.18, kGround_m + 0.5}, {1, 0, 0}, 0.12, quadrants_);
        prismOnPole("P1", {-3.6, 16.8, 0.1});
        prismOnPole("P2", {9.6, 17.2, 0.3});
        prismOnPole("P3", {15.8, 12.2, -0.1});
    }

    cv::RNG rng_;
    std::map<std::string, std::pair<Vector3d, Vector3d>> fronts_;
    cv::Mat quadrants_ = drawQuadrants(200);
};

}  // namespace

Scene Scene::townSquare(unsigned seed) {
    SquareBuilder square(seed);
    square.build();
    return Scene(std::move(square.panels), std::move(square.marks), seed);
}

}  // namespace pmts::simulator
