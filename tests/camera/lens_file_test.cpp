#include "pmts/camera/lens_file.hpp"

#include "support/matchers.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace pmts::camera {
namespace {

constexpr BrownLens kBrown{.f_px = 1399.123456789, .cx_px = 643.25, .cy_px = 357.75, .k1 = -0.1203, .k2 = 0.021, .k3 = -0.003, .p1 = 2.5e-4, .p2 = -1e-4};
constexpr RationalLens kRational{.f_px = 800, .cx_px = 320.5, .cy_px = 240.25, .k1 = 0.3, .k2 = -0.1, .k3 = 0.01, .k4 = 0.6, .k5 = 0.05, .k6 = 0.002, .p1 = 1e-4, .p2 = 2e-4};
constexpr FisheyeLens kFisheye{.f_px = 420, .cx_px = 639.5, .cy_px = 359.5, .k1 = 0.02, .k2 = -0.005, .k3 = 0.001, .k4 = -2e-4};

/// What OpenCV itself makes of a file: the pixel of a point with the matrices as it reads them.
Eigen::Vector2d seenByOpenCv(const QByteArray& yaml, const Eigen::Vector3d& p_camera) {
    const cv::FileStorage file(yaml.toStdString(), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    cv::Mat k;
    cv::Mat d;
    file["camera_matrix"] >> k;
    file["distortion_coefficients"] >> d;
    const std::vector<cv::Point3d> points{{p_camera.x(), p_camera.y(), p_camera.z()}};
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d zero(0, 0, 0);
    if (static_cast<int>(file["fisheye_model"]) == 1) {
        cv::fisheye::projectPoints(points, pixels, zero, zero, k, d);
    } else {
        cv::projectPoints(points, zero, zero, k, d, pixels);
    }
    return {pixels[0].x, pixels[0].y};
}

class LensFileTest : public testing::TestWithParam<LensModel> {
protected:
    Lens lens = std::visit([](const auto& model) { return Lens(model); }, GetParam());
};

TEST_P(LensFileTest, OpenCvReadsTheYamlAndSeesTheSamePixel) {
    const auto yaml = lensToOpenCvYaml(lens, 1280, 720);
    ASSERT_TRUE(yaml.has_value());
    const Eigen::Vector3d p(0.31, -0.17, 1.0);
    EXPECT_LT((seenByOpenCv(*yaml, p) - *lens.pixelFromCamera(p)).norm(), 1e-9);
}

TEST_P(LensFileTest, YamlAndColmapComeBackAsTheyWere) {
    const auto yaml = lensFromOpenCvYaml(*lensToOpenCvYaml(lens, 1280, 720));
    ASSERT_TRUE(yaml.has_value()) << qPrintable(yaml.error().sentence());
    EXPECT_EQ(yaml->lens.model(), lens.model());
    EXPECT_EQ(yaml->height_px, 720);
    EXPECT_TRUE(yaml->note.isEmpty());
    const auto colmap = lensFromColmap(*lensToColmap(lens, 1280, 720));
    ASSERT_TRUE(colmap.has_value()) << qPrintable(colmap.error().sentence());
    EXPECT_EQ(colmap->lens.model(), lens.model());
    EXPECT_EQ(colmap->width_px, 1280);
}

INSTANTIATE_TEST_SUITE_P(Models, LensFileTest, testing::Values(LensModel(kBrown), LensModel(kRational), LensModel(kFisheye)));

TEST(LensFileFormatTest, ColmapCountsFromTheCornerOfTheFirstPixel) {
    const auto file = lensFromColmap("# Camera list\n1 SIMPLE_RADIAL 640 480 784 320 240 -0.31\n2 PINHOLE 1 1 1 1 1 1\n");
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(std::get<BrownLens>(file->lens.model()), (BrownLens{.f_px = 784, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.31}));
}

TEST(LensFileFormatTest, EveryColmapModelHasItsNumbersInItsPlaces) {
    const auto modelOf = [](const char* line) { return lensFromColmap(line)->lens.model(); };
    EXPECT_EQ(modelOf("1 PINHOLE 640 480 784 784 320 240"), LensModel(BrownLens{.f_px = 784, .cx_px = 319.5, .cy_px = 239.5}));
    EXPECT_EQ(modelOf("1 RADIAL 640 480 784 320 240 -0.3 0.1"),
              LensModel(BrownLens{.f_px = 784, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.3, .k2 = 0.1}));
    EXPECT_EQ(modelOf("1 OPENCV 640 480 784 784 320 240 -0.3 0.1 0.001 0.002"),
              LensModel(BrownLens{.f_px = 784, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.3, .k2 = 0.1, .p1 = 0.001, .p2 = 0.002}));
    EXPECT_EQ(modelOf("1 OPENCV_FISHEYE 640 480 300 300 320 240 0.1 0.2 0.3 0.4"),
              LensModel(FisheyeLens{.f_px = 300, .cx_px = 319.5, .cy_px = 239.5, .k1 = 0.1, .k2 = 0.2, .k3 = 0.3, .k4 = 0.4}));
}

TEST(LensFileFormatTest, FileOfRosIsReadThoughItHasNoHeader) {
    const auto file = lensFromOpenCvYaml(R"(image_width: 640
image_height: 480
camera_name: webcam
camera_matrix:
  rows: 3
  cols: 3
  data: [700.5, 0, 320, 0, 700.5, 240, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.2, 0.05, 0.001, -0.002, 0.01]
)");
    ASSERT_TRUE(file.has_value()) << qPrintable(file.error().sentence());
    EXPECT_EQ(std::get<BrownLens>(file->lens.model()),
              (BrownLens{.f_px = 700.5, .cx_px = 320, .cy_px = 240, .k1 = -0.2, .k2 = 0.05, .k3 = 0.01, .p1 = 0.001, .p2 = -0.002}));
}

TEST(LensFileFormatTest, PixelsThatAreNotQuiteSquareAreTakenWithANote) {
    const auto file = lensFromColmap("1 PINHOLE 1000 500 1000 1002 500 250");
    ASSERT_TRUE(file.has_value());
    EXPECT_NEAR(file->lens.focalLengthPx(), 1001.0, 1e-9);
    EXPECT_TRUE(file->note.contains(QStringLiteral("0.50 px")));
    EXPECT_THAT(lensFromColmap("1 PINHOLE 1000 500 1000 1200 500 250"), test::FailedWith(core::ErrorKind::kBadInput));
}

TEST(LensFileFormatTest, WhatIsNoLensIsRefusedWithASentence) {
    for (const char* content : {"", "1 THIN_PRISM_FISHEYE 1 1 1", "1 PINHOLE 640 480 784", "1 PINHOLE 640 480 x 1 1 1", "1 PINHOLE 640 480 nan 1 1 1"}) {
        const auto file = lensFromColmap(content);
        ASSERT_THAT(file, test::FailedWith(core::ErrorKind::kBadInput)) << content;
        EXPECT_FALSE(file.error().remedy.isEmpty());
    }
    for (const char* content : {"", "%YAML:1.0\n---\nfoo: [1, 2", "camera_matrix: 3\n", "%YAML:1.0\n---\nK: [1,2,3]\n"}) {
        EXPECT_THAT(lensFromOpenCvYaml(content), test::FailedWith(core::ErrorKind::kBadInput)) << content;
    }
}

TEST(LensFileFormatTest, TableHasNoPlaceInTheFormats) {
    const Lens table(RadialTableLens{.cx_px = 320, .cy_px = 240, .rows = {{0, 0}, {300, 0.4}}});
    EXPECT_THAT(lensToOpenCvYaml(table, 640, 480), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(lensToColmap(table, 640, 480), test::FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::camera
