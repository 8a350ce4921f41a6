#include "../../src/programs/pmts/board_command.hpp"

#include "support/board_pictures.hpp"
#include "support/child_program.hpp"
#include "support/matchers.hpp"

#include <QProcess>
#include <QTemporaryDir>
#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace pmts {
namespace {

using pmts::test::FailedWith;
using testing::HasSubstr;

constexpr double kFocal_px = 640.0;
constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;

/// Pictures of a 9x6 board as a known lens sees it, in a folder.
class BoardCommandTest : public testing::Test {
protected:
    void drawBoards(int count) const {
        const test::BoardPictures camera(camera::Lens(camera::BrownLens{.f_px = kFocal_px, .cx_px = 322, .cy_px = 238, .k1 = -0.12}), kWidth_px, kHeight_px);
        const calibration::BoardPattern pattern;
        const auto places = test::boardPlaces(pattern, kFocal_px, kWidth_px, count);
        for (std::size_t i = 0; i < places.size(); ++i) {
            save(camera.draw(pattern, places[i], 2.0, static_cast<unsigned>(i + 1)), QStringLiteral("board-%1.png").arg(i, 2, 10, QLatin1Char('0')));
        }
    }
    void save(const cv::Mat& picture, const QString& name) const { ASSERT_TRUE(cv::imwrite(folder_.filePath(name).toStdString(), picture)); }
    [[nodiscard]] core::Result<QString> calibrated(const QStringList& more = {}) const {
        return boardCalibrationFor(QStringList{QStringLiteral("--calibrate-board"), folder_.path(), QStringLiteral("--pattern"), QStringLiteral("9x6")} + more);
    }

    QTemporaryDir folder_;
};

TEST_F(BoardCommandTest, LensOfDrawnBoardsIsFoundAndWritten) {
    drawBoards(12);
    const QString file = folder_.filePath(QStringLiteral("lens.yaml"));
    const auto report = calibrated({QStringLiteral("--output"), file});

    ASSERT_TRUE(report) << report.error().sentence().toStdString();
    const double f_px = report->section(QStringLiteral("f [px] = "), 1).section(u' ', 0, 0).toDouble();
    EXPECT_NEAR(f_px, kFocal_px, 0.5) << report->toStdString();
    EXPECT_THAT(report->toStdString(), HasSubstr("10 views"));  // two of the drawn boards reach over the edge
    EXPECT_TRUE(QFile::exists(file));
}

TEST_F(BoardCommandTest, MissingFolderIsNamed) {
    const auto report = boardCalibrationFor({QStringLiteral("--calibrate-board"), QStringLiteral("/no/such/folder")});

    ASSERT_THAT(report, FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(report.error().sentence().toStdString(), HasSubstr("no folder “/no/such/folder”"));
}

TEST_F(BoardCommandTest, FolderWithoutPicturesIsSaid) {
    EXPECT_THAT(calibrated().error().sentence().toStdString(), HasSubstr("no pictures"));
}

TEST_F(BoardCommandTest, PicturesWithoutABoardAreNamedWithTheReason) {
    save(cv::Mat(kHeight_px, kWidth_px, CV_8UC3, cv::Scalar::all(128)), QStringLiteral("wall.png"));
    const std::string sentence = calibrated().error().sentence().toStdString();

    EXPECT_THAT(sentence, HasSubstr("0 views of the board"));
    EXPECT_THAT(sentence, HasSubstr("“wall.png”: The board is not in this picture."));
}

TEST_F(BoardCommandTest, TooFewViewsSayHowManyAreNeeded) {
    drawBoards(2);

    EXPECT_THAT(calibrated().error().sentence().toStdString(), HasSubstr("2 views of the board; at least"));
}

TEST_F(BoardCommandTest, PatternThatMakesNoSenseShowsHowToWriteIt) {
    EXPECT_THAT(calibrated({QStringLiteral("--pattern"), QStringLiteral("nine")}).error().sentence().toStdString(), HasSubstr("--pattern 9x6"));
}

/// The program itself: what a script sees.
TEST_F(BoardCommandTest, ProgramLeavesTwoAndASentenceOnBadInput) {
    QProcess pmts;
    pmts.start(QStringLiteral(PMTS_PROGRAM), {QStringLiteral("--calibrate-board"), folder_.path(), QStringLiteral("--pattern"), QStringLiteral("9x6")});
    test::awaitEnd(pmts);

    EXPECT_EQ(pmts.exitCode(), 2);
    EXPECT_THAT(pmts.readAllStandardError().toStdString(), HasSubstr("no pictures"));
}

}  // namespace
}  // namespace pmts
