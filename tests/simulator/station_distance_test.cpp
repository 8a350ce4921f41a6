#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using testing::HasSubstr;
using testing::Not;

class StationDistanceTest : public StationTest {
protected:
    bool hasDistance() { return ask("RG,9").starts_with("9="); }
    /// Time from now until label 9 can be read, in steps of 10 ms.
    core::Duration untilDistance(core::Duration limit) {
        core::Duration waited{0};
        while (!hasDistance() && waited < limit) {
            clock.advance(10ms);
            waited += 10ms;
        }
        return waited;
    }
};

TEST_F(StationDistanceTest, TriggerIsAcknowledgedAtOnceAndTakesFiveSecondsInStd) {
    EXPECT_EQ(ask("TG"), ">");
    EXPECT_EQ(untilDistance(10s), 5s);
}

TEST_F(StationDistanceTest, AcknowledgementMayComeAtTheEnd) {
    settings.trigger_ends_late = true;
    EXPECT_EQ(ask("TG", 4990ms), "");
    clock.advance(10ms);
    EXPECT_EQ(heard(), ">");
    EXPECT_TRUE(hasDistance());
}

TEST_F(StationDistanceTest, EveryModeHasItsTime) {
    const std::vector<std::pair<const char*, core::Duration>> first_reading{
        {"PG,3=0", 5s}, {"PG,3=1", 400ms}, {"PG,3=2", 5s}, {"PG,3=3", 1s}, {"PG,3=4", 5s}};
    for (const auto& [mode, time] : first_reading) {
        EXPECT_EQ(ask(mode), ">");
        ask("TG");
        EXPECT_EQ(untilDistance(10s), time) << mode;
    }
}

TEST_F(StationDistanceTest, LongRangeTakesSevenSeconds) {
    EXPECT_EQ(ask("TG>"), ">");
    EXPECT_EQ(untilDistance(10s), 7s);
    ask("TG<");
    EXPECT_EQ(untilDistance(10s), 5s);
}

TEST_F(StationDistanceTest, ReflectorlessTimeGrowsWithTheDistance) {
    settings.reflectorless = true;
    point(100.0, 100.0);
    ask("TG");
    EXPECT_NEAR(std::chrono::duration<double>(untilDistance(10s)).count(), 4.0,
                0.011);  // 2 s + 0.02 s/m * 100 m
}

TEST_F(StationDistanceTest, ModeOutsideZeroToFourIsBadData) {
    for (const char* command : {"PG,3=5", "PG,3=-1", "PG,3=", "PG,3", "PG,3=12"}) {
        EXPECT_EQ(ask(command), "35\r\n>") << command;
    }
}

TEST_F(StationDistanceTest, ModeCommandEndsARunningMeasurement) {
    ask("TG", 3s);
    EXPECT_EQ(ask("PG,3=0", 10s), ">");
    EXPECT_FALSE(hasDistance());
    EXPECT_EQ(ask("RG"), "0\r\n7=0.0000\r\n8=100.0000\r\n>");
}

TEST_F(StationDistanceTest, ModeCommandBreaksATriggerThatIsStillWaiting) {
    settings.trigger_ends_late = true;
    point(200.0, 100.0);
    EXPECT_EQ(ask("TG", 1min), "");
    EXPECT_EQ(ask("PG,3=0"), "190\r\n>>");
}

TEST_F(StationDistanceTest, TrackingGivesANewDistanceEvery400Milliseconds) {
    ask("PG,3=1");
    ask("TG", 400ms);
    EXPECT_THAT(ask("RG"), HasSubstr("9=20.000"));
    EXPECT_EQ(ask("RG"), "3\r\n>");
    clock.advance(400ms);
    EXPECT_THAT(ask("RG"), HasSubstr("9=20.000"));
}

TEST_F(StationDistanceTest, TrackingFollowsTheTelescope) {
    ask("PG,3=1");
    ask("TG", 400ms);
    point(100.0, 100.0);
    clock.advance(400ms);
    EXPECT_THAT(ask("RG"), HasSubstr("9=100.000"));
}

TEST_F(StationDistanceTest, TrackingWorksInFaceOneOnly) {
    ask("PG,3=1");
    point(200.0, 300.0);
    EXPECT_EQ(ask("TG"), "2\r\n>");
}

TEST_F(StationDistanceTest, DBarAveragesUntilTheSecondTrigger) {
    settings.d_bar_accuracy = {0.006, 2.0};
    ask("PG,3=2");
    ask("TG", 20s);
    ask("TG");
    const std::string mean = ask("RG,9");
    EXPECT_NEAR(std::stod(mean.substr(2)), 20.0, 4 * 0.006 / 4.0);  // four sigma of the mean of sixteen
    EXPECT_EQ(ask("RG,9", 1min), mean);
    EXPECT_NEAR(std::stod(ask("RG,46").substr(3)), 0.0015, 0.001);
}

TEST_F(StationDistanceTest, DistancesScatterAsTheModeAllows) {
    settings.edm_sigma_m = 0.003;
    settings.edm_sigma_ppm = 3.0;
    double squares = 0.0;
    constexpr int kShots = 200;
    for (int i = 0; i < kShots; ++i) {
        ask("TG", 5s);
        const double off = std::stod(ask("RG,9").substr(2)) - 20.0;
        squares += off * off;
    }
    EXPECT_NEAR(std::sqrt(squares / kShots), 0.00306, 0.0007);  // 3 mm + 3 ppm; four sigma of the spread
}

TEST_F(StationDistanceTest, AbsorbingTargetNeverCompletes) {
    point(200.0, 100.0);
    EXPECT_EQ(ask("TG"), ">");
    EXPECT_EQ(untilDistance(2min), 2min);
    EXPECT_THAT(ask("RG"), Not(HasSubstr("9=")));
}

TEST_F(StationDistanceTest, MeasuringGoesOnAndEndsWhenTheTelescopeFindsAWall) {
    point(300.0, 100.0);
    ask("TG", 1min);
    point(0.0, 100.0);
    EXPECT_LE(untilDistance(2s), 500ms);
}

TEST_F(StationDistanceTest, PrismWorkMayGiveUpWithInfo166) {
    settings.no_signal_status = 166;
    point(300.0, 100.0);
    ask("TG", 5s);
    EXPECT_EQ(ask("RG"), "166\r\n>");
}

TEST_F(StationDistanceTest, BeyondTheRangeThereIsNoSignal) {
    settings.longest_range_m = 50.0;
    point(100.0, 100.0);
    EXPECT_EQ(ask("RGT"), "300\r\n>");
    ask("TG");
    EXPECT_EQ(untilDistance(1min), 1min);
}

TEST_F(StationDistanceTest, PointingMayMoveThirtyCentimetresAtTheTarget) {
    ask("TG", 5s);
    point(0.94, 100.0);  // 0.295 m at 20 m
    EXPECT_THAT(ask("RG"), HasSubstr("9=20.000"));
    ask("TG", 5s);
    point(0.94 + 0.97, 100.0);  // 0.305 m
    EXPECT_EQ(ask("RG"), "4\r\n>");
    EXPECT_EQ(ask("RG,9"), "4\r\n>");
}

TEST_F(StationDistanceTest, TargetTestMayBeSwitchedOff) {
    settings.target_test = false;
    ask("TG", 5s);
    point(50.0, 100.0);
    EXPECT_THAT(ask("RG"), HasSubstr("7=50.0000\r\n8=100.0000\r\n9=20.000"));
}

TEST_F(StationDistanceTest, PpmOfTheWrongAirStretchesTheDistance) {
    point(100.0, 100.0);
    EXPECT_EQ(ask("WG,30=100"), ">");  // true air: 20 degrees, 1013 mbar, -0.03 ppm
    ask("TG", 5s);
    EXPECT_EQ(ask("RG,9"), "9=100.010\r\n>");
}

TEST_F(StationDistanceTest, OffsetIsAddedToTheSlopeDistance) {
    EXPECT_EQ(ask("WG,20=-0.035"), ">");
    ask("TG", 5s);
    EXPECT_EQ(ask("RG,9"), "9=19.965\r\n>");
}

TEST_F(StationDistanceTest, BareStationAcceptsTheTriggerWithoutEffect) {
    settings.bare_station = true;
    EXPECT_EQ(ask("TG"), ">");
    EXPECT_EQ(untilDistance(1min), 1min);
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
    EXPECT_EQ(ask("WG,5=1"), "0.0\r\n>");
    EXPECT_EQ(ask("RR,56"), "22\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
