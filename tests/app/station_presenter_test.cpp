#include "app/field_fixture.hpp"

#include "pmts/app/field/plan_presenter.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class StationPresenterTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
    }
    void apply(QString StationForm::*field, const char* text) {
        StationForm form = station_page.form();
        form.*field = QString::fromUtf8(text);
        station_page.apply(form);
    }
};

TEST_F(StationPresenterTest, NewJobStartsWithTheUsualStation) {
    EXPECT_EQ(station_page.form().easting, QStringLiteral("1000.000 m"));
    EXPECT_EQ(station_page.form().height, QStringLiteral("100.000 m"));
    EXPECT_EQ(station_page.form().name, QStringLiteral("100"));
}

TEST_F(StationPresenterTest, InstrumentHeightRaisesThePointsObservedHere) {
    ASSERT_TRUE(recordPoint());
    const double before_m = points.points()[0].coordinates.h_m;
    QSignalSpy applied(&station_page, &StationPresenter::applied);
    apply(&StationForm::instrument_height, "1.60 m");
    EXPECT_NEAR(points.points()[0].coordinates.h_m, before_m + 1.6, 1e-9);
    EXPECT_THAT(applied.at(0).at(0).toString().toStdString(), testing::HasSubstr("1 point"));
}

TEST_F(StationPresenterTest, ChangeIsOneUndoStepForStationAndPoints) {
    ASSERT_TRUE(recordPoint());
    const survey::Coordinates before = points.points()[0].coordinates;
    const int steps = undo.count();
    apply(&StationForm::easting, "2000 m");
    EXPECT_EQ(undo.count(), steps + 1);
    EXPECT_NEAR(points.points()[0].coordinates.e_m, before.e_m + 1000, 1e-9);
    undo.undo();
    EXPECT_NEAR(points.points()[0].coordinates.e_m, before.e_m, 1e-9);
    EXPECT_EQ(station_page.station().e_m, 1000.0);
}

TEST_F(StationPresenterTest, ChangeTheFileRefusesIsTakenBackWithItsUndoStep) {
    ASSERT_TRUE(recordPoint());
    const survey::Coordinates before = points.points()[0].coordinates;
    const int steps = undo.count();
    moveJobAway();
    apply(&StationForm::easting, "2000 m");
    apply(&StationForm::easting, "3000 m");
    pass(1s);
    EXPECT_EQ(station_page.station().e_m, 1000.0);
    EXPECT_NEAR(points.points()[0].coordinates.e_m, before.e_m, 1e-9);
    EXPECT_EQ(undo.count(), steps);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("moved or deleted"));
}

TEST_F(StationPresenterTest, NewStationNameLeavesThePointsOfTheOldOneAlone) {
    ASSERT_TRUE(recordPoint());
    const survey::Coordinates before = points.points()[0].coordinates;
    StationForm form = station_page.form();
    form.name = QStringLiteral("200");
    form.easting = QStringLiteral("5000 m");
    station_page.apply(form);
    EXPECT_EQ(points.points()[0].coordinates.e_m, before.e_m);
    EXPECT_EQ(station_page.pointsObservedHere(), 0);
}

TEST_F(StationPresenterTest, FieldThatCannotBeReadChangesNothingAndIsNamed) {
    QSignalSpy refused(&station_page, &StationPresenter::fieldRejected);
    apply(&StationForm::northing, "far north");
    ASSERT_EQ(refused.size(), 1);
    EXPECT_EQ(refused.at(0).at(0).value<StationField>(), StationField::kNorthing);
    EXPECT_EQ(station_page.station().n_m, 1000.0);
    EXPECT_EQ(undo.count(), 0);
}

TEST_F(StationPresenterTest, FieldsUnderstandFeetAndArithmetic) {
    apply(&StationForm::height, "100 ft + 1 m");
    EXPECT_NEAR(station_page.station().h_m, 31.48, 1e-9);
}

TEST_F(StationPresenterTest, TypedBearingOrientsTheCircleReading) {
    ASSERT_TRUE(turnTo(50, 100));
    station_page.orientByBearing(QStringLiteral("120 gon"));
    EXPECT_NEAR(station_page.station().orientation.gon(), 70.0, 0.002);
    EXPECT_NEAR(station_page.bearingText(Angle::fromGon(50)).split(u' ').first().toDouble(), 120.0, 0.002);
}

TEST_F(StationPresenterTest, KnownCoordinatesOrientTheCircleReading) {
    // From 1000/1000 to E 1100, N 1000 the bearing is 100 gon: due east.
    station_page.orientToCoordinates(QStringLiteral("1100 m"), QStringLiteral("1000 m"));
    EXPECT_NEAR(station_page.station().orientation.gon(), 100.0, 0.002);
}

TEST_F(StationPresenterTest, OrientationTurnsThePointsRoundTheStation) {
    ASSERT_TRUE(recordPoint());  // 15 m to the north
    station_page.orientByBearing(QStringLiteral("100 gon"));
    EXPECT_NEAR(points.points()[0].coordinates.e_m, 1015.0, 0.015);
    EXPECT_NEAR(points.points()[0].coordinates.n_m, 1000.0, 0.015);
}

TEST_F(StationPresenterTest, CoordinatesOfTheStationItselfGiveNoBearing) {
    QSignalSpy refused(&station_page, &StationPresenter::fieldRejected);
    station_page.orientToCoordinates(QStringLiteral("1000"), QStringLiteral("1000"));
    EXPECT_EQ(refused.size(), 1);
}

TEST_F(StationPresenterTest, OrientingWithoutAnInstrumentSaysWhatIsMissing) {
    instrument.disconnectInstrument();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kDisconnected; }));
    station_page.orientByBearing(QStringLiteral("100 gon"));
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("no circle reading"));
    EXPECT_EQ(station_page.station().orientation.gon(), 0.0);
}

TEST_F(StationPresenterTest, PlanShowsPointsStationAndTheLineOfSight) {
    const PlanPresenter plan(points, planned, station_page, instrument, range);
    ASSERT_TRUE(recordPoint());
    const PlanScene scene_now = plan.scene();
    ASSERT_EQ(scene_now.points.size(), 1U);
    EXPECT_NEAR(scene_now.points[0].position_en_m.y(), 1015.0, 0.015);
    EXPECT_EQ(scene_now.station_en_m, QPointF(1000, 1000));
    ASSERT_TRUE(scene_now.sight_en_m.has_value());
    EXPECT_NEAR(scene_now.sight_en_m->y(), 1015.0, 0.02);
    undo.undo();
    EXPECT_TRUE(plan.scene().points.empty()) << "struck out";
}

}  // namespace
}  // namespace pmts::app
