#include "lab/board_step.hpp"
#include "lab/calibration_pdf.hpp"
#include "lab/check_step.hpp"
#include "lab/filter_popup.hpp"
#include "lab_fixture.hpp"
#include "lab/profiles_step.hpp"
#include "lab/rig_limits_dialog.hpp"
#include "lab/self_calibration_step.hpp"
#include "parts/state_lamp.hpp"

#include "pmts/app/lab/calibration_report.hpp"
#include "pmts/calibration/board.hpp"
#include "pmts/gui/theme.hpp"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>

namespace pmts::gui {
namespace {

class LabCareTest : public test::LabFixture {
protected:
    [[nodiscard]] QByteArray written(const char* name) const {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
};

TEST_F(LabCareTest, DuplicatedProfileAppearsInTheListAndCanBeDeleted) {
    auto* const panel = step<ProfilesStep>();
    auto* const list = child<QTableWidget>(panel, "profile_list");
    const int before = list->rowCount();
    child<QPushButton>(panel, "profile_copy")->click();
    ASSERT_EQ(list->rowCount(), before + 1);

    bench->profiles.remove(list->item(before - 1, 0)->text());

    EXPECT_EQ(list->rowCount(), before);
}

TEST_F(LabCareTest, LimitsAreEditedAndKept) {
    RigLimitsDialog dialog(bench->profiles.limits());
    EXPECT_EQ(child<QDoubleSpinBox>(&dialog, "limit_age")->value(), 30);
    child<QDoubleSpinBox>(&dialog, "limit_age")->setValue(7);
    child<QDoubleSpinBox>(&dialog, "limit_check_mgon")->setValue(25);
    bench->profiles.setLimits(dialog.care());

    EXPECT_EQ(bench->preferences.settings().rig_care.age_limit_days, 7);
    EXPECT_NEAR(bench->preferences.settings().rig_care.check_limit.gon(), 0.025, 1e-9);
    EXPECT_EQ(bench->preferences.settings().rig_care.board, calibration::BoardPattern{});
}

TEST_F(LabCareTest, CheckAsksForAMeasuredSpotFirst) {
    auto* const panel = step<CheckStep>();
    EXPECT_FALSE(child<QPushButton>(panel, "check_run")->isEnabled());
    child<QPushButton>(panel, "check_telescope")->click();

    EXPECT_THAT(child<QLabel>(panel, "check_sentence")->text().toStdString(), testing::HasSubstr("measure its distance"));
}

TEST_F(LabCareTest, ChoicesOfThePanelsHaveRowsForGloves) {
    window->show();
    for (const auto* const choice : window->findChildren<QComboBox*>()) {
        if (choice->count() > 0) {
            EXPECT_GE(choice->view()->sizeHintForRow(0), 40) << choice->objectName().toStdString();
        }
    }
}

TEST_F(LabCareTest, SpotWithoutAPictureIsRefusedWithTheReason) {
    auto* const panel = step<SelfCalibrationStep>();
    panel->pictureClicked({300, 200});

    EXPECT_THAT(child<QLabel>(panel, "self_message")->text().toStdString(), testing::HasSubstr("no picture"));
    EXPECT_FALSE(child<QPushButton>(panel, "self_calibrate")->isEnabled());
}

TEST_F(LabCareTest, BoardStepSaysThatItLooks) {
    auto* const panel = step<BoardStep>();
    EXPECT_FALSE(child<QPushButton>(panel, "board_calibrate")->isEnabled());
    child<QPushButton>(panel, "board_look")->click();
    EXPECT_THAT(child<QLabel>(panel, "board_sentence")->text().toStdString(), testing::HasSubstr("hold it still"));

    panel->left();

    EXPECT_FALSE(bench->board.isLooking());
}

TEST_F(LabCareTest, FiltersWaitForAStill) {
    const FilterPopup popup(bench->live, bench->still_filters);

    EXPECT_FALSE(child<QSlider>(&popup, "filter_sharp")->isEnabled());
    EXPECT_THAT(child<QLabel>(&popup, "filter_said")->text().toStdString(), testing::HasSubstr("Take a still"));
}

TEST_F(LabCareTest, ReportAndBoardAreWrittenAsPdf) {
    const auto report = app::calibrationReport(bench->profiles.inUse().profile, bench->preferences.units());
    ASSERT_TRUE(writeCalibrationPdf(report, folder.filePath(QStringLiteral("report.pdf"))));
    EXPECT_TRUE(written("report.pdf").startsWith("%PDF"));

    const auto sheet = bench->board.sheet();
    ASSERT_TRUE(sheet);
    ASSERT_TRUE(writeBoardPdf(sheet->cells, sheet->cell_mm, sheet->caption, folder.filePath(QStringLiteral("board.pdf"))));
    EXPECT_TRUE(written("board.pdf").startsWith("%PDF"));
    EXPECT_FALSE(writeCalibrationPdf(report, folder.filePath(QStringLiteral("missing/report.pdf"))));
}

TEST_F(LabCareTest, BusyLampIsSeenInTheChosenRow) {
    const QImage chosen = lampIcon(app::DeviceState::kBusy).pixmap(QSize(20, 20), QIcon::Selected).toImage();

    EXPECT_EQ(chosen.pixelColor(10, 10), currentTheme().window);
}

}  // namespace
}  // namespace pmts::gui
