#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class RecordingPresenterTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
    }
    void openAgain() {
        job_desk.open(jobPath());
        ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));
    }
    /// Somebody turned it by hand, and its circles have been read.
    void standAt(double ha_gon, double va_gon) {
        true_pointing->place({.ha = Angle::fromGon(ha_gon), .va = Angle::fromGon(va_gon)});
        pass(5s);
    }
};

TEST_F(RecordingPresenterTest, ConvertBeforeMeasureSaysWhatIsMissing) {
    recording.convert();
    EXPECT_THAT(recording.readings().sentence.toStdString(), testing::HasSubstr("measure first (D)"));
}

TEST_F(RecordingPresenterTest, RecordBeforeMeasureSaysWhatIsMissing) {
    recording.record();
    EXPECT_THAT(recording.readings().sentence.toStdString(), testing::HasSubstr("measure first (D)"));
    EXPECT_TRUE(points.points().empty());
}

TEST_F(RecordingPresenterTest, MeasuredDistanceIsShownInTheChosenUnit) {
    preferences.setUnits({.angle_unit = core::AngleUnit::kGon, .length_unit = core::LengthUnit::kFoot, .length_decimals = 2});
    ASSERT_TRUE(measure());
    EXPECT_NEAR(recording.readings().sd.toDouble(), 15.0 / 0.3048, 0.05);
    EXPECT_EQ(recording.readings().length_unit, QStringLiteral("ft"));
}

TEST_F(RecordingPresenterTest, TheSameShotIsNotRecordedTwice) {
    ASSERT_TRUE(recordPoint());
    recording.record();
    pass(1s);
    EXPECT_EQ(points.points().size(), 1U);
    EXPECT_THAT(recording.readings().sentence.toStdString(), testing::HasSubstr("recorded already, as point 1"));
}

TEST_F(RecordingPresenterTest, RecordAgainOnPurposeTakesTheNextId) {
    ASSERT_TRUE(recordPoint());
    recording.recordAgain();
    pass(1s);
    ASSERT_EQ(points.points().size(), 2U);
    EXPECT_EQ(points.points()[1].id, QStringLiteral("2"));
}

TEST_F(RecordingPresenterTest, RawObservationIsRecordedWithThePoint) {
    recording.setTargetHeightText(QStringLiteral("1.6 m"));
    ASSERT_TRUE(recordPoint());
    const survey::Observation& observation = points.points().at(0).observation;
    EXPECT_NEAR(observation.slope_distance_m.value(), 15.0, 0.015);
    EXPECT_EQ(observation.target_height_m, 1.6);
    EXPECT_EQ(observation.edm_mode, QStringLiteral("STD"));
    EXPECT_FALSE(observation.raw_reply.isEmpty());
    EXPECT_GT(observation.time_taken_s, 1.0);
    EXPECT_NEAR(points.points()[0].coordinates.h_m, 100.0 - 1.6, 0.01);
}

TEST_F(RecordingPresenterTest, NoEchoLeavesAnAbsurdShotThatIsRecordedWithItsReason) {
    ASSERT_TRUE(turnTo(34.9, 99.0));  // atan(9 / 14.9) = 34.7 gon: the black panel
    ASSERT_TRUE(recordPoint());
    ASSERT_EQ(recording.readings().shot, ShotState::kAbsurd) << recording.readings().sentence.toStdString();
    EXPECT_TRUE(points.points().empty()) << "Space does not record what it did not get";

    recording.record();
    pass(1s);

    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_FALSE(points.points()[0].observation.slope_distance_m.has_value());
    EXPECT_FALSE(points.points()[0].observation.absurd_reason.isEmpty());
    EXPECT_TRUE(points.data(points.index(0, 0), PointsModel::kAbsurdRole).toBool());
    EXPECT_EQ(points.data(points.index(0, PointsModel::kEasting), Qt::DisplayRole).toString(), QString());
}

TEST_F(RecordingPresenterTest, CancelEndsTheMeasurementWithoutAShot) {
    recording.measure();
    ASSERT_TRUE(until([this] { return instrument.progress().activity == instrument::Activity::kMeasuring; }));
    recording.cancel();
    ASSERT_TRUE(until([this] { return !recording.isBusy(); }, 5s));
    EXPECT_EQ(recording.readings().shot, ShotState::kNone);
    EXPECT_TRUE(recording.readings().sd.isEmpty());
    EXPECT_TRUE(messages.bars().empty()) << "a wish fulfilled is no problem";
}

TEST_F(RecordingPresenterTest, ShotIsShownAsOldOnceTheTelescopeHasTurned) {
    ASSERT_TRUE(measure());
    EXPECT_FALSE(recording.readings().shot_is_elsewhere);
    ASSERT_TRUE(turnTo(10, 100));
    EXPECT_TRUE(recording.readings().shot_is_elsewhere);
}

TEST_F(RecordingPresenterTest, FailedRecordKeepsTheShotAndSaysSo) {
    // Arrange: the file refuses the record, as a full disk does.
    ASSERT_TRUE(measure());
    recording.record();
    const Ticket never_acknowledged = job_desk.lastTicket();
    Q_EMIT job_desk.requestFailed(never_acknowledged, {.kind = core::ErrorKind::kFile,
                                                       .happened = QStringLiteral("The disk is full."),
                                                       .remedy = QStringLiteral("Make room."),
                                                       .info_code = {},
                                                       .detail = {}});

    // Assert
    EXPECT_EQ(recording.readings().shot, ShotState::kKept);
    EXPECT_FALSE(recording.readings().sd.isEmpty());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("not recorded; the shot is kept"));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kRetryRecord);
    EXPECT_EQ(recording.pointId(), QStringLiteral("1")) << "the ID is not used up";
}

TEST_F(RecordingPresenterTest, KeptShotOfAnotherTargetIsRecordedUnderItsOwnNameAndSpaceGoesOnWithThisOne) {
    recording.setPointId(QStringLiteral("7"));
    recording.setCode(QStringLiteral("WALL"));
    ASSERT_TRUE(turnTo(5, 98));
    moveJobAway();
    ASSERT_TRUE(recordPoint());
    ASSERT_EQ(recording.readings().shot, ShotState::kKept);
    bringJobBack();
    ASSERT_TRUE(turnTo(9, 97));
    recording.setPointId(QStringLiteral("8"));
    recording.setCode(QStringLiteral("DOOR"));

    recording.all();
    ASSERT_TRUE(until([this] { return points.points().size() == 2 && !recording.isBusy(); }));

    const survey::Point& kept = points.points()[0];
    const survey::Point& next = points.points()[1];
    EXPECT_EQ(kept.id, QStringLiteral("7"));
    EXPECT_EQ(kept.code, QStringLiteral("WALL"));
    EXPECT_NEAR(kept.observation.pointing.ha.gon(), 5.0, 20e-4);
    EXPECT_EQ(next.id, QStringLiteral("8"));
    EXPECT_EQ(next.code, QStringLiteral("DOOR"));
    EXPECT_NEAR(next.observation.pointing.ha.gon(), 9.0, 20e-4);
}

TEST_F(RecordingPresenterTest, MeasuringElsewhereAsksBeforeItDropsAKeptShot) {
    recording.setPointId(QStringLiteral("7"));
    ASSERT_TRUE(turnTo(5, 98));
    moveJobAway();
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(turnTo(9, 97));
    recording.measure();
    EXPECT_FALSE(recording.isBusy());
    EXPECT_EQ(recording.readings().shot, ShotState::kKept);
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("point 7"))) << newestBar(messages).toStdString();

    ASSERT_TRUE(measure());
    EXPECT_EQ(recording.readings().shot, ShotState::kMeasured);
    bringJobBack();
}

TEST_F(RecordingPresenterTest, WithoutAJobTheShotIsKeptUntilOneIsOpen) {
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(recording.readings().shot, ShotState::kKept);
    job_desk.open(folder.filePath(QStringLiteral("wall.gpkg")));
    ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));

    recording.all();

    ASSERT_TRUE(until([this] { return recording.readings().shot == ShotState::kRecorded; }));
    EXPECT_EQ(points.points().size(), 1U);
    EXPECT_TRUE(messages.bars().empty()) << "solved";
}

TEST_F(RecordingPresenterTest, AShotThatWaitsForAJobKeepsItsOwnNameWhateverIsTypedForTheNext) {
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    recording.setPointId(QStringLiteral("7"));
    recording.setCode(QStringLiteral("WALL"));
    recording.setTargetHeightText(QStringLiteral("1.5"));
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(turnTo(9, 97));
    recording.setPointId(QStringLiteral("8"));
    recording.setCode(QStringLiteral("DOOR"));
    recording.setTargetHeightText(QStringLiteral("0.2"));
    recording.record();  // still no job
    job_desk.open(jobPath());
    ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));
    recording.record();
    ASSERT_TRUE(until([this] { return points.points().size() == 1; }));
    EXPECT_EQ(points.points()[0].id, QStringLiteral("7"));
    EXPECT_EQ(points.points()[0].code, QStringLiteral("WALL"));
    EXPECT_DOUBLE_EQ(points.points()[0].observation.target_height_m, 1.5);
}

TEST_F(RecordingPresenterTest, SpaceWithoutAJobIsForgottenAndMeasuresNothingLater) {
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(turnTo(9, 97));
    recording.all();
    job_desk.open(jobPath());
    ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));
    recording.record();
    ASSERT_TRUE(until([this] { return points.points().size() == 1; }));
    pass(20s);
    EXPECT_EQ(points.points().size(), 1U) << "nobody asked for the second";
    EXPECT_EQ(recording.readings().shot, ShotState::kRecorded);
}

TEST_F(RecordingPresenterTest, TypedIdThatIsUsedIsAskedAboutBeforeItIsRecorded) {
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("1"));
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(points.points().size(), 1U);
    EXPECT_EQ(recording.readings().shot, ShotState::kConverted) << "the shot is kept";
    EXPECT_THAT(newestBar(messages).toStdString(),
                testing::AllOf(testing::HasSubstr("has a point 1 already"), testing::HasSubstr("2 is free")));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kRecordSameId);
}

TEST_F(RecordingPresenterTest, SecondRRecordsUnderTheUsedIdAndTheNextIdIsFree) {
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("1"));
    ASSERT_TRUE(recordPoint());
    recording.record();
    pass(1s);
    ASSERT_EQ(points.points().size(), 3U);
    EXPECT_EQ(points.points()[2].id, QStringLiteral("1"));
    EXPECT_TRUE(points.data(points.index(0, 0), PointsModel::kDuplicateRole).toBool());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("two points 1"));
    EXPECT_EQ(recording.pointId(), QStringLiteral("3"));
}

TEST_F(RecordingPresenterTest, AnotherIdAnswersTheQuestion) {
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("1"));
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("1a"));
    EXPECT_TRUE(messages.bars().empty());
    recording.record();
    pass(1s);
    ASSERT_EQ(points.points().size(), 2U);
    EXPECT_EQ(points.points()[1].id, QStringLiteral("1a"));
    EXPECT_EQ(recording.pointId(), QStringLiteral("2a"));
}

TEST_F(RecordingPresenterTest, ProposedIdSkipsWhatIsUsedInTheJob) {
    recording.setPointId(QStringLiteral("2"));
    ASSERT_TRUE(recordPoint());
    recording.setPointId(QStringLiteral("1"));
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(recording.pointId(), QStringLiteral("3"));
    points.edit(points.points()[0].row_id, QStringLiteral("3"), {}, {});
    EXPECT_EQ(recording.pointId(), QStringLiteral("4")) << "renamed in the table to what was proposed";
    points.strikeOut({points.points()[0].row_id});
    job_desk.close();
    pass(1s);
    openAgain();
    EXPECT_EQ(recording.pointId(), QStringLiteral("4")) << "kept over closing, and 3 may be restored";
}

TEST_F(RecordingPresenterTest, EdmModeIsSetOnTheInstrumentAndRemembered) {
    QSignalSpy changed(&recording, &RecordingPresenter::modeChanged);
    recording.setMode(instrument::EdmMode::kFstd);
    ASSERT_TRUE(until([&] { return !changed.empty(); }));
    EXPECT_THAT(sent, testing::HasSubstr("PG,3=3\r"));
    EXPECT_EQ(preferences.settings().edm_mode, instrument::EdmMode::kFstd);
    ASSERT_TRUE(measure());
    EXPECT_LT(recording.readings().time_taken.split(u' ').first().toDouble(), 3.0) << "fast standard: 1 s";
}

TEST_F(RecordingPresenterTest, BlockOfTheRegKeyIsOfferedAndRecordedOnAccept) {
    standAt(10, 100);
    QSignalSpy offered(&recording, &RecordingPresenter::blockOffered);
    Q_EMIT instrument.unsolicitedBlock({.ha = Angle::fromGon(10), .va = Angle::fromGon(100), .slope_distance_m = 20.0,
                                        .n_m = {}, .e_m = {}, .h_m = {}, .point_number = QStringLiteral("77"),
                                        .point_code = QStringLiteral("TREE"), .raw = QStringLiteral("7=10\r\n8=100\r\n9=20")});
    ASSERT_EQ(offered.size(), 1);
    EXPECT_TRUE(points.points().empty());

    recording.acceptBlock();
    pass(1s);

    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_EQ(points.points()[0].id, QStringLiteral("77"));
    EXPECT_EQ(points.points()[0].observation.source, QStringLiteral("reg_key"));
    EXPECT_NEAR(points.points()[0].coordinates.e_m, 1000 + 20 * std::sin(10 * M_PI / 200), 1e-6);
    EXPECT_EQ(recording.pointId(), QStringLiteral("1")) << "the own numbering goes on";
}

TEST_F(RecordingPresenterTest, BlockOfTheRegKeyIsRecordedAtOnceWhenTheSettingSaysSo) {
    standAt(10, 100);
    preferences.setUnsolicitedPolicy(UnsolicitedPolicy::kRecord);
    Q_EMIT instrument.unsolicitedBlock({.ha = Angle::fromGon(10), .va = Angle::fromGon(100), .slope_distance_m = 20.0,
                                        .n_m = {}, .e_m = {}, .h_m = {}, .point_number = {}, .point_code = {}, .raw = {}});
    pass(1s);
    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_EQ(recording.pointId(), QStringLiteral("2"));
}

TEST_F(RecordingPresenterTest, RegKeyPressedAtTheInstrumentBecomesAPoint) {
    // Arrange: the operator measures at the instrument's own keyboard.
    ASSERT_TRUE(turnTo(20, 99));
    station.receive("TG\r");
    pass(7s);
    QSignalSpy offered(&recording, &RecordingPresenter::blockOffered);

    // Act
    station.pressRegKey();
    ASSERT_TRUE(until([&] { return !offered.empty(); })) << newestBar(messages).toStdString();
    recording.acceptBlock();
    ASSERT_TRUE(until([this] { return !points.points().empty(); }));

    // Assert: the wall at 15 m north; E by tan 20 gon, H by 1 gon above the horizon.
    const survey::Point& point = points.points().front();
    EXPECT_EQ(point.observation.source, QStringLiteral("reg_key"));
    EXPECT_NEAR(point.coordinates.n_m, 1015.0, 0.015);
    EXPECT_NEAR(point.coordinates.e_m, 1000 + 15 * std::tan(20 * M_PI / 200), 0.015);
    EXPECT_THAT(points.data(points.index(0, PointsModel::kNote), Qt::DisplayRole).toString().toStdString(),
                testing::HasSubstr("registered at the instrument"));
    EXPECT_FALSE(point.observation.raw_reply.isEmpty());
}

TEST_F(RecordingPresenterTest, ABlockThatLostADigitOnTheWireIsNeitherOfferedNorRecorded) {
    ASSERT_TRUE(turnTo(351.6817, 98));
    pass(5s);
    const auto circles = instrument.track().newest()->pointing;
    const auto block = [&](core::Angle ha) {
        return instrument::UnsolicitedBlock{.ha = ha, .va = circles.va, .slope_distance_m = 20.0, .n_m = {}, .e_m = {},
                                            .h_m = {}, .point_number = {}, .point_code = {}, .raw = {}};
    };
    for (const auto policy : {UnsolicitedPolicy::kRecord, UnsolicitedPolicy::kOffer}) {
        preferences.setUnsolicitedPolicy(policy);
        for (const double damaged_gon : {351.687, 31.6817}) {
            Q_EMIT instrument.unsolicitedBlock(block(Angle::fromGon(damaged_gon)));
            pass(1s);
            EXPECT_TRUE(points.points().empty());
            EXPECT_FALSE(recording.offeredBlock());
            EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("arrived damaged"))) << newestBar(messages).toStdString();
        }
    }
    Q_EMIT instrument.unsolicitedBlock(block(circles.ha));
    EXPECT_TRUE(recording.offeredBlock());
}

TEST_F(RecordingPresenterTest, WhereThePanelHasControlABlockIsNotComparedWithCirclesOfLongAgo) {
    ControlSettings control;
    control.panel.emplace();
    control.panel->path = QStringLiteral("panel");
    control.mode = scheduler::ControlMode::kPanel;
    instrument.setControl(control);
    standAt(77, 95);
    Q_EMIT instrument.unsolicitedBlock({.ha = Angle::fromGon(77), .va = Angle::fromGon(95), .slope_distance_m = 20.0, .n_m = {},
                                        .e_m = {}, .h_m = {}, .point_number = {}, .point_code = {}, .raw = {}});
    EXPECT_TRUE(recording.offeredBlock()) << newestBar(messages).toStdString();
}

TEST_F(RecordingPresenterTest, ABlockCarriesTheTimeOfDayOfTheProgramsClockAlsoAfterItWasSet) {
    standAt(10, 100);
    preferences.setUnsolicitedPolicy(UnsolicitedPolicy::kRecord);
    for (const std::chrono::hours jump : {std::chrono::hours(0), std::chrono::hours(-30 * 24), std::chrono::hours(60 * 24)}) {
        clock.setTimeOfDayBy(jump);
        const QDateTime now = clock.utcNow();
        Q_EMIT instrument.unsolicitedBlock({.ha = Angle::fromGon(10), .va = Angle::fromGon(100), .slope_distance_m = 20.0,
                                            .n_m = {}, .e_m = {}, .h_m = {}, .point_number = {}, .point_code = {}, .raw = {}});
        const std::size_t before = points.points().size();
        ASSERT_TRUE(until([&] { return points.points().size() > before; }));
        EXPECT_EQ(points.points().back().observation.utc.msecsTo(now), 0);
    }
}

TEST_F(RecordingPresenterTest, RegKeyWithoutADistanceIsADirectionWithItsReason) {
    preferences.setUnsolicitedPolicy(UnsolicitedPolicy::kRecord);
    station.pressRegKey();
    ASSERT_TRUE(until([this] { return !points.points().empty(); }));
    EXPECT_FALSE(points.points()[0].hasCoordinates());
    EXPECT_THAT(points.points()[0].observation.absurd_reason.toStdString(), testing::HasSubstr("no distance"));
}

TEST_F(RecordingPresenterTest, BlockWithOnlyCoordinatesSaysWhatToSetOnTheInstrument) {
    Q_EMIT instrument.unsolicitedBlock({.ha = {}, .va = {}, .slope_distance_m = {}, .n_m = 20.0, .e_m = 3.0, .h_m = 1.0,
                                        .point_number = {}, .point_code = {}, .raw = QStringLiteral("37=20.000")});
    EXPECT_THAT(newestBar(messages).toStdString(),
                testing::AllOf(testing::HasSubstr("only coordinates"), testing::HasSubstr("output table 0 (HA, VA, SD)")));
    EXPECT_FALSE(recording.offeredBlock().has_value());
}

TEST_F(RecordingPresenterTest, TypedTargetHeightThatCannotBeReadIsRefused) {
    QSignalSpy refused(&recording, &RecordingPresenter::targetHeightRejected);
    recording.setTargetHeightText(QStringLiteral("tall"));
    EXPECT_EQ(refused.size(), 1);
    EXPECT_EQ(preferences.settings().target_height_m, 0.0);
}

/// The operator has chosen slave mode on the instrument: a block with every distance.
class SlaveModeTest : public FieldTest {
protected:
    SlaveModeTest() : FieldTest(slave()) {}
    void SetUp() override {
        connectInstrument();
        openJob();
    }

private:
    static simulator::StationSettings slave() {
        simulator::StationSettings settings;
        settings.output = QStringLiteral("slave");
        return settings;
    }
};

TEST_F(SlaveModeTest, BlockOfAnOwnShotIsMarkedAsSlaveWhenAllBlocksAreRecorded) {
    preferences.setUnsolicitedPolicy(UnsolicitedPolicy::kRecord);
    ASSERT_TRUE(measure());
    pass(1s);
    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_EQ(points.points()[0].observation.source, QStringLiteral("slave"));
    EXPECT_NEAR(points.points()[0].coordinates.n_m, 1015.0, 0.015);
}

TEST_F(SlaveModeTest, BlockOfAnOwnShotIsNotOfferedASecondTime) {
    ASSERT_TRUE(recordPoint());
    pass(1s);
    EXPECT_EQ(recording.readings().shot, ShotState::kRecorded) << recording.readings().sentence.toStdString();
    EXPECT_FALSE(recording.offeredBlock().has_value());
    EXPECT_EQ(points.points().size(), 1U);
}

TEST_F(SlaveModeTest, StreamOfATrackingInstrumentIsMarkedAsSlave) {
    preferences.setUnsolicitedPolicy(UnsolicitedPolicy::kRecord);
    station.receive("PG,3=1\rTG\r");
    ASSERT_TRUE(until([this] { return points.points().size() >= 3; }));
    EXPECT_EQ(points.points()[2].observation.source, QStringLiteral("slave"));
}

}  // namespace
}  // namespace pmts::app
