#include "pmts/app/lab/distortion_table_presenter.hpp"

#include "app/lab_fixture.hpp"

namespace pmts::app {
namespace {

using calibration::RadiusDirection;
using testing::HasSubstr;

class DistortionTablePresenterTest : public LabTest {
protected:
    void SetUp() override {
        look(QStringLiteral("laboratory"), simulator::simulatedRig());
        connectInstrument();
        table.setStep(90);
        table.setDirections({RadiusDirection::kRight});
    }
    void chooseTarget() {
        ASSERT_TRUE(sight("T1"));
        range.addShot(mark("T1").pointing, mark("T1").slope_distance_m);
        table.click(seen("T1") + QPointF(4, 3));
        ASSERT_TRUE(table.canStart()) << qPrintable(table.step());
    }
    /// Angle off the axis at this radius, by the lens that drew the pictures.
    [[nodiscard]] double trueAngle_gon(double radius_px) const {
        const auto ray = rig.lens.cameraFromPixel(rig.lens.principalPoint() + Eigen::Vector2d(radius_px, 0));
        return Angle::fromRad(std::atan2(ray->x(), ray->z())).gon();
    }

    DistortionTablePresenter table{live, instrument, range, preferences, messages, Threading::kCallersThread};
};

TEST_F(DistortionTablePresenterTest, TargetIsLedAlongTheRadiusAndTheTableIsTheLens) {
    chooseTarget();
    table.start();
    ASSERT_TRUE(table.isSweeping());
    ASSERT_TRUE(watch([this] { return !table.isSweeping(); }, 400));

    ASSERT_TRUE(table.canAccept()) << qPrintable(table.step());
    const auto rows = table.rows();
    ASSERT_EQ(rows.size(), 7U);  // 0, 90 ... 540
    for (const TableRowText& row : rows) {
        EXPECT_NEAR(row.angle.toDouble(), trueAngle_gon(row.radius.toDouble()), 0.006) << qPrintable(row.radius);  // a tenth of a pixel is 0.005
    }
    table.accept();
    EXPECT_TRUE(std::holds_alternative<camera::RadialTableLens>(live.model().rig().lens.model()));
    EXPECT_EQ(table.state(), DeviceState::kGood);
}

TEST_F(DistortionTablePresenterTest, CancelEndsTheSweep) {
    chooseTarget();
    table.start();
    showFrames(3);
    table.cancel();

    EXPECT_TRUE(watch([this] { return !table.isSweeping(); }, 60));
    EXPECT_FALSE(table.canAccept());
}

TEST_F(DistortionTablePresenterTest, ByHandEachClickIsARow) {
    table.setByHand(true);
    ASSERT_TRUE(sight("T1"));
    range.addShot(mark("T1").pointing, mark("T1").slope_distance_m);
    table.click(seen("T1"));
    for (const double aside_gon : {-4.0, -8.0, -12.0}) {  // the target goes to the right
        ASSERT_TRUE(turnTo(mark("T1").pointing.ha.gon() + aside_gon, 100));
        showFrames(3);
        table.click(seen("T1"));
    }

    ASSERT_EQ(table.runTexts().size(), 1);
    EXPECT_THAT(table.runTexts().front().toStdString(), HasSubstr("places: 4"));
    ASSERT_TRUE(table.canAccept()) << qPrintable(table.step());
    EXPECT_NEAR(table.rows()[1].angle.toDouble(), trueAngle_gon(90), 0.02);
}

TEST_F(DistortionTablePresenterTest, HandleCameraRefusesAnUprightRadius) {
    camera::Rig handle = simulator::simulatedRig({.mount = camera::MountKind::kHandle});
    lookWith(handle);
    CalibrationRecord record;
    preferences.acceptRig(handle, record);
    table.setDirections({RadiusDirection::kUp});
    chooseTarget();
    table.start();

    EXPECT_FALSE(table.isSweeping());
    EXPECT_THAT(table.step().toStdString(), HasSubstr("right or left"));
}

TEST_F(DistortionTablePresenterTest, EditedRowThatFallsBackIsNamedAndNotAccepted) {
    table.addRow();
    table.addRow();
    table.addRow();
    ASSERT_TRUE(table.canAccept());
    table.setRow(2, QStringLiteral("100"), QStringLiteral("1 gon"));

    EXPECT_FALSE(table.canAccept());
    EXPECT_THAT(table.rowsTrouble().toStdString(), HasSubstr("Row 3"));
    table.removeRow(2);
    EXPECT_TRUE(table.rowsTrouble().isEmpty());
}

TEST_F(DistortionTablePresenterTest, TableGoesOutAndComesBackAsCsv) {
    for (int i = 0; i < 4; ++i) {
        table.addRow();
    }
    const QString before = table.rows().back().angle;
    table.exportCsv(folder.filePath(QStringLiteral("table.csv")));
    table.removeRow(2);
    table.importCsv(folder.filePath(QStringLiteral("table.csv")));

    EXPECT_EQ(table.rows().size(), 5U);
    EXPECT_EQ(table.rows().back().angle, before);
}

TEST_F(DistortionTablePresenterTest, PlotsHaveTheTableTheIdealLineAndTheIdealLens) {
    for (int i = 0; i < 4; ++i) {
        table.addRow();
    }
    const TablePlots plots = table.plots();

    ASSERT_EQ(plots.angle.size(), 3U);
    EXPECT_EQ(plots.angle.front().radius_px.size(), 5U);
    EXPECT_EQ(plots.width.size(), 2U);
}

}  // namespace
}  // namespace pmts::app
