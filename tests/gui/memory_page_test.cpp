#include "line/memory_page.hpp"

#include "line/axis_limits_dialog.hpp"
#include "bench_fixture.hpp"
#include "line/line_workspace.hpp"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

namespace pmts::gui {
namespace {

class MemoryPageTest : public test::WindowFixture {
protected:
    MemoryPageTest() : page(*window->findChild<MemoryPage*>()) {}

    template <class Widget>
    Widget& find(const char* name) {
        return *page.findChild<Widget*>(QLatin1String(name));
    }

    MemoryPage& page;
};

TEST_F(MemoryPageTest, WithoutAnInstrumentOnlyFilesOfTheComputerAreOffered) {
    EXPECT_FALSE(find<QPushButton>("memory_list").isEnabled());
    EXPECT_FALSE(find<QPushButton>("memory_read").isEnabled());
    EXPECT_FALSE(find<QPushButton>("backup_read").isEnabled());
    EXPECT_TRUE(find<QPushButton>("memory_open").isEnabled());
    EXPECT_EQ(find<QLabel>("memory_room").text(), QStringLiteral("No instrument is connected."));
}

TEST_F(MemoryPageTest, AnOpenedFileShowsItsLinesAndTheVerdictOnItsPoints) {
    bench->memory.openFile(QStringLiteral(PMTS_TEST_DATA "/DEMO1.JOB"));
    const auto& lines = *find<QTableView>("memory_lines").model();
    ASSERT_EQ(lines.rowCount(), 31);
    EXPECT_EQ(lines.index(14, 3).data().toString(), QStringLiteral("WALL"));
    EXPECT_EQ(lines.index(14, 2).data().toString(), QStringLiteral("point code"));
    EXPECT_TRUE(find<QLabel>("memory_verdict").text().contains(QLatin1String("within 1 mm")));
    EXPECT_TRUE(find<QPushButton>("memory_save").isEnabled());
    EXPECT_FALSE(find<QPushButton>("memory_send").isEnabled()) << "no instrument";
}

TEST_F(MemoryPageTest, EveryButtonServesAGlovedFinger) {
    for (const auto* const name : {"memory_page", "instrument_page"}) {
        for (const auto* const button : window->findChild<ListedPage*>(QLatin1String(name))->findChildren<QPushButton*>()) {
            EXPECT_GE(button->minimumHeight(), 44) << button->text().toStdString();
        }
    }
}

TEST_F(MemoryPageTest, TheInstrumentPageSaysWhatIsNotKnown) {
    auto& instrument_page = *window->findChild<ListedPage*>(QStringLiteral("instrument_page"));
    EXPECT_FALSE(instrument_page.findChild<QPushButton*>(QStringLiteral("compensator_calibrate"))->isEnabled());
    EXPECT_TRUE(instrument_page.findChild<QLabel*>(QStringLiteral("axis_kept"))->text().contains(QLatin1String("No test")));
    EXPECT_FALSE(instrument_page.findChild<QPushButton*>(QStringLiteral("axis_accept"))->isEnabled());
    EXPECT_FALSE(instrument_page.findChild<QPushButton*>(QStringLiteral("two_face_record"))->isEnabled());
}

TEST_F(MemoryPageTest, LimitsOfAxesAndFacesAreEditedAndKept) {
    AxisLimitsDialog dialog(bench->axis_test.care());
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("limit_axis"))->setValue(12.5);
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("limit_face_distance"))->setValue(3);
    bench->axis_test.setCare(dialog.care());
    EXPECT_NEAR(bench->preferences.settings().instrument_care.axis_limit.mgon(), 12.5, 1e-9);
    EXPECT_NEAR(bench->preferences.settings().instrument_care.face_limit_m, 0.003, 1e-12);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
    EXPECT_NEAR(dialog.care().axis_limit.mgon(), app::InstrumentCareSettings{}.axis_limit.mgon(), 1e-9);
}

}  // namespace
}  // namespace pmts::gui
