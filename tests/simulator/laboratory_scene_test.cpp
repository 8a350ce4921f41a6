#include "pmts/simulator/scene_camera.hpp"
#include "support/matchers.hpp"

#include <cmath>

namespace pmts::simulator {
namespace {

using core::Angle;

TEST(LaboratorySceneTest, BoardsAndTargetsStandAtTheirDistances) {
    const auto scene = Scene::named(QStringLiteral("laboratory"), 1);
    ASSERT_TRUE(scene.has_value()) << testing::PrintToString(scene.error());

    const std::map<QString, double> wanted{{"D", 4.0}, {"2D", 8.0}, {"T1", 5.333}, {"T2", 9.999}, {"T3", 15.003}};
    int found = 0;
    for (const Mark& mark : scene->marks()) {
        const auto distance = wanted.find(mark.name);
        if (distance == wanted.end()) {
            continue;
        }
        ++found;
        EXPECT_NEAR(mark.p_station_m.norm(), distance->second, 1e-4) << qPrintable(mark.name);
        const geometry::Pointing at{Angle::fromRad(std::atan2(mark.p_station_m.x(), mark.p_station_m.y())),
                                    Angle::fromRad(std::acos(mark.p_station_m.z() / mark.p_station_m.norm()))};
        const auto echo = scene->echo(at);
        ASSERT_TRUE(echo.has_value());
        EXPECT_EQ(echo->panel, mark.name);  // nothing stands before it
    }
    EXPECT_EQ(found, 5);
}

TEST(LaboratorySceneTest, PlumbLineHangsBeforeEverythingElse) {
    const auto scene = Scene::named(QStringLiteral("laboratory"), 1);
    ASSERT_TRUE(scene.has_value());

    const auto echo = scene->echo({Angle::fromGon(270), Angle::fromGon(100)});

    ASSERT_TRUE(echo.has_value());
    EXPECT_EQ(echo->panel, QStringLiteral("plumb line"));
    EXPECT_NEAR(echo->distance_m, 4.0, 1e-3);
}

TEST(LaboratorySceneTest, ChessboardsHangTiltedInFreeSight) {
    const auto scene = Scene::named(QStringLiteral("laboratory"), 1);
    ASSERT_TRUE(scene.has_value());
    for (const auto& [name, ha_gon, distance_m] : {std::tuple("chessboard A", 400.0 / 9, 2.2), std::tuple("chessboard B", 1400.0 / 9, 2.0)}) {
        const auto echo = scene->echo({Angle::fromGon(ha_gon), Angle::fromGon(100)});
        ASSERT_TRUE(echo.has_value());
        EXPECT_EQ(echo->panel, QString::fromLatin1(name));
        EXPECT_NEAR(echo->distance_m, distance_m, 0.1);
    }
}

TEST(LaboratorySceneTest, UnknownNameIsTakenForAFile) {
    EXPECT_THAT(Scene::named(QStringLiteral("no-such-scene"), 1), test::FailedWith(core::ErrorKind::kFile));
}

}  // namespace
}  // namespace pmts::simulator
