#include "pmts/simulator/scene.hpp"
#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <opencv2/imgcodecs.hpp>

namespace pmts::simulator {
namespace {

using core::ErrorKind;
using test::FailedWith;
using testing::HasSubstr;

class SceneFileTest : public testing::Test {
protected:
    QString write(const QByteArray& text) const {
        const QString path = folder_.filePath(QStringLiteral("scene.json"));
        QFile file(path);
        file.open(QIODevice::WriteOnly);
        file.write(text);
        return path;
    }
    std::string refusal(const QByteArray& text) const {
        const auto scene = Scene::fromFile(write(text));
        EXPECT_THAT(scene, FailedWith(ErrorKind::kBadInput));
        return scene.has_value() ? std::string() : scene.error().sentence().toStdString();
    }

    QTemporaryDir folder_;
};

const QByteArray kWall =
    R"({"name": "wall", "origin_m": [-5, 20, -1.6], "right_m": [10, 0, 0], "up_m": [0, 0, 8],
                            "texture": {"kind": "brick", "texel_m": 0.05, "seed": 4}})";

QByteArray file(const QByteArray& panels, const QByteArray& marks = "") {
    return R"({"format": "pmts-scene", "panels": [)" + panels + R"(], "marks": [)" + marks + "]}";
}

TEST_F(SceneFileTest, ReadsPanelsAndMarks) {
    const auto scene =
        Scene::fromFile(write(file(kWall, R"({"name": "T1", "position_m": [0, 19.9, 0], "size_m": 0.2})")));

    ASSERT_TRUE(scene.has_value()) << testing::PrintToString(scene.error());
    ASSERT_EQ(scene->marks().size(), 1U);
    EXPECT_EQ(scene->marks()[0].p_station_m, Eigen::Vector3d(0, 19.9, 0));
    const auto echo = scene->echo({core::Angle::fromGon(0), core::Angle::fromGon(100)});
    ASSERT_TRUE(echo.has_value());
    EXPECT_EQ(echo->panel, QStringLiteral("T1"));
    EXPECT_NEAR(echo->distance_m, 19.9, 1e-9);
}

TEST_F(SceneFileTest, TakesAnImageBesideTheFileAsTexture) {
    cv::imwrite(folder_.filePath(QStringLiteral("front.png")).toStdString(),
                cv::Mat(40, 30, CV_8UC3, cv::Scalar(10, 20, 30)));
    QByteArray panel = kWall;
    panel.replace(R"("kind": "brick")", R"("image": "front.png")");

    const auto scene = Scene::fromFile(write(file(panel)));

    ASSERT_TRUE(scene.has_value()) << testing::PrintToString(scene.error());
    EXPECT_EQ(scene->panels()[0].texture.size(), cv::Size(30, 40));
    EXPECT_EQ(scene->panels()[0].texture.at<cv::Vec3b>(5, 5), cv::Vec3b(10, 20, 30));
}

TEST_F(SceneFileTest, NamesTheMemberThatIsWrong) {
    QByteArray panel = kWall;
    panel.replace("[10, 0, 0]", "[10, 0]");
    EXPECT_THAT(refusal(file(kWall + "," + panel)),
                HasSubstr("panels[1].right_m, three numbers were expected"));
}

TEST_F(SceneFileTest, NamesTheTextureKindsWhenOneIsUnknown) {
    QByteArray panel = kWall;
    panel.replace("brick", "marzipan");
    EXPECT_THAT(refusal(file(panel)), HasSubstr("panels[0].texture.kind, plaster, brick"));
}

TEST_F(SceneFileTest, RefusesPanelsThatAreNoRectangles) {
    QByteArray panel = kWall;
    panel.replace("[0, 0, 8]", "[4, 0, 8]");
    EXPECT_THAT(refusal(file(panel)), HasSubstr("two sides of a rectangle"));
}

TEST_F(SceneFileTest, RefusesTexturesBeyondReason) {
    QByteArray panel = kWall;
    panel.replace("0.05", "0.0001");
    EXPECT_THAT(refusal(file(panel)), HasSubstr("panels[0].texture.texel_m"));
}

TEST_F(SceneFileTest, NamesTheLineWhereTheTextIsNoJson) {
    EXPECT_THAT(refusal("{\n\"format\": \"pmts-scene\",\n\"panels\": [,]\n}"), HasSubstr("line 3"));
}

TEST_F(SceneFileTest, RefusesAForeignFile) {
    EXPECT_THAT(refusal(R"({"type": "FeatureCollection"})"), HasSubstr("\"pmts-scene\" was expected"));
}

TEST_F(SceneFileTest, SaysWhenTheFileOrItsImageIsMissing) {
    EXPECT_THAT(Scene::fromFile(folder_.filePath(QStringLiteral("none.json"))), FailedWith(ErrorKind::kFile));
    QByteArray panel = kWall;
    panel.replace(R"("kind": "brick")", R"("image": "none.jpg")");
    EXPECT_THAT(Scene::fromFile(write(file(panel))), FailedWith(ErrorKind::kFile));
}

TEST_F(SceneFileTest, ShippedExampleLoads) {
    const auto scene =
        Scene::fromFile(QStringLiteral(PMTS_TEST_DATA "/../../resources/scenes/courtyard.json"));
    ASSERT_TRUE(scene.has_value()) << testing::PrintToString(scene.error());
    EXPECT_GE(scene->marks().size(), 3U);
}

}  // namespace
}  // namespace pmts::simulator
