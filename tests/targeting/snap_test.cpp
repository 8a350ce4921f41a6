#include "pmts/targeting/snap.hpp"

#include "targeting/pictures.hpp"

namespace pmts::targeting {
namespace {

using Eigen::Vector2d;
using test::seenBy;

constexpr int kFine = 16;  // pictures are drawn this much finer and averaged: true to a part of a pixel

/// A picture of 240 x 180 in which `draw` puts shapes on a finer raster.
template <class Draw>
cv::Mat drawn(Draw draw, double noise_grey = 2.0) {
    cv::Mat fine(180 * kFine, 240 * kFine, CV_8UC3, cv::Scalar::all(190));
    draw(fine);
    cv::Mat picture;
    cv::resize(fine, picture, {240, 180}, 0, 0, cv::INTER_AREA);
    return seenBy(picture, 1, 0, 0.6, noise_grey, 5);
}

/// Of a pixel (centre of the top-left one is 0, 0) on the fine raster.
cv::Point fine(double x, double y) {
    return {cvRound((x + 0.5) * kFine - 0.5), cvRound((y + 0.5) * kFine - 0.5)};
}

void expectSnap(const cv::Mat& picture, const Vector2d& cursor, SnapKind kind, const Vector2d& truth,
                double within_px) {
    const auto snap = snapped(picture, cursor);
    ASSERT_TRUE(snap.has_value());
    EXPECT_EQ(snap->kind, kind);
    EXPECT_LE((snap->px - truth).norm(), within_px) << snap->px.transpose();
    EXPECT_GE(snap->confidence, 0.5);
    EXPECT_LE(snap->confidence, 1.0);
}

TEST(SnapTest, ClickNearAWindowCornerTakesTheCorner) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::rectangle(m, fine(80.3, 60.6), fine(170, 150), cv::Scalar::all(50), cv::FILLED);
    });
    expectSnap(picture, {84, 56}, SnapKind::kCorner, {80.3, 60.6}, 0.25);
}

TEST(SnapTest, ChessboardCrossingIsFoundWithinATenthOfAPixel) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::rectangle(m, fine(60, 40), fine(110.4, 90.7), cv::Scalar::all(40), cv::FILLED);
        cv::rectangle(m, fine(110.4, 90.7), fine(160, 140), cv::Scalar::all(40), cv::FILLED);
    });
    expectSnap(picture, {114, 86}, SnapKind::kCrossing, {110.4, 90.7}, 0.1);
}

TEST(SnapTest, FieldOfASmallChessboardIsNoCircle) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::rectangle(m, fine(93.4, 63.7), fine(110.4, 80.7), cv::Scalar::all(250), cv::FILLED);
        cv::rectangle(m, fine(95.4, 65.7), fine(101.9, 72.2), cv::Scalar::all(40), cv::FILLED);
        cv::rectangle(m, fine(101.9, 72.2), fine(108.4, 78.7), cv::Scalar::all(40), cv::FILLED);
    });
    expectSnap(picture, {104, 70}, SnapKind::kCrossing, {101.9, 72.2}, 0.2);
    expectSnap(picture, {99, 70}, SnapKind::kCrossing, {101.9, 72.2}, 0.2);  // from inside a field
}

TEST(SnapTest, CrossingOfAMarkOfNinePixelsIsFound) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        m = cv::Scalar::all(110);
        cv::rectangle(m, fine(97.4, 67.7), fine(106.4, 76.7), cv::Scalar::all(235), cv::FILLED);
        cv::rectangle(m, fine(97.4, 67.7), fine(101.9, 72.2), cv::Scalar::all(25), cv::FILLED);
        cv::rectangle(m, fine(101.9, 72.2), fine(106.4, 76.7), cv::Scalar::all(25), cv::FILLED);
    });
    expectSnap(picture, {105, 69}, SnapKind::kCrossing, {101.9, 72.2}, 0.2);
}

TEST(SnapTest, CrossingOfAMarkComesBeforeItsOuterCorners) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        m = cv::Scalar::all(110);
        cv::rectangle(m, fine(94.4, 64.7), fine(109.4, 79.7), cv::Scalar::all(235), cv::FILLED);
        cv::rectangle(m, fine(94.4, 64.7), fine(101.9, 72.2), cv::Scalar::all(25), cv::FILLED);
        cv::rectangle(m, fine(101.9, 72.2), fine(109.4, 79.7), cv::Scalar::all(25), cv::FILLED);
    });
    expectSnap(picture, {105.5, 68.5}, SnapKind::kCrossing, {101.9, 72.2}, 0.2);  // as far from the corner at the top
}

TEST(SnapTest, CrossingOfThinLinesIsFoundBetweenTheirEdges) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::line(m, fine(60, 81.2), fine(180, 101.2), cv::Scalar::all(40), 2 * kFine, cv::LINE_8);
        cv::line(m, fine(130, 30), fine(110, 150), cv::Scalar::all(40), 2 * kFine, cv::LINE_8);
    });
    // y = 81.2 + (x - 60) / 6 and x = 130 - (y - 30) / 6.
    const double y = (81.2 + (130 + 30.0 / 6 - 60) / 6) / (1 + 1.0 / 36);
    expectSnap(picture, {124, 88}, SnapKind::kCrossing, {130 - (y - 30) / 6, y}, 0.2);
}

TEST(SnapTest, RoundMarkGivesItsCentreWithinATenthOfAPixel) {
    for (const double radius_px : {4.0, 11.0, 40.0}) {
        const cv::Mat picture = drawn([radius_px](cv::Mat& m) {
            cv::circle(m, fine(120.37, 90.81), cvRound(radius_px * kFine), cv::Scalar::all(60), cv::FILLED);
        });
        expectSnap(picture, {124, 94}, SnapKind::kCircle, {120.37, 90.81}, 0.1);
        EXPECT_NEAR(snapped(picture, {124, 94})->half_axes_px.x(), radius_px, 0.5);
    }
}

TEST(SnapTest, RoundMarkSeenAskewGivesTheCentreAndAxesOfItsEllipse) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::ellipse(m, fine(120.6, 88.2), {22 * kFine, 12 * kFine}, 30, 0, 360, cv::Scalar::all(250),
                    cv::FILLED);
    });
    expectSnap(picture, {126, 84}, SnapKind::kEllipse, {120.6, 88.2}, 0.1);
    const auto snap = snapped(picture, {126, 84});
    EXPECT_NEAR(snap->half_axes_px.x(), 22, 0.5);
    EXPECT_NEAR(snap->half_axes_px.y(), 12, 0.5);
    EXPECT_NEAR(snap->axis_angle_rad, CV_PI / 6, 0.05);
}

TEST(SnapTest, NothingNearMeansTheClickStays) {
    const cv::Mat plain = seenBy(cv::Mat(180, 240, CV_8UC3, cv::Scalar::all(180)), 1, 0, 0, 3.0, 6);
    EXPECT_FALSE(snapped(plain, {120, 90}).has_value());
    const cv::Mat corner_far_off = drawn([](cv::Mat& m) {
        cv::rectangle(m, fine(150, 120), fine(220, 170), cv::Scalar::all(50), cv::FILLED);
    });
    EXPECT_FALSE(snapped(corner_far_off, {120, 90}).has_value());
}

TEST(SnapTest, StraightEdgeIsNoCorner) {
    const cv::Mat picture = drawn([](cv::Mat& m) {
        cv::rectangle(m, fine(-10, -10), fine(118.3, 300), cv::Scalar::all(50), cv::FILLED);
    });
    EXPECT_FALSE(snapped(picture, {120, 90}).has_value());
}

TEST(SnapTest, NearestOfSeveralCandidatesComesFirst) {
    const cv::Mat picture = drawn(
        [](cv::Mat& m) { cv::rectangle(m, fine(100, 80), fine(120, 100), cv::Scalar::all(50), cv::FILLED); });
    SnapSettings wide;
    wide.radius_px = 40;
    const auto candidates = snapCandidates(picture, {117, 97}, wide);
    ASSERT_GE(candidates.size(), 4U);
    EXPECT_LE((candidates.front().px - Vector2d(120, 100)).norm(), 0.7);
}

TEST(SnapTest, WindowAtTheEdgeOfThePictureIsCutOff) {
    const cv::Mat picture =
        drawn([](cv::Mat& m) { cv::circle(m, fine(20, 20), 8 * kFine, cv::Scalar::all(60), cv::FILLED); });
    expectSnap(picture, {18, 22}, SnapKind::kCircle, {20, 20}, 0.1);
    EXPECT_TRUE(snapCandidates(picture, {-500, 20}).empty());
    EXPECT_TRUE(snapCandidates(picture, {1e4, 1e4}).empty());
}

}  // namespace
}  // namespace pmts::targeting
