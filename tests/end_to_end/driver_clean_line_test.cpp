#include "driver_bench.hpp"
#include "pmts/instrument/pointing_poller.hpp"

namespace pmts::end_to_end {
namespace {

using instrument::EdmMode;

TEST(DriverOnACleanLine, ConnectsAndKnowsWhoIsThere) {
    DriverBench bench;
    const auto identity = bench.run(bench.driver.connectTo({}));

    ASSERT_TRUE(identity.has_value());
    EXPECT_EQ(identity->serial_number, QStringLiteral("620123"));
    EXPECT_EQ(bench.line.counts().timed_out, 0U);
}

TEST(DriverOnACleanLine, TurnsAndMeasuresTheTruth) {
    DriverBench bench;
    bench.connect();
    for (const auto& [ha, va] : {std::pair{0.0, 100.0}, {30.5, 96.1684}, {110.25, 110.0}, {380.0, 80.0}}) {
        const auto arrived = bench.turn(ha, va);
        ASSERT_TRUE(arrived.has_value()) << arrived.error().sentence().toStdString();
        const auto shot = bench.measure();
        ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
        EXPECT_TRUE(bench.isRight(*shot));
        EXPECT_THAT(bench.truth->at(bench.clock.now()).ha,
                    test::IsNearAngle(Angle::fromGon(ha), Angle::fromCc(16)));
    }
    EXPECT_EQ(bench.line.counts().timed_out + bench.line.counts().late + bench.line.counts().unsolicited, 0U);
}

class UnitTest : public testing::TestWithParam<const char*> {};

TEST_P(UnitTest, TurnsAndMeasuresTheTruthInEveryUnit) {
    DriverBench bench(with(&StationSettings::unit_status, QString::fromLatin1(GetParam())));
    bench.connect();
    ASSERT_TRUE(bench.turn(111.1111, 93.3333).has_value());
    const auto shot = bench.measure();

    ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
    EXPECT_TRUE(bench.isRight(*shot));
}

INSTANTIATE_TEST_SUITE_P(AllUnits, UnitTest,
                         testing::Values("1111", "1112", "1113", "1114", "1121", "1122", "3222", "2114"));

class ModeTest : public testing::TestWithParam<EdmMode> {};

TEST_P(ModeTest, MeasuresTheTruthInEveryMode) {
    DriverBench bench;
    bench.connect();
    ASSERT_TRUE(bench.run(bench.driver.setMode(GetParam())).has_value());
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    for (int i = 0; i < 3; ++i) {
        const auto shot = bench.measure();
        ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
        EXPECT_NEAR(shot->slope_distance_m, bench.scene->echo(bench.truth->at(bench.clock.now()))->distance_m,
                    0.05);
        EXPECT_EQ(shot->mode, GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(AllModes, ModeTest,
                         testing::Values(EdmMode::kStd, EdmMode::kTrk, EdmMode::kDBar, EdmMode::kFstd,
                                         EdmMode::kDBarHighResolution));

class AlternativeTest : public testing::TestWithParam<const char*> {};

TEST_P(AlternativeTest, WhatAnInstrumentSaysWhileItMeasuresMakesNoDifference) {
    DriverBench bench(with(&StationSettings::reading_while_measuring, QString::fromLatin1(GetParam())));
    bench.connect();
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    for (int i = 0; i < 2; ++i) {
        const auto shot = bench.measure();
        ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
        EXPECT_TRUE(bench.isRight(*shot));
    }
}

INSTANTIATE_TEST_SUITE_P(WhileMeasuring, AlternativeTest, testing::Values("angles", "4", "7", "4+angles"));

TEST(DriverOnACleanLine, ATriggerThatAnswersAtTheEndIsTheSame) {
    DriverBench bench(with(&StationSettings::trigger_ends_late, true));
    bench.connect();
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    const auto shot = bench.measure();

    ASSERT_TRUE(shot.has_value());
    EXPECT_TRUE(bench.isRight(*shot));
}

TEST(DriverOnACleanLine, AnotherEndMarkAndNoneAreUnderstood) {
    for (const int mark : {4, 35, 0}) {
        DriverBench bench(with(&StationSettings::end_mark, mark));
        bench.connect();
        ASSERT_TRUE(bench.turn(20.0, 98.0).has_value()) << mark;
        const auto shot = bench.measure();
        ASSERT_TRUE(shot.has_value()) << mark << ' ' << shot.error().sentence().toStdString();
        EXPECT_TRUE(bench.isRight(*shot));
    }
}

TEST(DriverOnACleanLine, AnAbsorbingWallIsAnAbsurdPoint) {
    DriverBench bench;
    bench.connect();
    ASSERT_TRUE(bench.turn(200.0, 100.0).has_value());
    EXPECT_THAT(bench.measure(), test::FailedWith(ErrorKind::kAbsurdPoint));
    EXPECT_EQ(bench.run(bench.driver.testSignal({})).value(), false);
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    const auto shot = bench.measure();  // the terminated shot leaves nothing behind
    ASSERT_TRUE(shot.has_value());
    EXPECT_TRUE(bench.isRight(*shot));
}

TEST(DriverOnACleanLine, ABareBodyWithoutControlUnitTurnsButGivesNoDistance) {
    DriverBench bench(with(&StationSettings::bare_station, true));
    bench.connect();
    EXPECT_TRUE(bench.turn(20.0, 98.0).has_value());
    EXPECT_FALSE(bench.measure().has_value());
}

TEST(DriverOnACleanLine, StopEndsTheMotionUnderWay) {
    DriverBench bench;
    bench.connect();
    const auto timer = bench.clock.callAfter(1s, [&] { bench.driver.stop(); });
    const auto arrived = bench.turn(200.0, 100.0);

    EXPECT_THAT(arrived, test::FailedWith(ErrorKind::kCancelled));
    bench.clock.advance(5s);
    EXPECT_GT(
        core::abs(core::normalizedSigned(bench.truth->at(bench.clock.now()).ha - Angle::fromGon(200))).gon(),
        50.0);
    EXPECT_TRUE(bench.turn(20.0, 98.0).has_value());
}

TEST(DriverOnACleanLine, BlockedAndForbiddenDirectionsGoUp) {
    DriverBench bench;
    bench.connect();
    const auto blocked = bench.turn(20.0, 190.0);
    ASSERT_THAT(blocked, test::FailedWith(ErrorKind::kDevice));
    EXPECT_EQ(blocked.error().info_code, 160);
}

TEST(DriverOnACleanLine, LabelsAreWrittenAndReadBack) {
    DriverBench bench;
    bench.connect();
    for (const auto& [label, value] :
         {std::pair{30, "12.5"}, {5, "WALL 7"}, {37, "1000.25"}, {3, "1.55"}, {20, "0.012"}}) {
        ASSERT_TRUE(bench.run(bench.driver.set(label, QString::fromLatin1(value), {})).has_value()) << label;
        EXPECT_TRUE(bench.run(bench.driver.get(label, {})).has_value());
    }
    const auto too_much = bench.run(bench.driver.set(30, QStringLiteral("500"), {}));
    ASSERT_FALSE(too_much.has_value());
    EXPECT_EQ(too_much.error().info_code, 35);
}

TEST(DriverOnACleanLine, TheRegKeyGivesAPointAtAnyTime) {
    DriverBench bench(with(&StationSettings::output, QStringLiteral("reg_key")));
    bench.connect();
    std::vector<instrument::UnsolicitedBlock> blocks;
    bench.driver.on_unsolicited = [&](const auto& block) { blocks.push_back(block); };
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    bench.station.pressRegKey();
    bench.clock.advance(1s);

    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_THAT(blocks[0].ha.value(), test::IsNearAngle(Angle::fromGon(20), Angle::fromCc(25)));
}

TEST(DriverOnACleanLine, SlaveModeBlocksDoNotDisturbTheShots) {
    DriverBench bench(with(&StationSettings::output, QStringLiteral("slave")));
    bench.connect();
    ASSERT_TRUE(bench.turn(20.0, 98.0).has_value());
    for (int i = 0; i < 3; ++i) {
        const auto shot = bench.measure();
        ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
        EXPECT_TRUE(bench.isRight(*shot));
    }
}

TEST(DriverOnACleanLine, ThePollerKeepsThePointingFreshBetweenShots) {
    DriverBench bench;
    bench.connect();
    int readings = 0;
    bench.driver.on_pointing = [&](const geometry::Pointing&, core::Duration) { ++readings; };
    instrument::PointingPoller poller(bench.driver, bench.clock);
    poller.start();
    bench.clock.advance(10s);

    EXPECT_GE(readings, 50);
    readings = 0;
    ASSERT_TRUE(bench.measure().has_value());
    EXPECT_GE(readings, 25);  // five seconds of measuring, five a second
}

}  // namespace
}  // namespace pmts::end_to_end
