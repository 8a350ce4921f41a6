#include "driver_bench.hpp"

namespace pmts::end_to_end {
namespace {

/// A fault somewhere in a working day: what was acknowledged is right, and the next point is right again.
class PassingFaultTest : public testing::TestWithParam<const char*> {};

TEST_P(PassingFaultTest, NeverGivesAWrongPointAndLeavesNothingBehind) {
    DriverBench bench;
    bench.connect();
    ASSERT_TRUE(bench.turn(10.0, 98.0).has_value());
    ASSERT_TRUE(bench.measure().has_value());
    bench.fault(GetParam());

    const auto arrived = bench.turn(25.0, 96.0);
    if (arrived) {
        EXPECT_THAT(bench.truth->at(bench.clock.now()).ha,
                    test::IsNearAngle(Angle::fromGon(25), Angle::fromCc(20)));
    }
    if (const auto shot = bench.measure()) {
        EXPECT_TRUE(bench.isRight(*shot));
    }
    (void)bench.station.injectFault(QStringLiteral("none"));
    ASSERT_TRUE(bench.turn(110.0, 95.0).has_value());
    const auto shot = bench.measure();
    ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
    EXPECT_TRUE(bench.isRight(*shot));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, PassingFaultTest,
    testing::Values("silent", "silent,on=WG", "silent,on=WS", "silent,on=TG", "silent,on=RG",
                    "silent,on=RG,times=3", "late=1", "late=3,on=WG", "late=3,on=WS", "late=4,on=TG",
                    "late=2,on=RG", "twice", "twice,on=WG,times=4", "twice,on=WS", "twice,on=TG",
                    "twice,on=RG,times=5", "garble", "garble,on=RG,times=5", "garble,on=WG,times=3",
                    "half_block", "half_block,on=RG,times=4", "missing_eot", "missing_eot,on=WS",
                    "missing_eot,on=TG", "missing_eot,on=RG,times=3", "stray_end_marks",
                    "stray_end_marks,on=WS", "stray_end_marks,on=TG", "stray_end_marks,on=RG,times=9",
                    "line_error", "line_error=12,on=TG", "line_error=4,on=WS", "info=207,on=WG",
                    "info=197,on=WS", "info=23,on=TG", "info=30,on=RG", "info=4,on=RG", "info=3,on=RG",
                    "info=7,on=RG", "panel_task=3", "initialising=5", "distance_late=20", "distance_jump",
                    "target_lost", "target_not_found", "residual_h=20", "residual_v=18", "motor_overload_h",
                    "motor_overload_v", "end_switch", "no_signal", "tg_ignored", "no_cu", "info_23_loop=0.7",
                    "reg_key", "garble=0.01", "drop=0.02"));

/// Faults the driver gets over by itself: the surveyor never hears of them.
class HealedFaultTest : public testing::TestWithParam<const char*> {};

TEST_P(HealedFaultTest, IsNotTheSurveyorsBusiness) {
    DriverBench bench;
    bench.connect();
    ASSERT_TRUE(bench.turn(10.0, 98.0).has_value());
    ASSERT_TRUE(bench.measure().has_value());
    bench.fault(GetParam());

    ASSERT_TRUE(bench.turn(25.0, 96.0).has_value());
    const auto shot = bench.measure();
    ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
    EXPECT_TRUE(bench.isRight(*shot));
}

INSTANTIATE_TEST_SUITE_P(Faults, HealedFaultTest,
                         testing::Values("silent,on=WG", "silent,on=RG", "late=1", "twice",
                                         "twice,on=RG,times=5", "garble,on=RG", "half_block,on=RG",
                                         "missing_eot,on=WS", "stray_end_marks", "line_error=4,on=WG",
                                         "info=207,on=WG", "info=197,on=WG", "distance_jump", "reg_key"));

TEST(DriverWithFaults, AServoThatStopsShortIsInfo156) {
    DriverBench bench;
    bench.connect();
    bench.fault("residual_v=18");
    const auto arrived = bench.turn(177.5612, 96.1684);

    ASSERT_THAT(arrived, test::FailedWith(ErrorKind::kNotReached));
    EXPECT_EQ(arrived.error().info_code, 156);
    EXPECT_THAT(bench.truth->at(bench.clock.now()).va,
                test::IsNearAngle(Angle::fromGon(96.1702), Angle::fromCc(1)));
}

TEST(DriverWithFaults, ALostTargetAndABadServoKeepTheirCodes) {
    for (const auto& [fault, code] :
         {std::pair{"motor_overload_h", 151}, {"end_switch", 153}, {"target_not_found", 158}}) {
        DriverBench bench;
        bench.connect();
        bench.fault(fault);
        const auto arrived = bench.turn(25.0, 96.0);
        ASSERT_FALSE(arrived.has_value()) << fault;
        EXPECT_EQ(arrived.error().info_code, code);
    }
    DriverBench bench;
    bench.connect();
    bench.fault("target_lost");
    EXPECT_EQ(bench.measure().error().info_code, 161);
}

TEST(DriverWithFaults, ATiltedInstrumentSaysSo) {
    DriverBench bench;
    bench.connect();
    bench.fault("level_loss");
    const auto read = bench.run(bench.driver.readPointing({}));

    ASSERT_THAT(read, test::FailedWith(ErrorKind::kDevice));
    EXPECT_EQ(read.error().info_code, 1);
}

TEST(DriverWithFaults, APulledCableEndsTheMotionAndTheShot) {
    for (const core::Duration after : {core::Duration(500ms), core::Duration(6s)}) {
        DriverBench bench;
        bench.connect();
        const auto timer = bench.clock.callAfter(after, [&] { bench.wire.first->unplug(); });
        const auto arrived = bench.turn(190.0, 96.0);
        const auto shot = bench.measure();
        EXPECT_THAT(shot, testing::Not(testing::ResultOf([](const auto& s) { return s.has_value(); }, true)));
        EXPECT_EQ(arrived.has_value(), after > 5s);
        EXPECT_FALSE(bench.driver.isBusy());
    }
}

TEST(DriverWithFaults, EveryFaultTheSimulatorKnowsEndsInAnAnswer) {
    for (const QString& name : simulator::Station::faultNames()) {
        DriverBench bench;
        bench.connect();
        ASSERT_TRUE(bench.station.injectFault(name).has_value()) << name.toStdString();
        (void)bench.turn(25.0, 96.0);
        if (const auto shot = bench.measure()) {
            EXPECT_TRUE(bench.isRight(*shot)) << name.toStdString();
        }
        EXPECT_FALSE(bench.driver.isBusy()) << name.toStdString();
    }
}

}  // namespace
}  // namespace pmts::end_to_end
