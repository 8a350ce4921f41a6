#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using test::IsNearAngle;

class StationMotionTest : public StationTest {
protected:
    void target(const char* ha, const char* va) {
        ASSERT_EQ(ask(std::string("WG,27=") + ha), ">");
        ASSERT_EQ(ask(std::string("WG,26=") + va), ">");
    }
};

TEST_F(StationMotionTest, TurnsBothAxesAndAnswersWhenTheyHaveSettled) {
    target("100.0000", "90.0000");
    EXPECT_EQ(ask("WS=PH02V02", 3499ms), "");  // 100 gon: 2.5 s, and 1 s to settle
    clock.advance(2ms);
    EXPECT_EQ(heard(), ">");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(100), Angle::fromCc(2)));
    EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(90), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, MovesWithFiniteSpeed) {
    target("100.0000", "100.0000");
    ask("WS=PH02V02", 1250ms);
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(50), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, OneAxisMovesAlone) {
    target("10.0000", "90.0000");
    EXPECT_EQ(ask("WS=PH01", 5s), ">");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(10), Angle::fromCc(1)));
    EXPECT_EQ(truth().va.gon(), 100.0);
    EXPECT_EQ(ask("WS=PV15", 5s), ">");
    EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(90), Angle::fromCc(15)));
}

TEST_F(StationMotionTest, TakesTheShortWayRound) {
    target("390.0000", "100.0000");
    ask("WS=PH02", 300ms);
    EXPECT_GT(truth().ha.gon(), 385.0);
}

TEST_F(StationMotionTest, ChangesFaceThroughTheZenith) {
    target("200.0000", "300.0000");
    ask("WS=PH02V02", 2250ms);  // half of 200 gon
    EXPECT_THAT(truth().va, IsNearAngle(Angle{}, Angle::fromGon(0.1)));
    clock.advance(10s);
    EXPECT_EQ(heard(), ">");
    EXPECT_NEAR(truth().va.gon(), 300.0, 2e-4);
}

TEST_F(StationMotionTest, WithoutNewTargetsItUsesTheLastOnes) {
    target("50.0000", "80.0000");
    ask("WS=PH02V02", 10s);
    point(0.0, 100.0);
    EXPECT_EQ(ask("WS=PH02V02", 10s), ">");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(50), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, FinalErrorIsWithinAnyTolerance) {
    for (int shot = 0; shot < 40; ++shot) {
        point(0.0, 100.0);
        target("20.0000", "95.0000");
        ask(shot % 2 == 0 ? "WS=PH50V50" : "WS=PH00V00", 10s);
        const Angle allowed = Angle::fromCc(shot % 2 == 0 ? 50 : 2);
        EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(20), allowed));
        EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(95), allowed));
    }
}

TEST_F(StationMotionTest, ArrivesOnTheCirclesNotOnTheTruth) {
    settings.collimation = Angle::fromMgon(10);
    settings.index_error = Angle::fromMgon(5);
    target("50.0000", "100.0000");
    ask("WS=PH01V01", 10s);
    EXPECT_NEAR(std::stod(ask("RG,7").substr(2)), 50.0, 1.5e-4);  // 1 cc and the rounding of the text
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(49.99), Angle::fromCc(1)));
    EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(99.995), Angle::fromCc(1)));
}

TEST_F(StationMotionTest, ReferenceAngleTurnsTheTargetsToo) {
    EXPECT_EQ(ask("WG,21=150.0000"), ">");
    EXPECT_EQ(ask("RG,7"), "7=150.0000\r\n>");
    target("160.0000", "100.0000");
    ask("WS=PH02", 10s);
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(10), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, TargetsInDmsAreUnderstood) {
    settings.unit_status = QStringLiteral("1112");
    target("45.0000", "81.0000");
    EXPECT_EQ(ask("WS=PH02V02", 10s), ">");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(50), Angle::fromCc(2)));
    EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(90), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, OutsideTheMechanicalRangeIsInfo160Or153) {
    target("0.0000", "200.0000");
    EXPECT_EQ(ask("WS=PH02V02", 10s), "160\r\n>");
    target("0.0000", "450.0000");
    EXPECT_EQ(ask("WS=PV02", 10s), "160\r\n>");
    EXPECT_EQ(truth().va.gon(), 100.0);
}

TEST_F(StationMotionTest, OutOfRangeMayBeTheEndSwitch) {
    settings.out_of_range_status = 153;
    target("0.0000", "200.0000");
    EXPECT_EQ(ask("WS=PV02"), "153\r\n>");
}

TEST_F(StationMotionTest, MalformedPositionCommandIsASyntaxError) {
    for (const char* command : {"WS=", "WS", "WS=P", "WS=PH", "WS=PH2", "WS=PX02", "WS=PH02V", "WS=H02",
                                "WS=PH-2", "WS=PH02V02H"}) {
        EXPECT_EQ(ask(command, 10s), "30\r\n>") << command;
    }
}

TEST_F(StationMotionTest, ModeCommandStopsTheMotion) {
    target("190.0000", "100.0000");
    ask("WS=PH02V02", 1s);
    EXPECT_EQ(ask("PG,3=0"), "190\r\n>>");
    clock.advance(10s);
    // 37.5 gon after 1 s at full speed, and 12.5 gon to brake.
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(50), Angle::fromCc(1)));
}

TEST_F(StationMotionTest, ModeCommandMayHaveToWaitForTheMotion) {
    settings.mode_command_stops_motion = false;
    target("100.0000", "100.0000");
    ask("WS=PH02V02", 1s);
    EXPECT_EQ(ask("PG,3=0", 1s), "");
    clock.advance(10s);
    EXPECT_EQ(heard(), ">>");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(100), Angle::fromCc(2)));
}

TEST_F(StationMotionTest, DistanceWaitsUntilTheAxesStand) {
    ask("PG,3=3");
    target("100.0000", "100.0000");
    ask("TG");
    EXPECT_EQ(ask("WS=PH02", 3501ms), ">");
    EXPECT_EQ(ask("RG,9"), "7\r\n>");  // FSTD would have been there after 1 s
    clock.advance(500ms);
    EXPECT_EQ(ask("RG,9"), "9=100.000\r\n>");
}

TEST_F(StationMotionTest, TimeScaleMakesMotorsFaster) {
    settings.time_scale = 10.0;
    target("100.0000", "100.0000");
    EXPECT_EQ(ask("WS=PH02", 351ms), ">");
    ask("TG", 500ms);
    EXPECT_EQ(ask("RG,9"), "9=100.000\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
