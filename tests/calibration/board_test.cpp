#include "pmts/calibration/board_calibration.hpp"

#include "support/board_pictures.hpp"
#include "support/matchers.hpp"

#include <QTemporaryDir>
#include <opencv2/imgcodecs.hpp>

namespace pmts::calibration {
namespace {

constexpr camera::BrownLens kWebcam{.f_px = 700, .cx_px = 322.5, .cy_px = 237.0, .k1 = -0.18, .k2 = 0.06, .p1 = 8e-4, .p2 = -5e-4};
const BoardPattern kChessboard{};
const BoardPattern kCharuco{.columns = 7, .rows = 5, .square_m = 0.03, .dictionary = QStringLiteral("DICT_4X4_50")};

#ifdef __SANITIZE_THREAD__
/// OpenCV's loops run on a TBB whose locks the sanitizer does not see.
[[maybe_unused]] const bool kOneThread = (cv::setNumThreads(1), true);
#endif

const test::BoardPictures& pictures() {
    static const test::BoardPictures drawn(camera::Lens(kWebcam), 640, 480);
    return drawn;
}

std::vector<BoardView> viewsOf(const BoardPattern& pattern, int count) {
    std::vector<BoardView> views;
    unsigned seed = 1;
    for (const test::BoardPlace& place : test::boardPlaces(pattern, kWebcam.f_px, 640, count)) {
        if (auto view = findBoard(pictures().draw(pattern, place, 2.0, seed), pattern, QStringLiteral("view %1").arg(seed))) {
            views.push_back(*std::move(view));
        }
        ++seed;
    }
    return views;
}

const std::vector<BoardView>& chessboardViews() {
    static const std::vector<BoardView> views = viewsOf(kChessboard, 16);
    return views;
}

TEST(BoardTest, CornersAreFoundWhereTheLensDrewThem) {
    const test::BoardPlace place = test::boardPlaces(kChessboard, kWebcam.f_px, 640, 16)[3];
    const auto view = findBoard(pictures().draw(kChessboard, place), kChessboard);
    ASSERT_TRUE(view.has_value()) << qPrintable(view.error().sentence());
    const auto truth = pictures().corners(kChessboard, place);
    ASSERT_EQ(view->px.size(), truth.size());
    double worst_px = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        // A chessboard of 9x6 may be counted from either end.
        worst_px = std::max(worst_px, std::min((view->px[i] - truth[i]).norm(), (view->px[i] - truth[truth.size() - 1 - i]).norm()));
    }
    EXPECT_LT(worst_px, 0.25) << "noise of two grey values";
}

TEST(BoardTest, CharucoCornersKeepTheirNumbersWhenTheBoardIsCutOff) {
    test::BoardPlace place = test::boardPlaces(kCharuco, kWebcam.f_px, 640, 16)[0];
    place.shift_m.x() += 0.09;
    const auto view = findBoard(pictures().draw(kCharuco, place), kCharuco);
    ASSERT_TRUE(view.has_value()) << qPrintable(view.error().sentence());
    const auto truth = pictures().corners(kCharuco, place);
    EXPECT_LT(view->px.size(), truth.size()) << "some are outside the picture";
    for (std::size_t i = 0; i < view->px.size(); ++i) {
        const auto column = std::lround(view->board_m[i].x() / kCharuco.square_m);
        const auto row = std::lround(view->board_m[i].y() / kCharuco.square_m);
        EXPECT_LT((view->px[i] - truth[static_cast<std::size_t>(row * kCharuco.columns + column)]).norm(), 0.3);
    }
}

TEST(BoardTest, LensIsFoundAgainAndOpenCvAgrees) {
    ASSERT_GE(chessboardViews().size(), 12U);
    const auto result = calibrateBoard(chessboardViews());
    ASSERT_TRUE(result.has_value()) << qPrintable(result.error().sentence());
    EXPECT_NEAR(result->lens.focalLengthPx(), kWebcam.f_px, 0.0015 * kWebcam.f_px);
    EXPECT_LT((result->lens.principalPoint() - Eigen::Vector2d(kWebcam.cx_px, kWebcam.cy_px)).norm(), 1.0);
    EXPECT_LT(result->rms_px, 0.1);
    EXPECT_NEAR(result->rms_px / result->opencv_rms_px, 1.0, 0.05);
    EXPECT_NEAR(result->lens.focalLengthPx(), result->opencv_lens.focalLengthPx(), 0.5);
    EXPECT_EQ(result->views.size(), chessboardViews().size());
    const auto& f = result->parameters.front();
    ASSERT_TRUE(f.standard_deviation.has_value());
    EXPECT_LT(std::abs(f.value - kWebcam.f_px), 5 * *f.standard_deviation + 0.3);
}

TEST(BoardTest, CharucoViewsCalibrateToo) {
    const auto result = calibrateBoard(viewsOf(kCharuco, 14));
    ASSERT_TRUE(result.has_value()) << qPrintable(result.error().sentence());
    EXPECT_NEAR(result->lens.focalLengthPx(), kWebcam.f_px, 0.004 * kWebcam.f_px);
}

TEST(BoardTest, ViewThatDoesNotFitIsRefusedWithItsReason) {
    std::vector<BoardView> views = chessboardViews();
    for (std::size_t i = 0; i < views[2].px.size(); i += 2) {
        views[2].px[i] += Eigen::Vector2d(4, -3);  // the board was bent
    }
    const auto result = calibrateBoard(views);
    ASSERT_TRUE(result.has_value());
    ASSERT_EQ(result->refused.size(), 1U);
    EXPECT_EQ(result->refused[0].name, views[2].name);
    EXPECT_FALSE(result->refused[0].reason.isEmpty());
    EXPECT_LT(result->rms_px, 0.1);
}

TEST(BoardTest, BoardsThatAllStandAlikeLeaveTheFocalLengthOpenAndAreSaidSo) {
    std::vector<BoardView> views;
    for (int i = 0; i < 5; ++i) {
        test::BoardPlace place;  // square to the axis, moved sideways only
        place.shift_m = {-0.1 + 0.003 * i, -0.06, 0.4};
        views.push_back(findBoard(pictures().draw(kChessboard, place, 2.0, static_cast<unsigned>(i)), kChessboard).value());
    }
    const auto result = calibrateBoard(views);
    EXPECT_TRUE(!result || !result->warnings.isEmpty());
}

TEST(BoardTest, BlurredAndEmptyPicturesAreRefusedWithASentence) {
    cv::Mat blurred = pictures().draw(kChessboard, test::boardPlaces(kChessboard, kWebcam.f_px, 640, 16)[3]);
    cv::GaussianBlur(blurred, blurred, {}, 7.0);
    EXPECT_FALSE(findBoard(blurred, kChessboard).has_value());
    const auto nothing = findBoard(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)), kChessboard);
    ASSERT_THAT(nothing, test::FailedWith(core::ErrorKind::kUndefined));
    EXPECT_FALSE(nothing.error().remedy.isEmpty());
    EXPECT_FALSE(findBoard(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)), kCharuco).has_value());
}

TEST(BoardTest, PatternsThatCannotBeAreRefused) {
    EXPECT_THAT(usablePattern({.columns = 2, .rows = 6}), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(usablePattern({.columns = 6, .rows = 6}), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(usablePattern({.columns = 9, .rows = 6, .square_m = 0.02, .dictionary = QStringLiteral("DICT_9X9")}), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(usablePattern({.columns = 19, .rows = 16, .square_m = 0.02, .dictionary = QStringLiteral("DICT_4X4_50")}), test::FailedWith(core::ErrorKind::kBadInput));
}

TEST(BoardTest, SecondViewFromTheSamePlaceIsNotNew) {
    const auto& views = chessboardViews();
    EXPECT_FALSE(isNewView(views[0], {views[0]}));
    EXPECT_TRUE(isNewView(views[0], {views[1], views[4]}));
    EXPECT_TRUE(isNewView(views[0], {}));
}

TEST(BoardTest, FolderOfPicturesIsCalibratedAndTheOthersAreNamed) {
    const QTemporaryDir folder;
    const auto places = test::boardPlaces(kChessboard, kWebcam.f_px, 640, 8);
    for (std::size_t i = 0; i < places.size(); ++i) {
        cv::imwrite(folder.filePath(QStringLiteral("v%1.png").arg(i)).toStdString(), pictures().draw(kChessboard, places[i]));
    }
    cv::imwrite(folder.filePath(QStringLiteral("wall.png")).toStdString(), cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)));
    const auto result = calibrateBoardFolder(folder.path(), kChessboard);
    ASSERT_TRUE(result.has_value()) << qPrintable(result.error().sentence());
    ASSERT_FALSE(result->refused.empty());
    EXPECT_EQ(result->refused.back().name, QStringLiteral("wall.png"));
    EXPECT_TRUE(boardCalibrationText(*result).contains(QStringLiteral("f [px]")));
    EXPECT_THAT(calibrateBoardFolder(QStringLiteral("/nowhere"), kChessboard), test::FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::calibration
