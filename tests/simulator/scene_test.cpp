#include "pmts/simulator/scene.hpp"

#include "pmts/geometry/polar.hpp"
#include "scene_atlas.hpp"
#include "support/matchers.hpp"

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace pmts::simulator {
namespace {

using core::Angle;

cv::Mat grey(int value = 128) { return {8, 8, CV_8UC3, cv::Scalar::all(value)}; }

/// A wall square to north, `north_m` away, 4 m wide and high, centred on the horizon.
Panel wall(const char* name, double north_m, bool absorbing = false) {
    return {QString::fromLatin1(name), {-2, north_m, -2}, {4, 0, 0}, {0, 0, 4}, grey(), absorbing};
}

geometry::Pointing pointing(double ha_gon, double va_gon) {
    return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)};
}

geometry::Pointing pointingTo(const Eigen::Vector3d& p_station) {
    return geometry::polarFromStation(p_station).value().pointing;
}

TEST(SceneTest, EchoComesFromTheNearestSurface) {
    const Scene scene({wall("far", 20), wall("near", 10)});

    const auto echo = scene.echo(pointing(0, 100));

    ASSERT_TRUE(echo.has_value());
    EXPECT_EQ(echo->panel, QStringLiteral("near"));
    EXPECT_NEAR(echo->distance_m, 10.0, 1e-9);
}

TEST(SceneTest, EchoIsTheSlopeDistanceOfAnObliqueSight) {
    const Scene scene({wall("north", 10)});

    const auto echo = scene.echo(pointing(10, 95));  // 10 m / (cos 10 gon * sin 95 gon) = 10.15596 m

    ASSERT_TRUE(echo.has_value());
    EXPECT_NEAR(echo->distance_m, 10.15596, 5e-6);
}

TEST(SceneTest, EchoIsTheSameInFaceTwo) {
    const Scene scene({wall("north", 10)});

    const auto echo = scene.echo(pointing(210, 305));

    ASSERT_TRUE(echo.has_value());
    EXPECT_NEAR(echo->distance_m, 10.15596, 5e-6);
}

TEST(SceneTest, AbsorbingSurfaceGivesNoEchoAndHidesWhatIsBehind) {
    const Scene scene({wall("black", 10, true), wall("behind", 20)});
    EXPECT_FALSE(scene.echo(pointing(0, 100)).has_value());
}

TEST(SceneTest, SkyAndTheOppositeDirectionGiveNoEcho) {
    const Scene scene({wall("north", 10)});
    EXPECT_FALSE(scene.echo(pointing(0, 40)).has_value());
    EXPECT_FALSE(scene.echo(pointing(200, 100)).has_value());
}

TEST(SceneTest, TexturesSharedByPanelsAreStoredOnce) {
    const cv::Mat tile = grey();
    const Scene scene({{QStringLiteral("a"), {0, 9, 0}, {1, 0, 0}, {0, 0, 1}, tile},
                       {QStringLiteral("b"), {1, 9, 0}, {1, 0, 0}, {0, 0, 1}, tile}});
    EXPECT_EQ(scene.atlas().levels(0).front(), scene.atlas().levels(1).front());
}

TEST(SceneTest, TownSquareIsTheSameForASeed) {
    const Scene once = Scene::townSquare(3);
    const Scene again = Scene::townSquare(3);
    EXPECT_EQ(cv::norm(once.atlas().image(), again.atlas().image(), cv::NORM_INF), 0.0);
}

class TownSquareTest : public testing::Test {
protected:
    static const Scene& square() {
        static const Scene scene = Scene::townSquare(1);
        return scene;
    }
};

TEST_F(TownSquareTest, EveryMarkIsSeenAndMeasuredAtItsPlace) {
    for (const Mark& mark : square().marks()) {
        const auto echo = square().echo(pointingTo(mark.p_station_m));
        ASSERT_TRUE(echo.has_value()) << mark.name.toStdString();
        EXPECT_EQ(echo->panel, mark.name);
        EXPECT_NEAR(echo->distance_m, mark.p_station_m.norm(), 1e-9) << mark.name.toStdString();
    }
}

TEST_F(TownSquareTest, HasMarksAllRoundTheHorizonAndAtAllRanges) {
    double nearest_m = 1e9, farthest_m = 0.0;
    std::set<int> quarters;
    for (const Mark& mark : square().marks()) {
        nearest_m = std::min(nearest_m, mark.p_station_m.norm());
        farthest_m = std::max(farthest_m, mark.p_station_m.norm());
        quarters.insert(static_cast<int>(core::normalized(pointingTo(mark.p_station_m).ha).gon() / 100.0));
    }
    EXPECT_LE(nearest_m, 10.0);
    EXPECT_GE(farthest_m, 30.0);
    EXPECT_EQ(quarters.size(), 4U);
}

TEST_F(TownSquareTest, BlackBoardSwallowsTheBeam) {
    const auto& panels = square().panels();
    const auto board =
        std::find_if(panels.begin(), panels.end(), [](const Panel& panel) { return panel.absorbing; });
    ASSERT_NE(board, panels.end());
    EXPECT_FALSE(
        square().echo(pointingTo(board->origin_m + board->right_m / 2 + board->up_m / 2)).has_value());
}

TEST_F(TownSquareTest, StaysWithinItsMemory) {
    const cv::Mat& atlas = square().atlas().image();
    EXPECT_LE(static_cast<double>(atlas.total() * atlas.elemSize()) / 1e6, 70.0);
}

TEST_F(TownSquareTest, NoHouseFrontIsAFlatColour) {
    for (const Panel& panel : square().panels()) {
        if (panel.right_m.norm() < 8.0 || panel.up_m.z() < 8.0) {
            continue;
        }
        cv::Scalar mean, spread;
        cv::meanStdDev(panel.texture(cv::Rect(panel.texture.cols / 2, panel.texture.rows / 2, 60, 60)), mean,
                       spread);
        EXPECT_GE(spread[1], 3.0) << panel.name.toStdString();
    }
}

}  // namespace
}  // namespace pmts::simulator
