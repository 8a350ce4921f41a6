#include "station_fixture.hpp"

#include <random>

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;
using testing::HasSubstr;

class StationFaultsTest : public StationTest {
protected:
    void SetUp() override { ASSERT_EQ(ask("WG,5=7"), ">"); }
    const std::string kGood = "5=7\r\n>";
};

TEST_F(StationFaultsTest, SilentCommandIsCarriedOut) {
    inject("silent");
    EXPECT_EQ(ask("WG,5=8", 1min), "");
    EXPECT_EQ(ask("RG,5"), "5=8\r\n>");
}

TEST_F(StationFaultsTest, StrikesOnlyTheCommandItIsMeantFor) {
    inject("silent,on=TG,times=2");
    EXPECT_EQ(ask("RG,5"), kGood);
    EXPECT_EQ(ask("TG"), "");
    EXPECT_EQ(ask("TG"), "");
    EXPECT_EQ(ask("TG"), ">");
}

TEST_F(StationFaultsTest, LateAnswerComesWhole) {
    inject("late=4");
    EXPECT_EQ(ask("RG,5", 3999ms), "");
    clock.advance(1ms);
    EXPECT_EQ(heard(), kGood);
}

TEST_F(StationFaultsTest, TwoAnswersToOneCommand) {
    inject("twice");
    EXPECT_EQ(ask("RG,5"), kGood + kGood);
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, GarbledAnswerKeepsItsLength) {
    inject("garble,seed=3");
    const std::string answer = ask("RG,5");
    EXPECT_EQ(answer.size(), kGood.size());
    EXPECT_NE(answer, kGood);
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, HalfABlockHasNoEnd) {
    inject("half_block");
    EXPECT_EQ(ask("RG,5"), "5=7");
}

TEST_F(StationFaultsTest, EndMarkLostOrTooMany) {
    inject("missing_eot");
    EXPECT_EQ(ask("RG,5"), "5=7\r\n");
    inject("stray_end_marks");
    EXPECT_EQ(ask("RG,5"), ">>" + kGood);
}

TEST_F(StationFaultsTest, AnyInfoCodeOnDemand) {
    inject("info=197");
    EXPECT_EQ(ask("WG,5=9"), "197\r\n>");
    EXPECT_EQ(ask("RG,5"), kGood);  // it was not carried out
}

TEST_F(StationFaultsTest, Info156ComesAfterTheMotion) {
    inject("info=156,on=WS");
    ask("WG,27=10.0000");
    EXPECT_EQ(ask("WS=PH02V02", 10s), "156\r\n>");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(10), Angle::fromCc(2)));
}

TEST_F(StationFaultsTest, LineErrorCarriesItsBits) {
    inject("line_error=12");
    EXPECT_EQ(ask("RG,5"), "21.12\r\n>");
}

TEST_F(StationFaultsTest, LostBytesAreTheSameForTheSameSeed) {
    const auto stormy = [this] {
        inject("drop=0.2,seed=11");
        std::string said;
        for (int i = 0; i < 50; ++i) {
            said += ask("RG,5", 20s);
        }
        inject("drop=off");
        clock.advance(20s);
        heard();
        return said;
    };
    const std::string once = stormy();
    EXPECT_NE(once.size(), 50 * kGood.size());
    EXPECT_EQ(stormy(), once);
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, BadLineChangesBytesBothWays) {
    inject("garble=0.3,seed=2");
    int good = 0;
    for (int i = 0; i < 40; ++i) {
        good += ask("RG,5", 20s) == kGood ? 1 : 0;
    }
    EXPECT_LT(good, 20);
    inject("garble=off");
    clock.advance(20s);
    heard();
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, PulledCableLosesBytesButNotTheMotion) {
    ask("WG,27=100.0000");
    ask("WS=PH02", 1s);
    core::Duration told{0};
    station().on_unplug = [&](core::Duration span) { told = span; };
    inject("unplug=5");
    EXPECT_EQ(told, 5s);
    EXPECT_EQ(ask("RG,5", 5s), "");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(100), Angle::fromCc(2)));
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, BodyWithoutControlUnitIgnoresTheTrigger) {
    inject("no_cu");
    EXPECT_EQ(ask("TG", 1min), ">");
    EXPECT_EQ(ask("RG,9"), "7\r\n>");
    EXPECT_EQ(ask("WG,5=7"), "0.0\r\n>");
    inject("no_cu=off");
    inject("tg_ignored");
    EXPECT_EQ(ask("TG", 1min), ">");
    EXPECT_EQ(ask("RG,9"), "7\r\n>");
}

TEST_F(StationFaultsTest, DistanceLateLostOrFar) {
    inject("distance_late=20");
    ask("TG", 24s);
    EXPECT_EQ(ask("RG,9"), "7\r\n>");
    clock.advance(1s);
    EXPECT_EQ(ask("RG,9"), "9=20.000\r\n>");
    inject("target_lost");
    ask("TG", 5s);
    EXPECT_EQ(ask("RG"), "161\r\n>");
    inject("distance_jump");
    ask("TG", 5s);
    EXPECT_EQ(ask("RG"), "175\r\n>");
    ask("TG", 5s);
    EXPECT_THAT(ask("RG"), HasSubstr("9=20.000"));
}

TEST_F(StationFaultsTest, EveryTargetAbsorbs) {
    inject("no_signal");
    EXPECT_EQ(ask("RGT"), "300\r\n>");
    ask("TG", 1min);
    EXPECT_EQ(ask("RG,9"), "7\r\n>");
    inject("none");
    EXPECT_EQ(ask("RGT"), "301\r\n>");
}

TEST_F(StationFaultsTest, ResidualOfAnAxisIsReportedOutOfTolerance) {
    inject("residual_v=18");
    ask("WG,26=90.0000");
    EXPECT_EQ(ask("WS=PH05V05", 10s), "156\r\n>");
    EXPECT_THAT(truth().va, IsNearAngle(Angle::fromGon(90.0018), Angle::fromCc(0.1)));
    EXPECT_EQ(ask("WS=PH05V20", 10s), ">");
    inject("residual_h=18");
    EXPECT_EQ(ask("WS=PH05V20", 10s), "155\r\n>");
    EXPECT_EQ(ask("WS=PH05V05", 10s), "157\r\n>");
}

TEST_F(StationFaultsTest, MotorTroubleStopsHalfWay) {
    ask("WG,27=40.0000");
    inject("motor_overload_h");
    EXPECT_EQ(ask("WS=PH02", 10s), "151\r\n>");
    EXPECT_THAT(truth().ha, IsNearAngle(Angle::fromGon(20), Angle::fromCc(2)));
    inject("motor_overload_v");
    EXPECT_EQ(ask("WS=PH02", 10s), "152\r\n>");
    inject("end_switch");
    EXPECT_EQ(ask("WS=PH02", 10s), "153\r\n>");
    inject("target_not_found");
    EXPECT_EQ(ask("WS=PH02", 10s), "158\r\n>");
}

TEST_F(StationFaultsTest, LevelAndBatteryShowInTheReadings) {
    inject("battery_low");
    EXPECT_EQ(ask("RG"), "8\r\n7=0.0000\r\n8=100.0000\r\n>");
    inject("level_loss");
    EXPECT_EQ(ask("RG"), "1\r\n>");
    inject("level_loss=off");
    inject("battery_low=off");
    EXPECT_THAT(ask("RG"), testing::StartsWith("0\r\n"));
}

TEST_F(StationFaultsTest, InstrumentThatWasForgottenSwitchesOff) {
    inject("auto_power_off");
    clock.advance(60s);
    EXPECT_FALSE(station().isOn());
}

TEST_F(StationFaultsTest, BusyInstrumentHearsNothingOrSays197) {
    inject("initialising=10");
    EXPECT_EQ(ask("RG,5", 10s), "");
    inject("panel_task=10");
    EXPECT_EQ(ask("RG,5", 10s), "197\r\n>");
    EXPECT_EQ(ask("RG,5"), kGood);
}

TEST_F(StationFaultsTest, LostMemoryIsInfo51Once) {
    inject("memory_lost");
    EXPECT_EQ(ask("RG"), "51\r\n>");
    EXPECT_THAT(ask("RG"), testing::StartsWith("0\r\n"));
    EXPECT_EQ(ask("RG,5"), "5=\r\n>");
}

TEST_F(StationFaultsTest, WrongPinsMakeItSayInfo23AgainAndAgain) {
    inject("info_23_loop=1");
    clock.advance(3s);
    EXPECT_EQ(heard(), "23\r\n>23\r\n>23\r\n>");
    inject("info_23_loop=off");
    clock.advance(3s);
    EXPECT_EQ(heard(), "");
}

TEST_F(StationFaultsTest, RegKeyIsPressedInBetween) {
    inject("reg_key");
    EXPECT_EQ(heard(), "7=0.0000\r\n8=100.0000\r\n>");
}

TEST_F(StationFaultsTest, EveryNamedFaultCanBeOrderedAndLeavesItWorking) {
    for (const FaultKind& kind : Station::faultKinds()) {
        EXPECT_GT(kind.sentence.size(), 10) << kind.name.toStdString();
        ASSERT_TRUE(station().injectFault(kind.name).has_value()) << kind.name.toStdString();
        ask("RG,5", 1s);
        ask("WS=PH02", 1min);
        inject("none");
        station().receiveBreak();
        ask("Y", 1min);
        ask("WG,5=7", 1min);
        EXPECT_EQ(ask("RG,5", 1min), kGood) << "after " << kind.name.toStdString();
    }
    EXPECT_EQ(Station::faultNames().size(), static_cast<qsizetype>(Station::faultKinds().size()));
}

TEST_F(StationFaultsTest, AFaultCountsHowOftenItHadAnEffect) {
    const auto struck = [this](const char* fault) { return station().timesStruck(QLatin1String(fault)); };
    inject("silent,on=TG");
    ask("RG,5");
    EXPECT_EQ(struck("silent"), 0) << "it waits for its command";
    ask("TG");
    EXPECT_EQ(struck("silent"), 1);
    inject("drop=0.5,seed=3");
    ask("RG,5");
    EXPECT_GT(struck("drop"), 0);
    inject("none");
    EXPECT_EQ(struck("silent"), 1) << "what has happened stays counted";
    inject("auto_power_off=60");
    clock.advance(59s);
    EXPECT_EQ(struck("auto_power_off"), 0);
    clock.advance(2s);
    EXPECT_EQ(struck("auto_power_off"), 1);
}

TEST_F(StationFaultsTest, UnknownFaultsAreRefusedByName) {
    const auto refused = station().injectFault(QStringLiteral("earthquake"));
    ASSERT_THAT(refused, FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(refused.error().sentence().toStdString(), HasSubstr("earthquake"));
    for (const char* text : {"late=soon", "silent=3", "drop=-1", "late=1,colour=red", "late,times=x", ""}) {
        EXPECT_THAT(station().injectFault(QString::fromLatin1(text)), FailedWith(ErrorKind::kBadInput))
            << text;
    }
}

TEST_F(StationFaultsTest, RandomWorkWithRandomFaultsLeavesItAnswering) {
    settings.baud = 9600.0;
    const std::vector<std::string> work{
        "RG",       "RGN",        "RG,9",       "RGT",    "TG",    "PG,3=0",  "PG,3=1",
        "PG,3=2",   "WS=PH02V02", "WG,27=123",  "OMC",    "LM=A",  "2=1",     "KM=A",
        "WG,26=80", "WS=PH50",    "WG,21=10.5", "RR,56",  "M",     "PV,20",   "WG,50=B",
        "rg",       "WG,30=5",    "WR,74=1000", "RG,110", "PV,21", "OM=NONE", "Y"};
    std::mt19937 random(17);
    const auto one_of = [&](const auto& things) -> decltype(auto) {
        return things[std::uniform_int_distribution<std::size_t>(0, std::size(things) - 1)(random)];
    };
    for (int i = 0; i < 3000; ++i) {
        ask(one_of(work), std::chrono::milliseconds(std::uniform_int_distribution(0, 3000)(random)));
        if (i % 10 == 0) {
            inject(one_of(Station::faultKinds()).name.toLatin1().constData());
        }
        if (i % 40 == 0) {
            station().receiveBreak();
        }
    }
    inject("none");
    station().receive(">\r");  // whatever was being loaded ends here
    clock.advance(1min);
    station().receiveBreak();
    ask("Y", 1min);
    ask("PG,3=0", 1min);
    EXPECT_THAT(ask("RG,5", 1s), HasSubstr("5="));
}

TEST_F(StationFaultsTest, AnHourOfLostBytesNeverLeavesItStuck) {
    settings.baud = 9600.0;
    inject("drop=0.05,seed=9");
    for (int i = 0; i < 360; ++i) {
        ask(i % 5 == 0 ? "TG" : i % 3 == 0 ? "WS=PH02V02" : "RG", 10s);
    }
    inject("none");
    clock.advance(30s);
    heard();
    EXPECT_THAT(ask("RG,5", 1s), HasSubstr("5="));
}

}  // namespace
}  // namespace pmts::simulator
