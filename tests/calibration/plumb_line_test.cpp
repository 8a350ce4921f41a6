#include "pmts/calibration/plumb_line.hpp"

#include "pmts/simulator/scene_camera.hpp"
#include "support/matchers.hpp"

#include <opencv2/imgproc.hpp>

namespace pmts::calibration {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;

camera::Rig rigWith(double twist_gon, double pitch_gon = -0.2, camera::MountKind kind = camera::MountKind::kTelescope) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1400, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12, .k2 = 0.02});
    rig.mount = {.kind = kind, .offset_m = {0.012, 0.085, 0.052}, .yaw = Angle::fromGon(0.15),
                 .pitch = Angle::fromGon(pitch_gon), .twist = Angle::fromGon(twist_gon)};
    return rig;
}

geometry::Pointing at(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

/// A white board 4 m to the north with a cord of 6 mm hanging before it, `east_m` right of north.
std::shared_ptr<const simulator::Scene> cordAt(double east_m, const std::vector<double>& others_m = {}) {
    cv::Mat texture(2000, 3000, CV_8UC3, cv::Scalar::all(200));  // 2 mm a texel
    const auto hang = [&texture](double metres) {
        const int column = static_cast<int>(std::lround((metres + 3.0) / 0.002));
        cv::rectangle(texture, cv::Rect(column - 1, 0, 3, texture.rows), cv::Scalar::all(40), cv::FILLED);
    };
    hang(east_m);
    std::for_each(others_m.begin(), others_m.end(), hang);
    return std::make_shared<const simulator::Scene>(
        std::vector<simulator::Panel>{{QStringLiteral("board"), {-3, 4, -2}, {6, 0, 0}, {0, 0, 4}, texture}});
}

cv::Mat seen(const std::shared_ptr<const simulator::Scene>& scene, const camera::Rig& rig, const geometry::Pointing& pointing) {
    auto truth = std::make_shared<simulator::TruePointing>();
    truth->place(pointing);
    return simulator::SceneCamera(scene, truth, rig, {.noise_sigma = 2.0}).draw({}).image.clone();
}

/// The twist found by somebody who knows everything but the twist.
core::Result<TwistFromLine> twistSeen(const camera::Rig& truth, const geometry::Pointing& pointing, double east_m = 0.0) {
    const auto line = findPlumbLine(seen(cordAt(east_m), truth, pointing), truth.lens);
    PMTS_TRY(line);
    camera::Rig believed = truth;
    believed.mount.twist = Angle();
    return twistFromLine(*line, believed, pointing);
}

TEST(PlumbLineTest, TwistIsFoundWithinTenMgon) {
    for (const double twist_gon : {0.0, 0.3, -1.7, 6.0}) {
        const auto found = twistSeen(rigWith(twist_gon), at(0, 100));

        ASSERT_TRUE(found.has_value()) << twist_gon << ": " << testing::PrintToString(found.error());
        EXPECT_THAT(found->twist, IsNearAngle(Angle::fromGon(twist_gon), Angle::fromMgon(10)));
        EXPECT_LT(found->sigma, Angle::fromMgon(5));
    }
}

// A telescope that looks up sees what is upright lean inward beside the middle of the picture: by 1.6 gon here.
TEST(PlumbLineTest, TiltAndPlaceInThePictureDoNotPassForTwist) {
    for (const double va_gon : {88.0, 112.0}) {
        const auto found = twistSeen(rigWith(0.3), at(0, va_gon), 0.6);

        ASSERT_TRUE(found.has_value()) << testing::PrintToString(found.error());
        EXPECT_THAT(found->twist, IsNearAngle(Angle::fromGon(0.3), Angle::fromMgon(10)));
    }
}

TEST(PlumbLineTest, PitchOfAHandleCameraIsInTheModelToo) {
    const auto found = twistSeen(rigWith(-0.8, 4.0, camera::MountKind::kHandle), at(0, 93), -0.5);

    ASSERT_TRUE(found.has_value()) << testing::PrintToString(found.error());
    EXPECT_THAT(found->twist, IsNearAngle(Angle::fromGon(-0.8), Angle::fromMgon(10)));
}

TEST(PlumbLineTest, UpsideDownPictureOfFaceTwoGivesTheSameTwist) {
    const auto found = twistSeen(rigWith(0.5), at(200, 300));

    ASSERT_TRUE(found.has_value()) << testing::PrintToString(found.error());
    EXPECT_THAT(found->twist, IsNearAngle(Angle::fromGon(0.5), Angle::fromMgon(10)));
}

TEST(PlumbLineTest, PlainPictureHasNoLine) {
    const cv::Mat wall(720, 1280, CV_8UC3, cv::Scalar::all(128));

    EXPECT_THAT(findPlumbLine(wall, rigWith(0).lens), FailedWith(ErrorKind::kNotReached));
}

TEST(PlumbLineTest, OfTwoCordsTheClickedOneIsTaken) {
    const camera::Rig rig = rigWith(0.3);
    const cv::Mat picture = seen(cordAt(0.0, {0.5}), rig, at(0, 100));

    const auto unasked = findPlumbLine(picture, rig.lens);
    const auto clicked = findPlumbLine(picture, rig.lens, Eigen::Vector2d(825, 300));

    ASSERT_THAT(unasked, FailedWith(ErrorKind::kNotReached));
    EXPECT_EQ(unasked.error().detail, QStringLiteral("several"));
    ASSERT_TRUE(clicked.has_value()) << testing::PrintToString(clicked.error());
    EXPECT_NEAR(clicked->places_px.front().x(), 825, 30);
}

TEST(PlumbLineTest, ShortPieceOfALineIsRefused) {
    PictureLine line;
    for (int row = 0; row < 30; ++row) {
        line.places_px.emplace_back(600, row);
    }
    line.length_px = 29;

    EXPECT_THAT(twistFromLine(line, rigWith(0), at(0, 100)), FailedWith(ErrorKind::kUndefined));
}

}  // namespace
}  // namespace pmts::calibration
