#include "pmts/camera/lens.hpp"
#include "support/matchers.hpp"

#include <cmath>

namespace pmts::camera {
namespace {

/// A gentle swirl of up to 1.5 px over a 1280 x 720 picture.
ResidualTable swirl() {
    ResidualTable table{.left_px = 0,
                        .top_px = 0,
                        .step_x_px = 128,
                        .step_y_px = 120,
                        .columns = 11,
                        .rows = 7,
                        .nodes_px = {}};
    for (int row = 0; row < table.rows; ++row) {
        for (int column = 0; column < table.columns; ++column) {
            table.nodes_px.emplace_back(1.5 * std::sin(0.6 * row), std::cos(0.5 * column) - 0.3);
        }
    }
    return table;
}

TEST(ResidualTableTest, NodesAreMetAndStraightLinesAreKeptUpToTheEdge) {
    ResidualTable table = swirl();
    EXPECT_TRUE(table.at({128, 240}).isApprox(table.nodes_px[2 * 11 + 1], 1e-12));
    for (int row = 0; row < table.rows; ++row) {
        for (int column = 0; column < table.columns; ++column) {
            table.nodes_px[static_cast<std::size_t>(row * 11 + column)] = {0.01 * column, 0.02 * row};
        }
    }
    EXPECT_TRUE(table.at({64, 690}).isApprox(Eigen::Vector2d(0.005, 0.115), 1e-12));
    EXPECT_TRUE(table.at({1279, 30}).isApprox(Eigen::Vector2d(0.0999219, 0.005), 1e-5));
}

TEST(ResidualTableTest, OutsideTheGridTheNearestEdgeHolds) {
    const ResidualTable table = swirl();
    EXPECT_EQ(table.at({-500, 240}), table.at({0, 240}));
    EXPECT_EQ(table.at({400, 9000}), table.at({400, 720}));
}

TEST(ResidualTableTest, ValueAndSlopeAreTheSameOnBothSidesOfANode) {
    const ResidualTable table = swirl();
    const double e = 1e-4;
    for (const double u : {128.0, 512.0, 1152.0}) {
        const Eigen::Vector2d before = (table.at({u, 300}) - table.at({u - e, 300})) / e;
        const Eigen::Vector2d after = (table.at({u + e, 300}) - table.at({u, 300})) / e;
        EXPECT_LT((before - after).norm(), 1e-6) << u;
    }
}

TEST(ResidualTableTest, LensWithATableSeesWhatTheModelPutsBesideIt) {
    const Lens model(BrownLens{.f_px = 1000, .cx_px = 640, .cy_px = 360, .k1 = -0.1});
    const Lens lens = model.withResiduals(swirl());
    const Eigen::Vector2d seen(300, 500);
    const auto ray = lens.cameraFromPixel(seen);
    ASSERT_TRUE(ray.has_value());
    EXPECT_LT((*model.pixelFromCamera(*ray) - (seen - swirl().at(seen))).norm(), 1e-9);
    EXPECT_FALSE(lens.withResiduals(std::nullopt).residuals().has_value());
}

TEST(ResidualTableTest, EveryPixelGoesOutAndComesBackThroughATable) {
    for (const Lens& model :
         {Lens(BrownLens{.f_px = 1000, .cx_px = 640, .cy_px = 360, .k1 = -0.1}),
          Lens(FisheyeLens{.f_px = 700, .cx_px = 640, .cy_px = 360}),
          Lens(RadialTableLens{.cx_px = 640, .cy_px = 360, .rows = {{0, 0}, {900, 0.7}}})}) {
        const Lens lens = model.withResiduals(swirl());
        for (double v = 0; v < 720; v += 36) {
            for (double u = 0; u < 1280; u += 32) {
                const auto ray = lens.cameraFromPixel({u, v});
                ASSERT_TRUE(ray.has_value());
                EXPECT_LT((*lens.pixelFromCamera(*ray) - Eigen::Vector2d(u, v)).norm(), 1e-6);
            }
        }
    }
}

TEST(ResidualTableTest, TableThatFoldsThePictureIsRefused) {
    ResidualTable table = swirl();
    table.nodes_px[5].x() += 60;
    EXPECT_THROW((void)Lens().withResiduals(table), std::logic_error);
    table = swirl();
    table.nodes_px.pop_back();
    EXPECT_THROW((void)Lens().withResiduals(table), std::logic_error);
    table = swirl();
    table.nodes_px[3].y() = std::nan("");
    EXPECT_THROW((void)Lens().withResiduals(table), std::logic_error);
}

TEST(ResidualTableTest, SharesOfTheNodesAddUpToOneAndMakeTheValue) {
    const ResidualTable table = swirl();
    const Eigen::Vector2d px(77, 701);
    double sum = 0;
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    for (const auto& [node, weight] : nodeShares(table, px)) {
        sum += weight;
        value += weight * table.nodes_px[static_cast<std::size_t>(node)];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LT((value - table.at(px)).norm(), 1e-12);
}

}  // namespace
}  // namespace pmts::camera
