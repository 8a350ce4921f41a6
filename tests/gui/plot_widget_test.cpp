#include "lab/calibration_plots.hpp"
#include "parts/error_plot.hpp"
#include "pmts/gui/theme.hpp"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <gmock/gmock.h>
#include <qcustomplot.h>

namespace pmts::gui {
namespace {

using testing::HasSubstr;
using Role = DrawnResidual::Role;

DrawnResiduals fewResiduals() {
    return {.residuals = {{{100, 80}, {0.125, -0.25}, Role::kUsed, 2}, {{1000, 600}, {3, 4}, Role::kLeftOut, 1}, {{640, 360}, {0, 0.5}, Role::kHeldOut}},
            .frame_px = {1280, 720},
            .centre_px = {640, 360}};
}

class PlotWidgetTest : public testing::Test {
protected:
    PlotWidgetTest() {
        plot.resize(380, 250);
        plot.showResiduals(fewResiduals());
    }
    [[nodiscard]] QString in(const char* name) const { return folder.filePath(QLatin1String(name)); }
    [[nodiscard]] std::string saidAfter(const QString& path) {
        plot.save(path);
        const auto* const said = plot.findChild<QLabel*>(QStringLiteral("plot_said"));
        return said->isVisibleTo(&plot) ? said->text().toStdString() : std::string();
    }
    [[nodiscard]] static QByteArray contentOf(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }

    QTemporaryDir folder;
    ResidualPlot plot{ResidualPlot::Kind::kVectors};
};

TEST_F(PlotWidgetTest, SavedPlotIsSaidAndCanBeRead) {
    for (const char* name : {"plot.png", "plot.svg", "plot.csv"}) {
        EXPECT_THAT(saidAfter(in(name)), testing::AllOf(HasSubstr(name), HasSubstr("is written")));
    }
    EXPECT_EQ(QImage(in("plot.png")).size(), QSize(2000, 1400));
    EXPECT_TRUE(QSvgRenderer(in("plot.svg")).isValid());
    EXPECT_EQ(contentOf(in("plot.csv")).count('\n'), 4);
}

TEST_F(PlotWidgetTest, SaveIntoAMissingFolderSaysWhatToDo) {
    for (const char* name : {"missing/plot.png", "missing/plot.svg", "missing/plot.csv"}) {
        EXPECT_THAT(saidAfter(in(name)), testing::AllOf(HasSubstr(name), HasSubstr("cannot be written"), HasSubstr("Choose another folder")));
    }
}

TEST_F(PlotWidgetTest, SaveOverAFolderLeavesItAndSaysSo) {
    for (const char* name : {"plot.png", "plot.svg", "plot.csv"}) {
        ASSERT_TRUE(QDir(folder.path()).mkdir(QLatin1String(name)));
        EXPECT_THAT(saidAfter(in(name)), testing::AllOf(HasSubstr(name), HasSubstr("cannot be written"), HasSubstr("Choose another folder")));
        EXPECT_TRUE(QFileInfo(in(name)).isDir());
    }
}

TEST_F(PlotWidgetTest, SaveWhereNobodyMayWriteIsSaid) {
    EXPECT_THAT(saidAfter(QStringLiteral("/proc/plot.png")), testing::AllOf(HasSubstr("/proc/plot.png"), HasSubstr("cannot be written")));
}

TEST_F(PlotWidgetTest, ClickPutsTheSentenceAway) {
    ASSERT_FALSE(saidAfter(in("missing/plot.png")).empty());
    QMouseEvent press(QEvent::MouseButtonPress, {50, 50}, plot.mapToGlobal(QPointF(50, 50)), Qt::LeftButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&plot, &press);
    EXPECT_FALSE(plot.findChild<QLabel*>(QStringLiteral("plot_said"))->isVisibleTo(&plot));
}

TEST_F(PlotWidgetTest, NightOnTheScreenIsBlackOnWhiteInAFile) {
    plot.setLook({.ground = Qt::black, .text = Qt::red, .grid = Qt::red, .ha = Qt::red, .va = Qt::red});
    plot.save(in("plot.png"));
    EXPECT_EQ(QImage(in("plot.png")).pixelColor(3, 3), QColor(Qt::white));
    EXPECT_EQ(plot.grab().toImage().pixelColor(3, 3), QColor(Qt::black)) << "the screen stays as it was";
}

TEST_F(PlotWidgetTest, PixelsOfThePictureAreSquareAtEverySize) {
    for (const QSize size : {QSize(700, 300), QSize(300, 700)}) {
        double columns = 0, rows = 0;
        const QCustomPlot& drawn = plot.plot();
        const auto laid_out = QObject::connect(&drawn, &QCustomPlot::afterLayout, &plot, [&] {
            columns = drawn.xAxis->range().size() / drawn.axisRect()->width();
            rows = drawn.yAxis->range().size() / drawn.axisRect()->height();
        });
        EXPECT_FALSE(plot.picture(size).isNull());
        QObject::disconnect(laid_out);
        EXPECT_NEAR(columns, rows, 1e-9 * columns) << size.width();
    }
}

TEST_F(PlotWidgetTest, ResidualsAreListedWithTheirRole) {
    EXPECT_EQ(plot.csv(), QStringLiteral("column_px,row_px,residual_x_px,residual_y_px,spot,left_out,held_out\n"
                                         "100.0000,80.0000,0.12500,-0.25000,2,0,0\n"
                                         "1000.0000,600.0000,3.00000,4.00000,1,1,0\n"
                                         "640.0000,360.0000,0.00000,0.50000,,0,1\n"));
}

TEST_F(PlotWidgetTest, OutliersAloneAreDrawnToo) {
    ResidualPlot radius(ResidualPlot::Kind::kRadius);
    radius.showResiduals({.residuals = {{{100, 80}, {3, 4}, Role::kLeftOut}}, .frame_px = {1280, 720}, .centre_px = {640, 360}});
    EXPECT_EQ(radius.plot().graphCount(), 1);
}

TEST(CurvePlotTest, CurvesAreListedUnderTheirQuotedNames) {
    CurvePlot plot;
    plot.showCurves({{.name = QStringLiteral("a \"wide\" lens"), .radius_px = {0, 12.5}, .value_gon = {0, 0.56789012}}}, QStringLiteral("gon"));
    EXPECT_EQ(plot.csv(), QStringLiteral("curve,radius_px,value_gon\n"
                                         "\"a \"\"wide\"\" lens\",0.000,0.00000000\n"
                                         "\"a \"\"wide\"\" lens\",12.500,0.56789012\n"));
}

TEST(ErrorPlotTest, ErrorsAreListedInThePagesUnit) {
    ErrorPlot plot;
    app::MethodPage page;
    page.errors = {{QStringLiteral("7"), 0.0123, -0.004, {320.5, 200}}};
    plot.showBars(page, QStringLiteral("gon"));
    EXPECT_EQ(plot.csv(), QStringLiteral("target,error_ha_gon,error_va_gon,column_px,row_px\n"
                                         "\"7\",0.012300,-0.004000,320.500,200.000\n"));
}

TEST(CalibrationPlotsTest, ReportBecomesResidualsAndCurves) {
    app::CalibrationReport report;
    report.image_px = {1280, 720};
    report.centre_px = {643, 355};
    report.residuals = {{{10, 20}, {0.1, 0.2}, false}, {{30, 40}, {0.3, 0.4}, true}};
    report.angle_curve = {{0, 0}, {640, 27.5}};
    report.ideal_curve = {{0, 0}, {640, 27.25}};
    report.width_curve = {{5, 0.045}};

    const DrawnResiduals drawn = residualsOf(report);
    EXPECT_EQ(drawn.frame_px, QSize(1280, 720));
    EXPECT_EQ(drawn.centre_px, QPointF(643, 355));
    ASSERT_EQ(drawn.residuals.size(), 2U);
    EXPECT_EQ(drawn.residuals[0].residual_px, QPointF(0.1, 0.2));
    EXPECT_EQ(drawn.residuals[0].role, Role::kUsed);
    EXPECT_EQ(drawn.residuals[1].role, Role::kHeldOut);
    const auto angles = angleCurvesOf(report);
    ASSERT_EQ(angles.size(), 2U);
    EXPECT_THAT(angles[1].name.toStdString(), HasSubstr("-0.250 gon off at 640 px"));
    EXPECT_EQ(widthCurvesOf(report).at(0).value_gon, std::vector<double>{0.045});
}

TEST(CalibrationPlotsTest, EmptyPlotSaysWhyInsteadOfAxes) {
    QWidget holder;
    CalibrationPlots plots(&holder);
    plots.show({});
    for (const auto& [heading, plot] : plots.all()) {
        EXPECT_FALSE(plot->plot().xAxis->visible()) << heading.toStdString();
        ASSERT_EQ(plot->plot().itemCount(), 1) << heading.toStdString();
    }
    app::CalibrationReport report;
    report.width_curve = {{5, 0.045}, {6, 0.0451}};
    plots.show(report);
    EXPECT_TRUE(plots.all()[3].second->plot().xAxis->visible());
}

TEST(PlotWidgetScaleTest, NumbersAreRoundedDownToOneTwoOrFive) {
    EXPECT_DOUBLE_EQ(roundBelow(0.99), 0.5);
    EXPECT_DOUBLE_EQ(roundBelow(20), 20);
    EXPECT_DOUBLE_EQ(roundBelow(1999), 1000);
}

}  // namespace
}  // namespace pmts::gui
