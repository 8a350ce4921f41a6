#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;

class StationPowerTest : public StationTest {};

TEST_F(StationPowerTest, SwitchedOffItHearsNothing) {
    EXPECT_EQ(ask("PV,21"), "");
    EXPECT_FALSE(station().isOn());
    EXPECT_EQ(ask("RG,7", 1min), "");
}

TEST_F(StationPowerTest, BreakSwitchesOnAndAsksWhetherToContinue) {
    ask("WG,21=50.0000");
    ask("WG,37=1000.000");
    ask("PV,21", 1h);
    station().receiveBreak();
    EXPECT_EQ(heard(), "!");
    EXPECT_EQ(ask("RG,7"), "30\r\n>");
    EXPECT_EQ(ask("Y"), ">");
    EXPECT_EQ(ask("RG,7"), "7=50.0000\r\n>");
    EXPECT_EQ(ask("RG,37"), "37=0.000\r\n>");  // cleared at power-off
}

TEST_F(StationPowerTest, AnswerNoForgetsTheValues) {
    ask("WG,21=50.0000");
    ask("PV,21", 1h);
    station().receiveBreak();
    heard();
    EXPECT_EQ(ask("N"), ">");
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
}

TEST_F(StationPowerTest, AfterTwoHoursNothingIsKeptAndNothingAsked) {
    ask("WG,5=9");
    ask("PV,21", 2h);
    station().receiveBreak();
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(ask("RG,5"), "5=\r\n>");
}

TEST_F(StationPowerTest, CalibrationTurnsOverAndComesBack) {
    EXPECT_EQ(ask("PV,20"), "@");
    clock.advance(7s + 4501ms);  // half a turn: 4.5 s
    EXPECT_NEAR(truth().va.gon(), 300.0, 1.0);
    EXPECT_EQ(ask("RG,7"), "");  // waits
    clock.advance(1min);
    EXPECT_EQ(heard(), ">7=0.0000\r\n>");
    EXPECT_NEAR(truth().va.gon(), 100.0, 1e-9);
}

TEST_F(StationPowerTest, ItMayAskBeforeItCalibratesAndTurnsOnlyWithYes) {
    settings.calibration_asks = true;
    EXPECT_EQ(ask("PV,20"), "!");
    EXPECT_EQ(ask("RG,7"), "30\r\n>") << "no answer to the question";
    EXPECT_EQ(ask("N"), ">");
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
    EXPECT_EQ(ask("PV,20"), "!");
    EXPECT_EQ(ask("Y"), "@");
    clock.advance(1min);
    EXPECT_EQ(heard(), ">");
}

TEST_F(StationPowerTest, LeftAloneItMaySwitchItselfOff) {
    settings.switch_off_when_idle = 60s;
    ask("RG,7", 59s);
    EXPECT_TRUE(station().isOn());
    ask("RG,7", 59s);
    EXPECT_TRUE(station().isOn());
    clock.advance(1s);
    EXPECT_FALSE(station().isOn());
}

TEST_F(StationPowerTest, SwitchedOffWhileTurningItBrakesAndForgetsTheCommand) {
    ask("WG,27=100.0000");
    ask("WS=PH02", 1s);
    inject("power_off=5");
    clock.advance(10s);
    EXPECT_EQ(heard(), "");
    EXPECT_NEAR(truth().ha.gon(), 50.0, 1e-3);
    EXPECT_EQ(ask("RG,5"), "5=\r\n>");
}

TEST_F(StationPowerTest, UnknownProcessesAreNamed) {
    EXPECT_EQ(ask("PV,99"), "242\r\n>");
    EXPECT_EQ(ask("PG,20"), "242\r\n>");
    EXPECT_EQ(ask("PG"), "30\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
