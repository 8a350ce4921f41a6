#include "pmts/camera/picture_meters.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <numeric>

namespace pmts::camera {
namespace {

/// Fields of 20 px in two greys.
cv::Mat board(double blur_px = 0.0, double gain = 1.0) {
    cv::Mat picture(480, 640, CV_8UC3);
    for (int row = 0; row < picture.rows; ++row) {
        for (int col = 0; col < picture.cols; ++col) {
            picture.at<cv::Vec3b>(row, col) = (row / 20 + col / 20) % 2 == 0 ? cv::Vec3b(60, 60, 60) : cv::Vec3b(160, 160, 160);
        }
    }
    if (blur_px > 0.0) {
        cv::GaussianBlur(picture, picture, {}, blur_px);
    }
    picture.convertTo(picture, -1, gain);
    return picture;
}

TEST(PictureMetersTest, HistogramCountsEveryLevelOnceAndSumsToOne) {
    const PictureMeters meters = measurePicture(board());
    EXPECT_NEAR(std::accumulate(meters.luma.begin(), meters.luma.end(), 0.0), 1.0, 1e-4);
    EXPECT_NEAR(meters.luma[60] + meters.luma[160], 1.0, 1e-6);
    EXPECT_NEAR(meters.red[160], 0.5, 0.01);
    EXPECT_NEAR(meters.mean_luma, 110.0, 1.0);
}

TEST(PictureMetersTest, ColoursAreNotMixedUp) {
    const PictureMeters meters = measurePicture(cv::Mat(64, 64, CV_8UC3, cv::Scalar(10, 20, 30)));  // B G R
    EXPECT_EQ(meters.blue[10], 1.0F);
    EXPECT_EQ(meters.green[20], 1.0F);
    EXPECT_EQ(meters.red[30], 1.0F);
}

TEST(PictureMetersTest, BurntAndBlackSharesAreThoseOfThePicture) {
    cv::Mat picture(100, 200, CV_8UC3, cv::Scalar::all(128));
    picture(cv::Rect(0, 0, 20, 100)) = cv::Scalar(255, 200, 90);  // a tenth; one channel is enough
    picture(cv::Rect(100, 0, 40, 100)) = cv::Scalar::all(0);      // a fifth
    const PictureMeters meters = measurePicture(picture);
    EXPECT_NEAR(meters.burnt_share, 0.10, 1e-9);
    EXPECT_NEAR(meters.black_share, 0.20, 1e-9);
    EXPECT_EQ(cv::countNonZero(burntMask(picture)), 20 * 100);
}

TEST(PictureMetersTest, SharpnessFallsWithEveryStepOutOfFocus) {
    double before = measurePicture(board()).sharpness;
    for (const double blur_px : {0.7, 1.5, 3.0, 6.0}) {
        const double now = measurePicture(board(blur_px)).sharpness;
        EXPECT_LT(now, before) << blur_px;
        before = now;
    }
}

TEST(PictureMetersTest, SharpnessDoesNotFollowTheExposure) {
    const double usual = measurePicture(board(1.0)).sharpness;
    EXPECT_NEAR(measurePicture(board(1.0, 0.5)).sharpness, usual, 0.03 * usual);  // rounding of half the grey values
}

TEST(PictureMetersTest, BoxIsMeasuredByItself) {
    const auto sharp = measurePicture(board(), cv::Rect(100, 100, 80, 80));
    const auto soft = measurePicture(board(4.0), cv::Rect(100, 100, 80, 80));
    ASSERT_TRUE(sharp.box_sharpness && soft.box_sharpness);
    EXPECT_GT(*sharp.box_sharpness, 2.0 * *soft.box_sharpness);
    EXPECT_FALSE(measurePicture(board(), cv::Rect(700, 10, 50, 50)).box_sharpness) << "outside the picture";
}

TEST(PictureMetersTest, PlainAndEmptyPicturesHaveNoSharpness) {
    EXPECT_EQ(measurePicture(cv::Mat(64, 64, CV_8UC3, cv::Scalar::all(90))).sharpness, 0.0);
    EXPECT_EQ(measurePicture(cv::Mat()).sharpness, 0.0);
}

}  // namespace
}  // namespace pmts::camera
