#include "pmts/camera/image_filters.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace pmts::camera {
namespace {

/// A wall in the shadow and in the sun: a dull pattern in both halves.
cv::Mat dullWall() {
    cv::Mat picture(240, 320, CV_8UC3);
    for (int v = 0; v < picture.rows; ++v) {
        for (int u = 0; u < picture.cols; ++u) {
            const int grey = (u < 160 ? 40 : 180) + ((u / 10 + v / 10) % 2 == 0 ? 12 : 0);
            picture.at<cv::Vec3b>(v, u) = cv::Vec3b::all(static_cast<uchar>(grey));
        }
    }
    return picture;
}

/// White left of column 160, black from there on.
cv::Mat step() {
    cv::Mat picture(240, 320, CV_8UC3, cv::Scalar::all(220));
    picture.colRange(160, 320).setTo(cv::Scalar::all(40));
    return picture;
}

double lightness(const cv::Mat& bgr) {
    cv::Mat lab;
    cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
    return cv::mean(lab)[0];
}

double spread(const cv::Mat& bgr) {
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(bgr, mean, deviation);
    return deviation[1];
}

TEST(ImageFiltersTest, SmoothSpreadsTheContrastAndKeepsTheMeanLightness) {
    const cv::Mat balanced = smoothed(dullWall(), 1.0);
    EXPECT_NEAR(lightness(balanced), lightness(dullWall()), 1.5);
    const cv::Rect shadow(20, 20, 100, 200);
    EXPECT_GT(spread(balanced(shadow)), 1.4 * spread(dullWall()(shadow)));
}

TEST(ImageFiltersTest, SharpMakesAnEdgeSteeperAndLeavesPlainAreas) {
    cv::Mat soft;
    cv::GaussianBlur(step(), soft, {}, 2.0);
    const cv::Mat sharp = sharpened(soft, 1.0);
    const auto slope = [](const cv::Mat& m) { return m.at<cv::Vec3b>(120, 158)[0] - m.at<cv::Vec3b>(120, 161)[0]; };
    EXPECT_GT(slope(sharp), 1.3 * slope(soft));
    EXPECT_EQ(sharp.at<cv::Vec3b>(120, 40), soft.at<cv::Vec3b>(120, 40));
}

TEST(ImageFiltersTest, EdgesAreDarkWhereTheEdgeIsAndWhiteElsewhere) {
    const cv::Mat edges = edgesOf(step(), 1.0);
    cv::Point darkest;
    cv::Mat grey;
    cv::cvtColor(edges, grey, cv::COLOR_BGR2GRAY);
    cv::minMaxLoc(grey.row(120), nullptr, nullptr, &darkest);
    EXPECT_NEAR(darkest.x, 159.5, 1.0);
    EXPECT_LT(grey.at<uchar>(120, darkest.x), 60);
    EXPECT_EQ(grey.at<uchar>(120, 40), 255);
    EXPECT_EQ(grey.at<uchar>(120, 280), 255);
}

TEST(ImageFiltersTest, OneBandIsShownAloneAndGainsActOnTheirBandOnly) {
    const cv::Mat picture(20, 20, CV_8UC3, cv::Scalar(30, 60, 90));  // blue, green, red
    ImageFilter red;
    red.single_band = true;
    EXPECT_EQ(bandsOf(picture, red).at<cv::Vec3b>(5, 5), cv::Vec3b(90, 90, 90));
    red.band = 2;
    EXPECT_EQ(bandsOf(picture, red).at<cv::Vec3b>(5, 5), cv::Vec3b(30, 30, 30));
    EXPECT_EQ(bandsOf(picture, {.red = 0.0, .green = 2.0}).at<cv::Vec3b>(5, 5), cv::Vec3b(30, 120, 0));
}

TEST(ImageFiltersTest, OriginalIsNeverWrittenTo) {
    const cv::Mat original = dullWall();
    const cv::Mat before = original.clone();
    const cv::Mat changed = filtered(original, {.smooth = 0.7, .sharp = 0.5, .edges = 0.3, .red = 1.4});
    EXPECT_EQ(cv::norm(original, before, cv::NORM_INF), 0.0);
    EXPECT_GT(cv::norm(changed, before, cv::NORM_INF), 0.0);
    EXPECT_EQ(filtered(original, {}).data, original.data) << "no filter, no copy";
}

}  // namespace
}  // namespace pmts::camera
