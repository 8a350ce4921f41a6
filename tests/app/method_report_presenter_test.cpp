#include "pmts/app/field/method_report_presenter.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>

#include <cmath>

namespace pmts::app {
namespace {

class MethodReportPresenterTest : public FieldTest {
protected:
    [[nodiscard]] const MethodPage& page(const char* name) const {
        for (const MethodPage& candidate : report.view()->pages) {
            if (candidate.name == QLatin1String(name)) {
                return candidate;
            }
        }
        throw std::logic_error("no such page");
    }
    void runThesis() {
        report.openThesisExample();
        report.run(report.form());
        core::deliverQueuedEvents();
        ASSERT_TRUE(report.view().has_value());
    }
    [[nodiscard]] static double gon(const QString& text) { return text.toDouble(); }
    MethodReportForm formWith(ReportField field, const char* text) const {
        MethodReportForm form = report.form();
        form.fields[field] = QString::fromUtf8(text);
        return form;
    }
    QString written(const QString& name) const {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }

    MethodReportPresenter report{live, job_desk, points, station_page, range, preferences, Threading::kCallersThread};
    QSignalSpy problems{&report, &MethodReportPresenter::problemReported};
};

TEST_F(MethodReportPresenterTest, ThesisExampleReproducesItsPrintedColumns) {
    runThesis();
    ASSERT_EQ(report.view()->pages.size(), 6U);
    // Tables 6.1-6.3: APA within its own rounding, TPA and OATPA within what 22/7 for pi makes of them.
    const std::pair<const char*, double> limits_gon[] = {{"APA", 0.001}, {"TPA", 0.010}, {"OATPA", 0.010}};
    for (const auto& [name, limit_gon] : limits_gon) {
        const TextTable& table = page(name).table;
        ASSERT_EQ(table.plain_rows, 11) << name;
        for (int row = 0; row < table.plain_rows; ++row) {
            EXPECT_LE(std::abs(gon(table.rows[row][8])), limit_gon) << name << " " << row + 1;
            EXPECT_LE(std::abs(gon(table.rows[row][9])), limit_gon) << name << " " << row + 1;
        }
    }
}

TEST_F(MethodReportPresenterTest, ThesisExampleEndsInTheKnownErrors) {
    runThesis();
    EXPECT_NEAR(gon(page("APA").table.rows.back()[6]), 1.47, 0.01);
    EXPECT_NEAR(gon(page("TPA").table.rows.back()[6]), 1.76, 0.02);
    EXPECT_NEAR(gon(page("OATPA").table.rows.back()[6]), 1.71, 0.02);
    EXPECT_LT(gon(page("Rigorous").table.rows.back()[6]), 0.08);   // reference, section 9: 0.78 px at most
    EXPECT_LT(gon(page("Left one out").table.rows[11][6]), 0.15);  // the rms row
    EXPECT_THAT(report.view()->fit.front().toStdString(), testing::HasSubstr("0.38"));
    EXPECT_THAT(page("APA").known_error.toStdString(), testing::HasSubstr("1.47 gon"));
}

TEST_F(MethodReportPresenterTest, ErrorsAreForThePlotsToo) {
    runThesis();
    const TargetError& first = page("TPA").errors.front();
    EXPECT_EQ(first.px, QPointF(157, 371));
    EXPECT_NEAR(first.ha, 186.7035 - 186.1377, 0.010);
    EXPECT_EQ(report.view()->image_px, QSize(640, 480));
}

TEST_F(MethodReportPresenterTest, OtherUnitsRewriteReportAndOptions) {
    runThesis();
    preferences.setUnits({.angle_unit = core::AngleUnit::kDegree, .length_unit = LengthUnit::kFoot, .length_decimals = 3});
    EXPECT_NEAR(gon(page("TPA").table.rows[0][2]), 186.1377 * 0.9, 1e-4);
    EXPECT_EQ(page("TPA").table.rows[0][1], QStringLiteral("18.769"));  // 5.7207 m
    EXPECT_EQ(report.form().fields.at(ReportField::kPhotoHa), QStringLiteral("179.4228°"));
    EXPECT_EQ(report.view()->plot_unit, QStringLiteral("°"));
}

TEST_F(MethodReportPresenterTest, FieldThatCannotBeReadIsNamedAndNothingRuns) {
    report.openThesisExample();
    QSignalSpy rejected(&report, &MethodReportPresenter::fieldRejected);
    report.run(formWith(ReportField::kF, "far"));
    ASSERT_EQ(rejected.size(), 1);
    EXPECT_EQ(rejected.at(0).at(0).value<ReportField>(), ReportField::kF);
    EXPECT_FALSE(report.view().has_value());
}

TEST_F(MethodReportPresenterTest, OnePixelAngleAloneIsRefused) {
    report.openThesisExample();
    QSignalSpy rejected(&report, &MethodReportPresenter::fieldRejected);
    EXPECT_FALSE(report.keepForm(formWith(ReportField::kPixelAcross, "0.0785 gon")));
    EXPECT_EQ(rejected.at(0).at(0).value<ReportField>(), ReportField::kPixelDown);
}

TEST_F(MethodReportPresenterTest, DamagedTableSaysLineAndColumn) {
    QFile file(folder.filePath(QStringLiteral("bad.csv")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("no,sd,sha,sva,u,v\n1,5.7,186,116,157,left\n");
    file.close();
    report.openTable(file.fileName());
    ASSERT_EQ(problems.size(), 1);
    const QString sentence = problems.at(0).at(0).value<core::Error>().happened;
    EXPECT_THAT(sentence.toStdString(), testing::AllOf(testing::HasSubstr("Line 2"), testing::HasSubstr("left")));
    EXPECT_TRUE(report.targets().isEmpty());
}

TEST_F(MethodReportPresenterTest, TooFewTargetsForAFitSayHowManyAreWanted) {
    report.openThesisExample();
    report.targets().removeTargets({3, 4, 5, 6, 7, 8, 9, 10});
    report.run(report.form());
    core::deliverQueuedEvents();
    ASSERT_EQ(problems.size(), 1);
    EXPECT_THAT(problems.at(0).at(0).value<core::Error>().sentence().toStdString(), testing::HasSubstr("at least 5"));
    EXPECT_FALSE(report.isRunning());
}

TEST_F(MethodReportPresenterTest, ChangedListTakesTheReportAway) {
    runThesis();
    report.targets().removeTargets({0});
    EXPECT_FALSE(report.view().has_value());
    EXPECT_EQ(report.targets().rowCount(), 10);
}

TEST_F(MethodReportPresenterTest, CancelledFitLeavesNoReport) {
    report.openThesisExample();
    QObject::connect(&report, &MethodReportPresenter::runningChanged, &report, [this](bool running) {
        if (running) {
            report.cancel();
        }
    });
    report.run(report.form());
    core::deliverQueuedEvents();
    EXPECT_FALSE(report.view().has_value());
    EXPECT_FALSE(report.isRunning());
    EXPECT_TRUE(problems.empty());
}

TEST_F(MethodReportPresenterTest, SavedTableBringsTargetsAndOptionsBack) {
    report.openThesisExample();
    ASSERT_TRUE(report.keepForm(formWith(ReportField::kPhotoVa, "98.25 gon")));
    report.saveTable(folder.filePath(QStringLiteral("mine.csv")));
    report.openThesisExample();
    report.openTable(folder.filePath(QStringLiteral("mine.csv")));
    EXPECT_EQ(report.targets().rowCount(), 11);
    EXPECT_EQ(report.form().fields.at(ReportField::kPhotoVa), QStringLiteral("98.2500 gon"));
}

TEST_F(MethodReportPresenterTest, ReportIsSavedAsTextAndAsCsv) {
    runThesis();
    report.saveText(folder.filePath(QStringLiteral("report.txt")));
    report.saveCsv(folder.filePath(QStringLiteral("report.csv")));
    EXPECT_TRUE(written(QStringLiteral("report.txt")).contains(QStringLiteral("left one out")));
    const QStringList lines = written(QStringLiteral("report.csv")).split(u'\n', Qt::SkipEmptyParts);
    EXPECT_EQ(lines.size(), 1 + 6 * 11);
    EXPECT_TRUE(lines[1].startsWith(QStringLiteral("APA,1,")));
    EXPECT_EQ(lines[1].count(u','), lines.front().count(u','));
}

/// Three marks recorded at the wall and a still that shows them.
class CollectTest : public MethodReportPresenterTest {
protected:
    void SetUp() override {
        openJob();
        connectInstrument();
        for (const auto& [ha_gon, va_gon] : {std::pair(1.0, 99.0), std::pair(4.0, 102.0), std::pair(398.0, 101.0)}) {
            ASSERT_TRUE(turnTo(ha_gon, va_gon));
            ASSERT_TRUE(recordPoint());
        }
        ASSERT_TRUE(turnTo(0, 100));
        showFrames();
        report.collector().capture();
        showFrames(4);
        ASSERT_NE(report.collector().still(), nullptr);
    }
    TargetCollector& collector() { return report.collector(); }
};

TEST_F(CollectTest, EachClickGivesATargetOfItsPointAndPicksTheNext) {
    ASSERT_EQ(collector().points().size(), 3U);
    EXPECT_EQ(collector().pickedPoint(), 0);
    collector().click({640.25, 300.5});
    ASSERT_EQ(report.targets().rowCount(), 1);
    const targeting::ListedTarget& target = report.targets().targets().front();
    EXPECT_EQ(target.name, collector().points()[0].id);
    EXPECT_EQ(target.px, Eigen::Vector2d(640.25, 300.5));
    EXPECT_DOUBLE_EQ(target.observed.slope_distance_m, *points.points().front().observation.slope_distance_m);
    EXPECT_EQ(collector().pickedPoint(), 1);
    EXPECT_EQ(collector().points()[0].clicked, QPointF(640.25, 300.5));
}

TEST_F(CollectTest, StillBringsItsPointingAndItsRig) {
    const MethodReportForm form = report.form();
    EXPECT_EQ(form.rig, RigOfReport::kInUse);
    EXPECT_EQ(form.fields.at(ReportField::kWidth), QString::number(live.model().rig().width_px));
    EXPECT_EQ(form.fields.at(ReportField::kPhotoVa), preferences.units().angle(collector().still()->pointing.va));
}

TEST_F(CollectTest, PerfectClicksLeaveTheRigorousMethodWithoutError) {
    for (int i = 0; i < 3; ++i) {
        collector().click(collector().points()[static_cast<std::size_t>(i)].expected_px);
    }
    report.run(report.form());
    EXPECT_LT(gon(page("Rigorous").table.rows.back()[6]), 0.0002);
    EXPECT_GT(gon(page("TPA").table.rows.back()[6]), 0.001);
}

TEST_F(CollectTest, PointOfAnotherStationIsNotOffered) {
    StationForm form = station_page.form();
    form.name = QStringLiteral("200");
    station_page.apply(form);
    core::deliverQueuedEvents();
    collector().capture();
    showFrames(4);
    EXPECT_EQ(collector().still()->station_name, QStringLiteral("200"));
    EXPECT_TRUE(collector().points().empty());
}

TEST_F(CollectTest, ListOfAnotherPhotoIsNotMixedWithThisOne) {
    report.openThesisExample();
    collector().click({640, 300});
    EXPECT_EQ(report.targets().rowCount(), 11);
    ASSERT_EQ(problems.size(), 1);
    report.targets().clear();
    collector().click({640, 300});
    EXPECT_EQ(report.targets().rowCount(), 1);
    EXPECT_EQ(report.form().fields.at(ReportField::kPhotoVa), preferences.units().angle(collector().still()->pointing.va));
}

TEST_F(CollectTest, PhotoOfAJobOpenedAgainHasItsPictureAndItsPoints) {
    const geometry::Pointing taken_at = collector().still()->pointing;
    job_desk.close();
    job_desk.open(jobPath());
    ASSERT_TRUE(until([this] { return collector().stillNames().size() == 1 && !points.points().empty(); }));
    collector().chooseStill(0);
    ASSERT_TRUE(until([this] { return collector().still()->frame != nullptr; }));
    EXPECT_EQ(collector().still()->frame->image.cols, 128);
    EXPECT_NEAR(collector().still()->pointing.ha.gon(), taken_at.ha.gon(), 1e-9);
    EXPECT_EQ(collector().points().size(), 3U);
}

}  // namespace
}  // namespace pmts::app
