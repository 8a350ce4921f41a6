#include "memory_page.hpp"

#include "bench_fixture.hpp"
#include "line_workspace.hpp"

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

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
    auto& lines = find<QTableWidget>("memory_lines");
    ASSERT_EQ(lines.rowCount(), 31);
    EXPECT_EQ(lines.item(14, 3)->text(), QStringLiteral("WALL"));
    EXPECT_EQ(lines.item(14, 2)->text(), QStringLiteral("point code"));
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

}  // namespace
}  // namespace pmts::gui
