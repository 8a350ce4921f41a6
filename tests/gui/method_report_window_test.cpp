#include "field/method_report_window.hpp"

#include "bench_fixture.hpp"
#include "parts/error_plot.hpp"
#include "field/image_view.hpp"
#include "test_frame.hpp"

#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>

namespace pmts::gui {
namespace {

class MethodReportWindowTest : public test::WindowFixture {
protected:
    MethodReportWindowTest() : report(bench->live, bench->job_desk, bench->points, bench->station, bench->range, bench->preferences,
                                      app::Threading::kCallersThread) {
        page.emplace(report);
        page->show();
    }
    template <class Widget>
    [[nodiscard]] Widget* child(const char* name) const {
        auto* const found = page->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void click(const char* button) const {
        QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton);
        QCoreApplication::processEvents();  // the outcome of the fit is queued
    }
    [[nodiscard]] QString message() const { return child<QLabel>("message")->text(); }
    [[nodiscard]] QTabWidget* tabs() const { return child<QTabWidget>("tabs"); }
    void runThesis() const {
        click("example");
        click("run");
    }
    [[nodiscard]] QWidget* tabNamed(const QString& name) const {
        for (int i = 0; i < tabs()->count(); ++i) {
            if (tabs()->tabText(i) == name) {
                tabs()->setCurrentIndex(i);
                return tabs()->widget(i);
            }
        }
        return nullptr;
    }

    app::MethodReportPresenter report;
    std::optional<MethodReportWindow> page;
};

TEST_F(MethodReportWindowTest, TwoClicksShowTheThesisInATabForEachMethod) {
    runThesis();
    EXPECT_EQ(child<QTableWidget>("summary")->rowCount(), 6);
    for (const char* name : {"APA", "TPA", "OATPA", "Rectified OATPA", "Rigorous", "Left one out"}) {
        const QWidget* const tab = tabNamed(QString::fromLatin1(name));
        ASSERT_NE(tab, nullptr) << name;
        const auto* const table = tab->findChild<QTableWidget*>();
        EXPECT_EQ(table->rowCount(), 13) << "11 targets, rms, maximum";
        EXPECT_EQ(table->item(11, 0)->text(), QStringLiteral("rms"));
        EXPECT_FALSE(tab->findChild<QLabel*>(QStringLiteral("known_error"))->text().isEmpty());
        EXPECT_EQ(tab->findChildren<ErrorPlot*>().size(), 2);
    }
}

TEST_F(MethodReportWindowTest, TableShowsTheThesissOwnNumbers) {
    runThesis();
    const auto* const table = tabNamed(QStringLiteral("TPA"))->findChild<QTableWidget*>();
    EXPECT_EQ(table->item(0, 2)->text(), QStringLiteral("186.1377"));
    EXPECT_NEAR(table->item(0, 4)->text().toDouble(), 186.7035, 0.010);  // printed in table 6.2
}

TEST_F(MethodReportWindowTest, WrongFieldIsMarkedAndSaidAndNothingRuns) {
    click("example");
    child<QLineEdit>("f")->setText(QStringLiteral("far"));
    click("run");
    EXPECT_TRUE(child<QLineEdit>("f")->property("wrong").toBool());
    EXPECT_THAT(message().toStdString(), testing::HasSubstr("far"));
    EXPECT_EQ(tabs()->count(), 3);
}

TEST_F(MethodReportWindowTest, DamagedTableIsSaidInTheWindow) {
    QFile file(folder.filePath(QStringLiteral("bad.csv")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("no,sd,sha\n1,5.7,186\n");
    file.close();
    report.openTable(file.fileName());
    EXPECT_THAT(message().toStdString(), testing::HasSubstr("sva"));
}

TEST_F(MethodReportWindowTest, RemovedTargetLeavesListAndReport) {
    runThesis();
    tabs()->setCurrentIndex(0);
    auto* const targets = child<QTableView>("targets");
    targets->selectRow(2);
    click("remove");
    EXPECT_EQ(targets->model()->rowCount(), 10);
    EXPECT_EQ(tabs()->count(), 3);  // a report of another list is not shown
    EXPECT_FALSE(child<QPushButton>("save_pdf")->isEnabled());
}

TEST_F(MethodReportWindowTest, OtherUnitsReachFieldsAndTables) {
    runThesis();
    bench->preferences.setUnits({.angle_unit = core::AngleUnit::kDms});
    EXPECT_EQ(child<QLineEdit>("photo_va")->text(), QStringLiteral("95°22'58\""));  // 105.9808 gon
    EXPECT_EQ(tabNamed(QStringLiteral("TPA"))->findChild<QTableWidget*>()->item(0, 3)->text(), QStringLiteral("105 06 55"));
}

TEST_F(MethodReportWindowTest, ReportIsSavedInThreeFormats) {
    runThesis();
    for (const char* name : {"report.txt", "report.csv", "report.pdf"}) {
        page->saveReport(folder.filePath(QString::fromLatin1(name)));
        EXPECT_THAT(message().toStdString(), testing::HasSubstr(name));
    }
    QFile pdf(folder.filePath(QStringLiteral("report.pdf")));
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    EXPECT_TRUE(bytes.startsWith("%PDF"));
    EXPECT_EQ(bytes.count("/Type /Page\n"), 7);  // the summary and six methods
}

TEST_F(MethodReportWindowTest, FileThatCannotBeWrittenIsSaid) {
    runThesis();
    page->saveReport(QStringLiteral("/nowhere/report.pdf"));
    EXPECT_THAT(message().toStdString(), testing::HasSubstr("/nowhere/report.pdf"));
}

TEST_F(MethodReportWindowTest, ClickInTheStillMakesATargetOfThePickedPoint) {
    survey::Point point;
    point.row_id = 7;
    point.id = QStringLiteral("104");
    point.station_name = bench->station.station().name;
    point.observation.pointing = {core::Angle::fromGon(50.5), core::Angle::fromGon(100.5)};
    point.observation.slope_distance_m = 23.418;
    bench->points.addRecorded(point);
    tabs()->setCurrentIndex(1);
    Q_EMIT bench->live.stillCaptured({.number = 3,
                                      .frame = test::frameWithBluePixel(700, 350),
                                      .pointing = {core::Angle::fromGon(50), core::Angle::fromGon(100)},
                                      .ha_text = {}, .va_text = {}, .utc = QDateTime::currentDateTimeUtc(), .photo_row_id = 0});
    auto* const stills = child<QComboBox>("still");
    ASSERT_EQ(stills->count(), 1);
    stills->setCurrentIndex(0);
    Q_EMIT stills->activated(0);
    QCoreApplication::processEvents();
    ASSERT_EQ(child<QTableWidget>("points")->item(0, 0)->text(), QStringLiteral("104"));

    auto* const picture = child<ImageView>("picture");
    QTest::mouseClick(picture, Qt::LeftButton, {}, picture->widgetFromImage({700, 350}).toPoint());

    ASSERT_EQ(report.targets().rowCount(), 1);
    EXPECT_NEAR(report.targets().targets().front().px.x(), 700, 1.5);  // a whole pixel of the screen
    EXPECT_EQ(child<QTableWidget>("points")->item(0, 2)->text(), QStringLiteral("✓"));
}

TEST_F(MethodReportWindowTest, OpensFromTheMenuAndFitsTheSmallestScreen) {
    auto* const action = window->findChild<QAction*>(QStringLiteral("method_report"));
    ASSERT_NE(action, nullptr);
    action->trigger();
    const auto* const opened = window->findChild<MethodReportWindow*>();
    ASSERT_NE(opened, nullptr);
    EXPECT_TRUE(opened->isVisible());
    EXPECT_LE(opened->minimumSizeHint().width(), 1280);
    EXPECT_LE(opened->minimumSizeHint().height(), 740);
    action->trigger();
    EXPECT_EQ(window->findChildren<MethodReportWindow*>().size(), 1);
}

}  // namespace
}  // namespace pmts::gui
