#include "pmts/simulator/scene_camera.hpp"

#include "support/matchers.hpp"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include <random>

namespace pmts::simulator {
namespace {

using core::Angle;

camera::Rig wideRig() {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{
        .f_px = 1050, .cx_px = 641.3, .cy_px = 357.8, .k1 = -0.21, .k2 = 0.06, .p1 = 0.0006, .p2 = -0.0004});
    rig.mount = {.kind = camera::MountKind::kTelescope,
                 .offset_m = {0.02, 0.09, 0.11},
                 .yaw = Angle::fromGon(0.4),
                 .pitch = Angle::fromGon(-0.3),
                 .twist = Angle::fromGon(1.7)};
    return rig;
}

std::shared_ptr<TruePointing> standing(double ha_gon, double va_gon) {
    auto pointing = std::make_shared<TruePointing>();
    pointing->setMotion({.start_gon = ha_gon, .end_gon = ha_gon}, {.start_gon = va_gon, .end_gon = va_gon});
    return pointing;
}

constexpr CameraFaults kClean{.noise_sigma = 0.0};

/// One panel square to the direction `towards`, its middle there; `size_m` wide and high.
Panel panelAt(const Eigen::Vector3d& middle, const Eigen::Vector3d& towards, double size_m, cv::Mat texture) {
    const Eigen::Vector3d right = towards.cross(Eigen::Vector3d::UnitZ()).normalized() * size_m;
    const Eigen::Vector3d up(0, 0, size_m);
    return {QStringLiteral("board"), middle - right / 2 - up / 2, right, up, std::move(texture)};
}

/// A dark wall with a bright square patch in its middle: the patch's centroid is its centre, as far as it is
/// small.
cv::Mat whiteSpot() {
    cv::Mat texture(400, 400, CV_8UC3, cv::Scalar::all(0));
    texture(cv::Rect(194, 194, 12, 12)).setTo(cv::Scalar::all(250));
    return texture;
}

Eigen::Vector2d centroid(const cv::Mat& image, const cv::Rect& around) {
    cv::Mat grey;
    cv::cvtColor(image(around), grey, cv::COLOR_BGR2GRAY);
    const cv::Moments moments = cv::moments(grey);
    return {around.x + moments.m10 / moments.m00, around.y + moments.m01 / moments.m00};
}

cv::Rect windowAround(const Eigen::Vector2d& px, int half_px) {
    return {static_cast<int>(px.x()) - half_px, static_cast<int>(px.y()) - half_px, 2 * half_px + 1,
            2 * half_px + 1};
}

/// Draws a spot at a place and returns how far its centroid is from where the rig's model says, in pixels.
double spotMiss(const camera::Rig& rig, const geometry::Pointing& pointing, const Eigen::Vector3d& spot) {
    const auto scene = std::make_shared<const Scene>(std::vector{panelAt(spot, spot, 4.0, whiteSpot())});
    SceneCamera camera(scene, standing(pointing.ha.gon(), pointing.va.gon()), rig, kClean);
    const Eigen::Vector2d expected = camera::pixelFromStation(rig, pointing, spot).value();
    const camera::Frame frame = camera.draw(core::Duration(0));
    return (centroid(frame.image, windowAround(expected, 20)) - expected).norm();
}

TEST(SceneCameraTest, DrawsAPointWhereTheRigSaysItAppears) {
    const geometry::Pointing pointing{Angle::fromGon(12), Angle::fromGon(96)};
    EXPECT_LE(spotMiss(wideRig(), pointing, {3.0, 15.0, 0.9}), 0.05);
}

TEST(SceneCameraTest, DrawsPointsAllOverTheImageWithinATwentiethOfAPixel) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> across(-6.0, 6.0), up(-3.0, 3.0);
    for (int i = 0; i < 12; ++i) {
        const Eigen::Vector3d spot(across(random), 18.0, up(random));
        EXPECT_LE(spotMiss(wideRig(), {Angle::fromGon(0), Angle::fromGon(100)}, spot), 0.05)
            << spot.transpose();
    }
}

TEST(SceneCameraTest, DrawsRightInFaceTwoToo) {
    EXPECT_LE(spotMiss(wideRig(), {Angle::fromGon(212), Angle::fromGon(304)}, {3.0, 15.0, 0.9}), 0.05);
}

TEST(SceneCameraTest, HandleCameraStaysLevelWhenTheTelescopeTilts) {
    camera::Rig rig = wideRig();
    rig.mount.kind = camera::MountKind::kHandle;
    EXPECT_LE(spotMiss(rig, {Angle::fromGon(10), Angle::fromGon(70)}, {2.5, 15.0, 0.9}), 0.05);
}

/// Outside number: f = 1000 px, a target 1 m right and 2 m up at 20 m forward is 50 px right and 100 px above
/// the centre.
TEST(SceneCameraTest, RightIsRightAndUpIsUp) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 639.5, .cy_px = 359.5});
    const auto scene =
        std::make_shared<const Scene>(std::vector{panelAt({1, 20, 2}, {0, 1, 0}, 4.0, whiteSpot())});
    SceneCamera camera(scene, standing(0, 100), rig, kClean);

    const Eigen::Vector2d seen = centroid(camera.draw(core::Duration(0)).image, {640, 200, 100, 100});

    EXPECT_NEAR(seen.x(), 689.5, 0.05);
    EXPECT_NEAR(seen.y(), 259.5, 0.05);
}

TEST(SceneCameraTest, NearPanelHidesFarOneWhateverTheirOrder) {
    const Panel near = panelAt({0, 5, 0}, {0, 1, 0}, 1.0, cv::Mat(8, 8, CV_8UC3, cv::Scalar(0, 0, 200)));
    const Panel far = panelAt({0, 30, 0}, {0, 1, 0}, 30.0, cv::Mat(8, 8, CV_8UC3, cv::Scalar(200, 0, 0)));
    for (const std::vector<Panel>& panels : {std::vector{near, far}, std::vector{far, near}}) {
        camera::Rig rig;
        rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 639.5, .cy_px = 359.5});
        SceneCamera camera(std::make_shared<const Scene>(panels), standing(0, 100), rig, kClean);
        const cv::Mat image = camera.draw(core::Duration(0)).image;
        EXPECT_EQ(image.at<cv::Vec3b>(360, 640), cv::Vec3b(0, 0, 200));
        EXPECT_EQ(image.at<cv::Vec3b>(360, 800), cv::Vec3b(200, 0, 0));
    }
}

TEST(SceneCameraTest, PanelThatPassesBehindTheCameraIsCutOff) {
    // A floor from 20 m behind to 20 m in front of the camera: it fills the lower half and never the upper
    // one.
    const Panel floor{QStringLiteral("floor"),
                      {-20, -20, -1.5},
                      {40, 0, 0},
                      {0, 40, 0},
                      cv::Mat(64, 64, CV_8UC3, cv::Scalar(0, 0, 255))};
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 639.5, .cy_px = 359.5});
    SceneCamera camera(std::make_shared<const Scene>(std::vector{floor}), standing(0, 100), rig, kClean);

    const cv::Mat image = camera.draw(core::Duration(0)).image;

    EXPECT_EQ(image.at<cv::Vec3b>(719, 0), cv::Vec3b(0, 0, 255));
    EXPECT_EQ(image.at<cv::Vec3b>(450, 1279), cv::Vec3b(0, 0, 255));
    EXPECT_NE(image.at<cv::Vec3b>(200, 640), cv::Vec3b(0, 0, 255));
}

TEST(SceneCameraTest, FollowsTheTruePointingOfTheMoment) {
    auto pointing = standing(0, 100);
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 639.5, .cy_px = 359.5});
    const auto scene =
        std::make_shared<const Scene>(std::vector{panelAt({0, 20, 0}, {0, 1, 0}, 4.0, whiteSpot())});
    SceneCamera camera(scene, pointing, rig, kClean);
    (void)camera.draw(core::Duration(0));

    pointing->setMotion({.start_gon = 1, .end_gon = 1}, {.start_gon = 100, .end_gon = 100});
    const cv::Mat image = camera.draw(std::chrono::seconds(1)).image;

    // 1 gon to the right: the target moves left by 1000 px * tan(1 gon) = 15.71 px.
    EXPECT_NEAR(centroid(image, {590, 330, 80, 60}).x(), 639.5 - 15.709, 0.05);
}

TEST(SceneCameraTest, NoiseIsSeededAndOfTheSizeAsked) {
    const auto scene = std::make_shared<const Scene>(
        std::vector{panelAt({0, 5, 0}, {0, 1, 0}, 20.0, cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(128)))});
    SceneCamera once(scene, standing(0, 100), wideRig(), {.noise_sigma = 3.0, .seed = 9});
    SceneCamera again(scene, standing(0, 100), wideRig(), {.noise_sigma = 3.0, .seed = 9});
    const cv::Mat image = once.draw(core::Duration(0)).image;
    EXPECT_EQ(cv::norm(image, again.draw(core::Duration(0)).image, cv::NORM_INF), 0.0);
    cv::Scalar mean, sigma;
    cv::meanStdDev(image, mean, sigma);
    EXPECT_NEAR(mean[0], 128.0, 0.2);
    EXPECT_NEAR(sigma[0], 3.0, 0.15);
}

TEST(SceneCameraTest, ExposureAndBlurChangeThePicture) {
    const auto scene =
        std::make_shared<const Scene>(std::vector{panelAt({0, 5, 0}, {0, 1, 0}, 4.0, whiteSpot())});
    SceneCamera dim(scene, standing(0, 100), wideRig(),
                    {.noise_sigma = 0.0, .blur_px = 2.0, .exposure_gain = 0.5});
    const cv::Mat image = dim.draw(core::Duration(0)).image;
    double brightest = 0.0;
    cv::minMaxLoc(image(cv::Rect(440, 160, 400, 400)).reshape(1), nullptr, &brightest);
    EXPECT_NEAR(brightest, 125.0, 2.0);
}

TEST(SceneCameraTest, DrawnFrameIsNeverDrawnOverWhileSomebodyHoldsIt) {
    const auto scene =
        std::make_shared<const Scene>(std::vector{panelAt({0, 5, 0}, {0, 1, 0}, 4.0, whiteSpot())});
    auto pointing = standing(0, 100);
    SceneCamera camera(scene, pointing, wideRig(), kClean);
    const camera::Frame held = camera.draw(core::Duration(0));
    const cv::Mat copy = held.image.clone();
    pointing->setMotion({.start_gon = 30, .end_gon = 30}, {.start_gon = 100, .end_gon = 100});
    for (int i = 0; i < 8; ++i) {
        (void)camera.draw(core::Duration(0));
    }
    EXPECT_EQ(cv::norm(held.image, copy, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace pmts::simulator
