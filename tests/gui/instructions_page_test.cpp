#include "line/instructions_page.hpp"

#include "bench_fixture.hpp"
#include "line/line_workspace.hpp"
#include "pmts/app/desk/whole_file.hpp"
#include "line/table_editor.hpp"

#include <QAction>
#include <QApplication>
#include <QEventLoop>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include <algorithm>

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
    QAction* actionNamed(const QString& text) {
        const auto actions = window->findChildren<QAction*>();
        const auto found = std::ranges::find(actions, text, &QAction::text);
        EXPECT_NE(found, actions.end()) << text.toStdString();
        return *found;
    }
    /// Until it is so, looked at when the signal comes; false after half a minute.
    template <class Sender, class Signal, class IsSo>
    bool until(const Sender& sender, Signal signal, IsSo is_so) {
        QEventLoop loop;
        QObject::connect(&sender, signal, &loop, [&] { is_so() ? loop.quit() : void(); });
        QTimer::singleShot(std::chrono::seconds(30), &loop, &QEventLoop::quit);
        if (!is_so()) {
            loop.exec();
        }
        return is_so();
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

/// Ctrl+R is one key from a table that took a day.
TEST_F(InstructionsPageTest, UndoBringsBackWhatRevertAndImportReplaced) {
    const QString typed = QStringLiteral("routine own\nsend WV,102=1\nexpect 0.8\n");
    editor().selectAll();
    editor().insertPlainText(typed);
    QTest::keyClick(&editor(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_FALSE(bench->instructions.isModified());
    editor().undo();
    EXPECT_EQ(editor().toPlainText(), typed);
    EXPECT_EQ(bench->instructions.text(), typed);
    EXPECT_TRUE(bench->instructions.isModified());

    QString many;
    for (int i = 0; i < 1500; ++i) {
        many += QStringLiteral("# line\n");
    }
    const int narrow = editor().marginWidth();
    const QString path = folder.filePath(QStringLiteral("other.txt"));
    ASSERT_TRUE(app::writeWhole(path, many.toUtf8()));
    bench->instructions.importFrom(path);
    EXPECT_EQ(editor().toPlainText(), many);
    EXPECT_GT(editor().marginWidth(), narrow);
    EXPECT_EQ(editor().viewport()->x(), editor().contentsRect().x() + editor().marginWidth()) << "room for four digits";
    editor().undo();
    EXPECT_EQ(editor().toPlainText(), typed);
}

/// Over a pty, in the time that it takes; every wait ends with a signal.
class InstructionsOnTheBusTest : public InstructionsPageTest {};

TEST_F(InstructionsOnTheBusTest, F6ShowsTheNoteAndRunsTheSavedRoutineOnTheBase) {
    editor().setPlainText(QStringLiteral("routine own\nnote Seen in the laboratory.\n"
                                         "send WV,102=0\nexpect 0.8\nsend WV,102=1\nexpect 0.8\n"));
    QTest::keyClick(&editor(), Qt::Key_S, Qt::ControlModifier);
    actionNamed(QStringLiteral("Connect the base on its bus"))->trigger();
    const auto& instrument = bench->instrument;
    ASSERT_TRUE(until(instrument, &app::InstrumentDesk::connectionChanged,
                      [&] { return instrument.connectionState() == app::ConnectionState::kConnected; }));
    editor().appendPlainText(QStringLiteral("# not saved"));
    EXPECT_TRUE(part<QLabel>("instructions_trouble").text().contains(QStringLiteral("as it was saved")));

    QTest::keyClick(&editor(), Qt::Key_F6);
    auto& confirmation = part<QFrame>("instructions_confirmation");
    ASSERT_TRUE(confirmation.isVisible());
    EXPECT_TRUE(part<QLabel>("instructions_confirmation_text").text().contains(QStringLiteral("Seen in the laboratory.")));
    EXPECT_EQ(bench->instructions.running(), app::InstructionsPresenter::Running::kNothing);
    QTest::mouseClick(&part<QPushButton>("instructions_confirm"), Qt::LeftButton);
    EXPECT_FALSE(confirmation.isVisible());
    ASSERT_TRUE(until(bench->instructions, &app::InstructionsPresenter::runChanged,
                      [&] { return bench->instructions.running() == app::InstructionsPresenter::Running::kNothing; }));
    EXPECT_TRUE(part<QLabel>("instructions_outcome").text().contains(QStringLiteral("went well")))
        << part<QLabel>("instructions_outcome").text().toStdString();
    EXPECT_EQ(part<QTableWidget>("instructions_steps").item(1, 1)->text(), QStringLiteral("WV,102=1"));
}

TEST_F(InstructionsPageTest, NothingIsThereToUndoAtTheStart) { EXPECT_FALSE(editor().document()->isUndoAvailable()); }

TEST_F(InstructionsPageTest, AnotherRangeGivesAnotherField) {
    editor().setPlainText(QStringLiteral("routine own\nsend PV,3={mode 0..4}\nexpect 240.8\n"));
    EXPECT_EQ(part<QLineEdit>("instructions_field_mode").text(), QStringLiteral("0"));
    editor().setPlainText(QStringLiteral("routine own\nsend PV,3={mode 1..9}\nexpect 240.8\n"));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    const auto fields = window->findChildren<QLineEdit*>(QStringLiteral("instructions_field_mode"));
    ASSERT_EQ(fields.size(), 1);
    EXPECT_EQ(fields[0]->text(), QStringLiteral("1")) << "what would be sent";
    EXPECT_EQ(fields[0]->placeholderText(), QStringLiteral("1 to 9"));
}

}  // namespace
}  // namespace pmts::gui
