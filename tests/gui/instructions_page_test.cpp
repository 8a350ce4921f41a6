#include "instructions_page.hpp"

#include "bench_fixture.hpp"
#include "line_workspace.hpp"
#include "table_editor.hpp"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

namespace pmts::gui {
namespace {

class InstructionsPageTest : public test::WindowFixture {
protected:
    InstructionsPageTest() {
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
        QTest::keyClick(&*window, Qt::Key_5, Qt::ControlModifier);
        window->findChild<LineWorkspace*>()->openPage(QStringLiteral("instructions_page"));
    }
    template <class Widget>
    Widget& part(const char* name) {
        auto* const found = window->findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    TableEditor& editor() { return part<TableEditor>("instructions_text"); }
};

TEST_F(InstructionsPageTest, ShowsTheShippedRoutinesAndWhereTheyComeFrom) {
    EXPECT_EQ(part<QListWidget>("instructions_routines").count(), 2);
    EXPECT_TRUE(part<QLabel>("instructions_note").text().contains(QStringLiteral("unverified on hardware")));
    EXPECT_FALSE(part<QListWidget>("instructions_problems").isVisible());
    EXPECT_FALSE(part<QPushButton>("instructions_run").isEnabled());
    EXPECT_TRUE(part<QPushButton>("instructions_dry_run").isEnabled());
}

TEST_F(InstructionsPageTest, AClickOnAProblemJumpsToItsLine) {
    editor().setPlainText(QStringLiteral("# own\nroutine own\nsend WX,1=2\nexpect 0.8\n"));
    auto& problems = part<QListWidget>("instructions_problems");
    ASSERT_TRUE(problems.isVisible());
    ASSERT_EQ(problems.count(), 1);
    EXPECT_TRUE(problems.item(0)->text().startsWith(QStringLiteral("Line 3:")));
    EXPECT_FALSE(part<QPushButton>("instructions_dry_run").isEnabled());
    QTest::mouseClick(problems.viewport(), Qt::LeftButton, {}, problems.visualItemRect(problems.item(0)).center());
    EXPECT_EQ(editor().textCursor().blockNumber(), 2);
}

TEST_F(InstructionsPageTest, LettersAreTypedAndDoNotMoveTheInstrument) {
    editor().setFocus();
    editor().moveCursor(QTextCursor::Start);
    QTest::keyClicks(&editor(), QStringLiteral("# mark "));
    EXPECT_TRUE(editor().toPlainText().startsWith(QStringLiteral("# mark ")));
    EXPECT_TRUE(bench->instructions.isModified());
}

TEST_F(InstructionsPageTest, ControlSSavesAndControlRReverts) {
    editor().setPlainText(QStringLiteral("routine own\nsend WV,102=1\nexpect 0.8\n"));
    QTest::keyClick(&editor(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(bench->instructions.isModified());
    EXPECT_NE(bench->instruction_file.table().find("own"), nullptr);
    editor().appendPlainText(QStringLiteral("# more"));
    QTest::keyClick(&editor(), Qt::Key_R, Qt::ControlModifier);
    EXPECT_FALSE(editor().toPlainText().contains(QStringLiteral("# more")));
}

TEST_F(InstructionsPageTest, F5RunsItDryAndShowsEveryStep) {
    QSignalSpy changed(&bench->instructions, &app::InstructionsPresenter::runChanged);
    QTest::keyClick(&editor(), Qt::Key_F5);
    while (bench->instructions.running() != app::InstructionsPresenter::Running::kNothing) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    auto& steps = part<QTableWidget>("instructions_steps");
    ASSERT_EQ(steps.rowCount(), 7);
    EXPECT_EQ(steps.item(0, 1)->text(), QStringLiteral("WV,102=0"));
    EXPECT_EQ(steps.item(0, 2)->text(), QStringLiteral("0.8<CR>"));
    EXPECT_TRUE(part<QLabel>("instructions_outcome").text().contains(QStringLiteral("went well")));
}

TEST_F(InstructionsPageTest, ARoutinesNumbersAreFieldsWithTheirRange) {
    auto& routines = part<QListWidget>("instructions_routines");
    routines.setCurrentRow(1);
    auto& mode = part<QLineEdit>("instructions_field_mode");
    EXPECT_EQ(mode.text(), QStringLiteral("0"));
    mode.setFocus();
    mode.selectAll();
    QTest::keyClicks(&mode, QStringLiteral("7"));
    EXPECT_TRUE(mode.property("wrong").toBool());
    EXPECT_FALSE(part<QPushButton>("instructions_dry_run").isEnabled());
}

}  // namespace
}  // namespace pmts::gui
