#include "line/black_box_page.hpp"

#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "line/line_workspace.hpp"
#include "pmts/app/line/bug_report_presenter.hpp"
#include "pmts/app/line/replay_presenter.hpp"
#include "support/run_until.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>

namespace pmts::gui {
namespace {

class BlackBoxPageTest : public test::WindowFixture {
protected:
    BlackBoxPageTest() {
        bench->black_box->start();
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
        window->actions().bug_report->trigger();
    }
    template <class Widget>
    Widget& part(const char* name) {
        return *window->findChild<Widget*>(QLatin1String(name));
    }
    void lookAtReport() {
        part<QPushButton>("report_look").click();
        EXPECT_TRUE(part<QPushButton>("report_cancel").isVisible());
        EXPECT_TRUE(test::runUntil([this] { return !bench->bug_report->isBusy(); }));
    }
    [[nodiscard]] QByteArray box() {
        bench->black_box->waitUntilWritten();
        QFile file(bench->black_box->path());
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
};

TEST_F(BlackBoxPageTest, TheHelpMenuOpensItAndItSaysThatItRecords) {
    EXPECT_TRUE(window->findChild<BlackBoxPage*>()->isVisible());
    EXPECT_TRUE(part<QLabel>("black_box_state").text().startsWith(QStringLiteral("Recording.")));
    EXPECT_TRUE(part<QCheckBox>("black_box_on").isChecked());
}

TEST_F(BlackBoxPageTest, SwitchedOffItIsRemembered) {
    part<QCheckBox>("black_box_on").click();
    EXPECT_FALSE(bench->black_box->isRecording());
    EXPECT_FALSE(bench->preferences.settings().black_box.on);
    EXPECT_TRUE(part<QLabel>("black_box_state").text().startsWith(QStringLiteral("Off.")));
}

TEST_F(BlackBoxPageTest, TheReportIsLookedAtBeforeItCanBeSaved) {
    EXPECT_FALSE(part<QPushButton>("report_save").isEnabled());
    part<QPlainTextEdit>("report_words").setPlainText(QStringLiteral("The picture stood still."));
    lookAtReport();

    EXPECT_TRUE(part<QPushButton>("report_save").isEnabled());
    EXPECT_EQ(part<QListWidget>("report_inside").count(), 4);
    EXPECT_TRUE(part<QPlainTextEdit>("report_preview").toPlainText().contains(QStringLiteral("The picture stood still.")));
    part<QListWidget>("report_inside").setCurrentRow(1);
    EXPECT_TRUE(part<QPlainTextEdit>("report_preview").toPlainText().contains(QStringLiteral("black_box/on = true")));

    part<QCheckBox>("report_pictures").click();
    EXPECT_FALSE(part<QPushButton>("report_save").isEnabled()) << "another report than the one that was looked at";
}

TEST_F(BlackBoxPageTest, ClicksAndActionsAreInTheBox) {
    part<QCheckBox>("report_pictures").setChecked(true);
    QTest::mouseClick(&part<QPushButton>("report_look"), Qt::LeftButton);
    window->actions().capture->trigger();
    const QByteArray bytes = box();
    EXPECT_TRUE(bytes.contains("Click on Put together and look"));
    EXPECT_TRUE(bytes.contains("Capture"));
}

TEST_F(BlackBoxPageTest, AFaultChosenInTheSimulatorMenuAndShortcutsAreInTheBox) {
    QMenu* faults = nullptr;
    for (QMenu* const menu : window->findChildren<QMenu*>()) {
        faults = menu->title() == QLatin1String("Fault") ? menu : faults;
    }
    ASSERT_NE(faults, nullptr);
    faults->popup({});
    QAction* const fault = faults->actions().at(1);
    faults->setActiveAction(fault);
    QTest::keyClick(faults, Qt::Key_Return);
    EXPECT_TRUE(box().contains("Fault > " + fault->text().remove(u'&').toUtf8()));

    QShortcut shortcut(QKeySequence(Qt::Key_F5), &part<QPlainTextEdit>("report_words"));
    part<QPlainTextEdit>("report_words").setFocus();
    QTest::keyClick(&part<QPlainTextEdit>("report_words"), Qt::Key_F5);
    EXPECT_TRUE(box().contains("Key F5"));
}

TEST_F(BlackBoxPageTest, ARowThatIsClickedIsInTheBoxAndWhatIsTypedIsNot) {
    part<QPlainTextEdit>("report_words").setFocus();
    QTest::keyClicks(&part<QPlainTextEdit>("report_words"), QStringLiteral("geheim"));
    lookAtReport();
    auto& list = part<QListWidget>("report_inside");
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(1)).center());
    const QByteArray bytes = box();
    EXPECT_TRUE(bytes.contains("Click on settings.txt"));
    EXPECT_FALSE(bytes.contains("geheim"));
}

TEST_F(BlackBoxPageTest, WhatIsTypedStaysAndCountsWhenItIsThrough) {
    auto& room = part<QSpinBox>("black_box_mb");
    const QString first = bench->black_box->path();
    room.setFocus();
    room.selectAll();
    QTest::keyClicks(&room, QStringLiteral("50"));
    Q_EMIT bench->black_box->statusChanged();
    EXPECT_TRUE(room.text().startsWith(QStringLiteral("50"))) << room.text().toStdString();
    QTest::keyClick(&room, Qt::Key_Up);
    QTest::keyClick(&room, Qt::Key_Up);
    EXPECT_EQ(bench->preferences.settings().black_box.kept_mb, 300) << "nothing goes for a step on the way";
    EXPECT_EQ(bench->black_box->path(), first);
    QTest::keyClick(&room, Qt::Key_Return);
    EXPECT_EQ(bench->preferences.settings().black_box.kept_mb, 52);
    bench->black_box->waitUntilWritten();
    EXPECT_NE(bench->black_box->path(), first);
}

TEST(ReplayWindowTest, ARecordingHasItsBarAndOpensNoDevice) {
    QTemporaryDir folder;
    QString recorded;
    {
        app::StartOptions options;
        options.data_folder = folder.path();
        app::Workbench bench(options);
        bench.black_box->start();
        bench.messages.warn(QStringLiteral("The battery is low."), QStringLiteral("Change it."));
        bench.black_box->waitUntilWritten();
        recorded = bench.black_box->path();
    }
    app::StartOptions options;
    options.data_folder = folder.path();
    options.replay_path = recorded;
    options.replay_speed = 4.0;
    app::Workbench bench(options);
    MainWindow window(bench);
    window.show();
    bench.start();
    ASSERT_TRUE(test::runUntil([&bench] { return bench.replay->isAtEnd() && !bench.replay->isPlaying(); }));

    EXPECT_TRUE(window.findChild<QToolBar*>(QStringLiteral("replay_bar"))->isVisible());
    EXPECT_FALSE(bench.black_box->isRecording()) << "a replay is not recorded";
    EXPECT_FALSE(bench.simulation.isRunning());
    EXPECT_FALSE(bench.job_desk.isOpen());
    ASSERT_FALSE(bench.messages.bars().empty());
    EXPECT_EQ(bench.messages.bars().back().happened, QStringLiteral("The battery is low."));
    EXPECT_EQ(window.findChild<QSlider*>(QStringLiteral("replay_place"))->value(), 10000);

    window.activateWindow();
    QApplication::setActiveWindow(&window);
    auto& speed = *window.findChild<QComboBox*>(QStringLiteral("replay_speed"));
    const auto type = [&speed](const char* text) {
        speed.setFocus();
        speed.lineEdit()->setText(QString::fromUtf8(text));
        QTest::keyClick(speed.lineEdit(), Qt::Key_Return);
    };
    type("0,3");
    EXPECT_EQ(bench.replay->speed(), 0.3);
    type("120×");
    EXPECT_EQ(bench.replay->speed(), 120.0);
    for (const char* const none : {"fast", "0", "2000"}) {
        type(none);
        EXPECT_EQ(bench.replay->speed(), 120.0) << none;
        EXPECT_EQ(speed.currentText(), QStringLiteral("120×"));
    }
}

}  // namespace
}  // namespace pmts::gui
