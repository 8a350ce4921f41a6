#include "black_box_page.hpp"

#include "bench_fixture.hpp"
#include "field_actions.hpp"
#include "line_workspace.hpp"
#include "pmts/app/bug_report_presenter.hpp"
#include "pmts/app/replay_presenter.hpp"
#include "support/run_until.hpp"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
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
        window->actions().bug_report->trigger();
    }
    template <class Widget>
    Widget& part(const char* name) {
        return *window->findChild<Widget*>(QLatin1String(name));
    }
    void lookAtReport() {
        part<QPushButton>("report_look").click();
        EXPECT_TRUE(part<QPushButton>("report_cancel").isVisible());
        test::runUntil([this] { return !bench->bug_report->isBusy(); });
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
    bench->black_box->waitUntilWritten();
    QFile file(bench->black_box->path());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    EXPECT_TRUE(bytes.contains("Click on Put together and look"));
    EXPECT_TRUE(bytes.contains("Capture"));
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
    bool has_ended = false;
    QObject::connect(bench.replay.get(), &app::ReplayPresenter::playingChanged, &window,
                     [&has_ended](bool playing) { has_ended = !playing; });
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return has_ended; }));

    EXPECT_TRUE(window.findChild<QToolBar*>(QStringLiteral("replay_bar"))->isVisible());
    EXPECT_FALSE(bench.black_box->isRecording()) << "a replay is not recorded";
    EXPECT_FALSE(bench.simulation.isRunning());
    EXPECT_FALSE(bench.job_desk.isOpen());
    ASSERT_FALSE(bench.messages.bars().empty());
    EXPECT_EQ(bench.messages.bars().back().happened, QStringLiteral("The battery is low."));
    EXPECT_EQ(window.findChild<QSlider*>(QStringLiteral("replay_place"))->value(), 10000);
}

}  // namespace
}  // namespace pmts::gui
