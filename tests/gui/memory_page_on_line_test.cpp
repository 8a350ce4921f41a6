#include "line/memory_page.hpp"

#include "app/field_fixture.hpp"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// The page with the simulated instrument behind it, in virtual time.
class MemoryPageOnLineTest : public app::FieldTest {
protected:
    template <class Widget>
    Widget& find(const char* name) {
        return *page.findChild<Widget*>(QLatin1String(name));
    }
    void click(const char* name) {
        auto& button = find<QPushButton>(name);
        ASSERT_TRUE(button.isEnabled()) << name;
        button.click();
    }
    bool idle() {
        return until([this] { return !memory.transfer().busy && !backup.transfer().busy; }, 10min);
    }
    void startSending(const QString& name) {
        memory.openFile(QStringLiteral(PMTS_TEST_DATA "/DEMO1.JOB"));
        click("memory_send");
        auto* const dialog = page.findChild<QDialog*>();
        ASSERT_NE(dialog, nullptr);
        dialog->findChild<QLineEdit*>()->setText(name);
        ASSERT_TRUE(dialog->findChild<QPushButton*>()->isEnabled());
        dialog->accept();
        ASSERT_TRUE(memory.transfer().busy);
    }
    [[nodiscard]] QStringList fates() {
        const auto& lines = *find<QTableView>("memory_lines").model();
        QStringList all;
        for (int row = 0; row < lines.rowCount(); ++row) {
            all << lines.index(row, lines.columnCount() - 1).data().toString();
        }
        all.removeDuplicates();
        return all;
    }

    app::MemoryPresenter memory{instrument, planned, messages};
    app::LabelBackupPresenter backup{instrument, messages};
    MemoryPage page{memory, backup};
};

TEST_F(MemoryPageOnLineTest, AFileIsSentListedAndReadBackByClicks) {
    connectInstrument();
    startSending(QStringLiteral("WALLS"));
    EXPECT_FALSE(find<QPushButton>("memory_list").isEnabled());
    ASSERT_TRUE(idle());
    EXPECT_EQ(fates(), QStringList(QStringLiteral("in the instrument")));

    click("memory_list");
    ASSERT_TRUE(idle());
    EXPECT_THAT(find<QLabel>("memory_room").text().toStdString(), HasSubstr("bytes are free"));
    auto& files = find<QTableWidget>("memory_files");
    const auto found = files.findItems(QStringLiteral("WALLS"), Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1);
    EXPECT_FALSE(find<QPushButton>("memory_read").isEnabled()) << "nothing is chosen";
    files.selectRow(found.front()->row());
    click("memory_read");
    ASSERT_TRUE(idle());
    EXPECT_EQ(find<QTableView>("memory_lines").model()->rowCount(), 31);
    EXPECT_THAT(find<QLabel>("memory_heading").text().toStdString(), HasSubstr("read twice and the same"));
}

TEST_F(MemoryPageOnLineTest, CancelOfAnUploadSaysWhatTheInstrumentHolds) {
    connectInstrument();
    startSending(QStringLiteral("HALF"));
    ASSERT_TRUE(until([this] { return memory.transfer().text.contains(QLatin1String("Sending: line 5")); }));
    click("memory_cancel");
    ASSERT_TRUE(idle());
    EXPECT_THAT(app::newestBar(messages).toStdString(), HasSubstr("may hold Job HALF"));
    EXPECT_EQ(fates(), (QStringList{QStringLiteral("sent"), QStringLiteral("not sent")}));
    EXPECT_TRUE(find<QPushButton>("memory_send").isEnabled());
}

TEST_F(MemoryPageOnLineTest, TheBackupIsReadByAClickAndComparedWithAnEarlierOne) {
    connectInstrument();
    click("backup_read");
    EXPECT_FALSE(find<QPushButton>("backup_read").isEnabled());
    ASSERT_TRUE(idle());
    EXPECT_GT(find<QTableWidget>("backup_table").rowCount(), 100);
    const QString path = folder.filePath(backup.proposedFileName());
    backup.saveFile(path);
    instrument.writeLabel(20, QStringLiteral("0.035"));
    click("backup_read");
    ASSERT_TRUE(idle());
    backup.compareWith(path);
    EXPECT_THAT(find<QLabel>("backup_comparison").text().toStdString(), HasSubstr("settings changed: 1"));
    EXPECT_EQ(find<QTableWidget>("backup_table").item(0, 2)->text(), QStringLiteral("0.035"));
}

TEST_F(MemoryPageOnLineTest, TransfersAndTheBackupExcludeOneAnother) {
    connectInstrument();
    memory.openFile(QStringLiteral(PMTS_TEST_DATA "/DEMO1.JOB"));
    click("backup_read");
    for (const auto* const name : {"memory_list", "memory_send"}) {
        EXPECT_FALSE(find<QPushButton>(name).isEnabled()) << name;
    }
    click("backup_cancel");
    ASSERT_TRUE(idle());
    EXPECT_TRUE(find<QPushButton>("memory_send").isEnabled());
    click("memory_list");
    EXPECT_FALSE(find<QPushButton>("backup_read").isEnabled());
    ASSERT_TRUE(idle());
    EXPECT_TRUE(find<QPushButton>("backup_read").isEnabled());
}

}  // namespace
}  // namespace pmts::gui
