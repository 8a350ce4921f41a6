#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

/// A mark on the wall: 2 m east, 15 m north, 1 m above the optical centre.
const Eigen::Vector3d kMark{2.0, 15.0, 1.0};

class MainPathTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
    }
};

TEST_F(MainPathTest, CaptureClickMoveMeasureConvertRecordGivesTheMarksCoordinates) {
    // Arrange: the mark is in the picture, the range is only assumed.
    showFrames();
    live.capture();
    showFrames();
    ASSERT_TRUE(live.still().has_value());
    EXPECT_EQ(live.scene().range.source, RangeSource::kAssumed);

    // Act: click in the still, move, measure; click again with the range known (precise targeting).
    targeting.aimAtStillPixel(pixelOf(kMark));
    ASSERT_EQ(targeting.target()->state, MoveState::kAimed);
    EXPECT_EQ(true_pointing->at(clock.now()).ha.gon(), 0.0) << "turned before Move was pressed";
    targeting.move();
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    ASSERT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    ASSERT_TRUE(measure());
    showFrames();
    targeting.moveToLivePixel(pixelOf(kMark));
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    ASSERT_TRUE(measure());
    recording.convert();
    recording.record();
    ASSERT_TRUE(until([this] { return recording.readings().shot == ShotState::kRecorded; }));

    // Assert: station 1000/1000/100, so E 1002, N 1015, H 101; 3 mm EDM, 3 cc circles, residual parallax.
    ASSERT_EQ(points.points().size(), 1U);
    const survey::Point& point = points.points().front();
    EXPECT_EQ(point.id, QStringLiteral("1"));
    EXPECT_NEAR(point.coordinates.e_m, 1002.0, 0.010);
    EXPECT_NEAR(point.coordinates.n_m, 1015.0, 0.012);
    EXPECT_NEAR(point.coordinates.h_m, 101.0, 0.010);
    EXPECT_EQ(recording.pointId(), QStringLiteral("2"));
}

TEST_F(MainPathTest, RecordedPointAppearsAtItsPlaceInTheLiveView) {
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(turnTo(8, 97));

    showFrames();

    // The pixel by the simulator's own truth: the wall is where the line of sight of 5 gon, 98 gon meets y = 15 m.
    const Eigen::Vector3d hit = geometry::stationFromPolar({.pointing = {.ha = Angle::fromGon(5), .va = Angle::fromGon(98)},
                                                            .slope_distance_m = 15.0 / std::cos(5 * M_PI / 200) /
                                                                                std::sin(98 * M_PI / 200)});
    ASSERT_EQ(live.scene().overlay.size(), 2U) << "the point and the target of the last move";
    const OverlayItem& item = live.scene().overlay.front();
    EXPECT_EQ(item.label, QStringLiteral("1"));
    EXPECT_NEAR(item.px.x(), pixelOf(hit).x(), 1.0);
    EXPECT_NEAR(item.px.y(), pixelOf(hit).y(), 1.0);
}

TEST_F(MainPathTest, ReopenedJobHasPointsStationAndNextId) {
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("A09"));
    recording.setCode(QStringLiteral("WALL"));
    ASSERT_TRUE(recordPoint());
    StationForm form = station_page.form();
    form.height = QStringLiteral("250 m");
    station_page.apply(form);
    pass(1s);

    job_desk.close();
    job_desk.open(folder.filePath(QStringLiteral("wall.gpkg")));
    ASSERT_TRUE(until([this] { return job_desk.isOpen() && points.points().size() == 2; }));

    EXPECT_EQ(points.points()[1].id, QStringLiteral("A09"));
    EXPECT_EQ(points.points()[1].code, QStringLiteral("WALL"));
    EXPECT_EQ(recording.pointId(), QStringLiteral("A10"));
    EXPECT_EQ(recording.code(), QStringLiteral("WALL"));
    EXPECT_EQ(station_page.station().h_m, 250.0);
    EXPECT_NEAR(points.points()[0].coordinates.h_m, 250.0, 0.01) << "recomputed and kept";
}

TEST_F(MainPathTest, CablePulledWhileTurningFailsTheMoveAndReconnectsByItself) {
    targeting.aimAtText(QStringLiteral("150"), QStringLiteral("95"));
    targeting.move();
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));

    unplug();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);

    plugIn();
    EXPECT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
}

TEST_F(MainPathTest, CablePulledWhileMeasuringRecordsNothingAndSpaceWorksAfterwards) {
    recording.all();
    ASSERT_TRUE(until([this] { return instrument.progress().activity == instrument::Activity::kMeasuring; }));
    unplug();
    ASSERT_TRUE(until([this] { return !recording.isBusy(); }));
    EXPECT_EQ(recording.readings().shot, ShotState::kNone);
    plugIn();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));

    ASSERT_TRUE(recordPoint());

    EXPECT_EQ(points.points().size(), 1U);
}

}  // namespace
}  // namespace pmts::app
