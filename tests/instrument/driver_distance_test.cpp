#include "distance.hpp"
#include "distance_limit.hpp"
#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

TEST_F(DriverTest, MeasuresByTriggerAndPollsAndReadsTheDistanceTwice) {
    connect();
    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
    EXPECT_THAT(shot->pointing.ha, test::IsNearAngle(Angle::fromGon(10.0), Angle::fromCc(0.1)));
    EXPECT_EQ(shot->mode, EdmMode::kStd);
    EXPECT_EQ(link.written.back(), "RG,9\r");
    EXPECT_GE(shot->time_taken, 5s);
    EXPECT_LT(shot->time_taken, 5100ms);
}

TEST_F(DriverTest, ATriggerWhoseBlockEndComesWithTheDistanceIsUnderstood) {
    connect();
    station.link.respond = [this](const std::string& command) -> std::optional<std::string> {
        auto reply = station.answer(command);
        if (command == "TG\r") {
            station.link.say(">", 5s);
            return std::nullopt;
        }
        return reply;
    };
    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_LT(shot->time_taken, 5100ms);
}

TEST_F(DriverTest, AnAbsorbingSurfaceEndsTheWaitInTheInstrumentAndIsAbsurd) {
    connect();
    station.echo = false;
    const auto began_at = clock.now();

    const auto shot = run(driver.measureDistance({}));

    EXPECT_THAT(shot, test::FailedWith(ErrorKind::kAbsurdPoint));
    EXPECT_EQ(link.written.back(), "PG,3=0\r");
    EXPECT_NEAR(std::chrono::duration<double>(clock.now() - began_at).count(), 11.0, 0.5);  // L 9 s + ET 2 s
}

/// Two masters: the panel may ask for the distance first.
TEST_F(DriverTest, ADistanceThatThePanelReadAwayIsMeasuredOnceMore) {
    connect();
    station.link.respond = [this](const std::string& command) {
        auto reply = station.answer(command);
        const bool is_first_shot = sent("TG") == 1;
        if (command == "RG\r" && is_first_shot && reply->find("9=") != std::string::npos) {
            (void)driver.noteForeignCommand("RG\r");
            return std::optional<std::string>("3\r\n>");
        }
        return reply;
    };
    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value()) << shot.error().sentence().toStdString();
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
    EXPECT_EQ(sent("TG"), 2);
}

TEST_F(DriverTest, ADistanceThatThePanelAlwaysReadsAwayIsSaidToBeTaken) {
    connect();
    station.link.respond = [this](const std::string& command) {
        if (command == "RG\r" && sent("TG") > 0) {
            (void)driver.noteForeignCommand("RG\r");
            return std::optional<std::string>("3\r\n>");
        }
        return station.answer(command);
    };
    const auto shot = run(driver.measureDistance({}));

    ASSERT_FALSE(shot.has_value());
    EXPECT_THAT(shot.error().happened.toStdString(), testing::HasSubstr("The panel"));
}

TEST_F(DriverTest, TheWaitLimitIsLearnedFromGoodShots) {
    connect();
    EXPECT_EQ(driver.distanceLimit(), 9s);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    }
    EXPECT_LT(driver.distanceLimit(), 5200ms);
    EXPECT_EQ(driver.statistics().count(timingKey(EdmMode::kStd, 23.4)), 10U);
}

TEST_F(DriverTest, RangeClassesAreLearnedApart) {
    connect();
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    }
    driver.expectRange(300.0);
    EXPECT_EQ(driver.distanceLimit(), 9s);
    driver.expectRange(20.0);
    EXPECT_LT(driver.distanceLimit(), 5200ms);
}

TEST_F(DriverTest, ADistanceThatLostADigitIsNotBelieved) {
    connect();
    station.next["RG,9"] = {"9=2.418\r\n>"};

    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
}

TEST_F(DriverTest, ADistanceWithFewerDecimalsThanUsualIsNotBelieved) {
    connect();
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    station.next["RG,9"] = {"9=23.41\r\n>", "9=23.41\r\n>"};

    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
}

TEST_F(DriverTest, AnOldDistanceThatWaitsInTheInstrumentIsNotTakenForTheNewOne) {
    connect();
    station.triggered_at = clock.now() - 60s;  // the operator measured 11.111 before
    station.labels[9] = "11.111";
    station.link.respond = [this](const std::string& command) {
        if (command == "TG\r") {
            station.labels[9] = "23.418";
        }
        return station.answer(command);
    };

    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
}

TEST_F(DriverTest, ADistanceThatIsThereTooSoonAfterTheTriggerIsAnOlderOne) {
    connect();
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    int polls = 0;
    station.link.respond = [&](const std::string& command) -> std::optional<std::string> {
        if (command == "RG\r" && polls++ == 0) {
            return "0\r\n7=10.0000\r\n8=100.0000\r\n9=11.111\r\n>";
        }
        return station.answer(command);
    };

    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
}

TEST_F(DriverTest, AnInstrumentThatMovedWhileMeasuringGivesNoPoint) {
    connect();
    const auto timer = clock.callAfter(2s, [this] { station.ha += 0.06; });  // 60 mgon

    const auto shot = run(driver.measureDistance({}));

    EXPECT_THAT(shot, test::FailedWith(ErrorKind::kAbsurdPoint));
}

TEST_F(DriverTest, StatusFourAndSevenWhileMeasuringMeanNotYet) {
    connect();
    for (const char* not_yet : {"4\r\n>", "7\r\n>"}) {
        station.next["RG\r"] = {};
        station.link.respond = [this, not_yet](const std::string& command) -> std::optional<std::string> {
            auto reply = station.answer(command);
            const bool measuring =
                station.triggered_at && clock.now() < *station.triggered_at + station.measuring_time;
            return command == "RG\r" && measuring ? not_yet : reply;
        };
        const auto shot = run(driver.measureDistance({}));
        ASSERT_TRUE(shot.has_value()) << not_yet;
    }
}

TEST_F(DriverTest, RemeasureStatusesTriggerOnceMore) {
    for (const char* status : {"171", "172", "173", "174", "175"}) {
        connect();
        station.next["RG"] = {};
        int left = 1;
        station.link.respond = [&](const std::string& command) -> std::optional<std::string> {
            const bool ready = station.triggered_at && clock.now() > *station.triggered_at + 1s;
            if (command == "RG\r" && ready && left-- > 0) {
                return station.block(status);
            }
            return station.answer(command);
        };
        const auto shot = run(driver.measureDistance({}));
        EXPECT_TRUE(shot.has_value()) << status;
        EXPECT_EQ(sent("TG"), 2) << status;
    }
}

TEST_F(DriverTest, ALostTargetGoesUpUnchanged) {
    connect();
    station.link.respond = [this](const std::string& command) -> std::optional<std::string> {
        const bool ready = station.triggered_at && clock.now() > *station.triggered_at + 1s;
        return command == "RG\r" && ready ? station.block("166.7") : station.answer(command);
    };
    const auto shot = run(driver.measureDistance({}));

    ASSERT_THAT(shot, test::FailedWith(ErrorKind::kDevice));
    EXPECT_EQ(shot.error().info_code, 166);
    EXPECT_EQ(sent("TG"), 1);
}

TEST_F(DriverTest, StopWhileMeasuringCancelsTheShot) {
    connect();
    const auto timer = clock.callAfter(2s, [this] { driver.stop(); });

    const auto shot = run(driver.measureDistance({}), 3s);

    EXPECT_THAT(shot, test::FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(link.written.back(), "PG,3=0\r");
}

TEST_F(DriverTest, AnAnswerThatWasLostWithTheDistanceIsMadeUpByTheLabel) {
    connect();
    bool lost = false;
    station.link.respond = [&](const std::string& command) -> std::optional<std::string> {
        auto reply = station.answer(command);
        if (!lost && reply && command == "RG\r" && reply->find("9=") != std::string::npos) {
            lost = true;
            return "0\r\n7=10.0000\r\n8=100.0000\r\n=23.418\r\n>";
        }
        return reply;
    };
    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
    EXPECT_EQ(sent("TG"), 1);
}

TEST_F(DriverTest, EveryModeIsSelectedByItsNumber) {
    connect();
    const std::pair<EdmMode, const char*> modes[] = {{EdmMode::kTrk, "1"},
                                                     {EdmMode::kDBar, "2"},
                                                     {EdmMode::kFstd, "3"},
                                                     {EdmMode::kDBarHighResolution, "4"},
                                                     {EdmMode::kStd, "0"}};
    for (const auto& [mode, number] : modes) {
        ASSERT_TRUE(run(driver.setMode(mode)).has_value());
        EXPECT_EQ(station.mode, number);
        EXPECT_EQ(driver.mode(), mode);
    }
}

TEST_F(DriverTest, TrackingIsEndedAfterItsDistance) {
    connect();
    station.measuring_time = 400ms;
    ASSERT_TRUE(run(driver.setMode(EdmMode::kTrk)).has_value());
    const auto shot = run(driver.measureDistance({}));

    ASSERT_TRUE(shot.has_value());
    EXPECT_EQ(shot->mode, EdmMode::kTrk);
    EXPECT_EQ(link.written.back(), "PG,3=1\r");
}

TEST(TimingKey, NamesModeAndRangeClass) {
    EXPECT_EQ(timingKey(EdmMode::kStd, 23.4), "STD 0-50 m");
    EXPECT_EQ(timingKey(EdmMode::kTrk, 50.0), "TRK 50-200 m");
    EXPECT_EQ(timingKey(EdmMode::kDBar, 5000.0), "D-bar beyond 1000 m");
}

TEST_F(DriverTest, TheTargetTestRefusesADistanceOfAnotherPointUnlessItIsSwitchedOff) {
    connect();
    const auto measureWhileMoving = [this] {
        const auto nudge = clock.callAfter(3s, [this] { station.ha += 0.1; });  // 100 mgon
        return run(driver.measureDistance({}));
    };
    const auto refused = measureWhileMoving();
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().happened.toStdString(), testing::HasSubstr("another point"));
    driver.setTargetTest({.on = true, .angle = Angle::fromMgon(200), .offset_m = 1.0});
    EXPECT_TRUE(measureWhileMoving().has_value());
    driver.setTargetTest({.on = false});
    EXPECT_TRUE(measureWhileMoving().has_value());
}

TEST(OldDistanceGuard, AllowsFiftyMilligonAndThirtyCentimetres) {
    const GeodimeterSettings settings;
    const geometry::Pointing before{.ha = Angle::fromGon(10), .va = Angle::fromGon(100)};
    const auto moved = [&](double mgon, double distance_m) {
        return isOtherPoint(settings, before, {.ha = before.ha + Angle::fromMgon(mgon), .va = before.va},
                            distance_m);
    };
    EXPECT_FALSE(moved(49, 20));
    EXPECT_TRUE(moved(51, 20));
    EXPECT_TRUE(moved(49, 399));    // 30.7 cm
    EXPECT_FALSE(moved(45, 399));   // 28 cm
    EXPECT_FALSE(moved(45, 1000));  // 71 cm of 75 allowed
}

/// Every block of measured data comes with this status instead of 0.
void warnWith(ScriptedInstrument& station, const std::string& code) {
    station.link.respond = [&station, code](const std::string& command) -> std::optional<std::string> {
        auto reply = station.answer(command);
        if (command == "RG\r" && reply && reply->starts_with("0\r\n")) {
            reply->replace(0, 1, code);
        }
        return reply;
    };
}

class WarningTest : public DriverTest {
protected:
    void SetUp() override {
        driver.on_warnings = [this](const std::vector<core::Error>& now) {
            ++told;
            standing = now;
        };
        connect();
    }
    std::vector<core::Error> standing;
    int told = 0;
};

TEST_F(WarningTest, BatteryLowIsToldOnceAndTheGoodDistanceIsKept) {
    warnWith(station, "8");
    for (int i = 0; i < 2; ++i) {
        const auto shot = run(driver.measureDistance({}));
        ASSERT_TRUE(shot.has_value()) << shot.error().happened.toStdString();
        EXPECT_NEAR(shot->slope_distance_m, 23.418, 1e-9);
    }
    EXPECT_EQ(told, 1);
    ASSERT_EQ(standing.size(), 1U);
    EXPECT_EQ(standing[0].info_code, 8);
}

TEST_F(WarningTest, WarningIsOverAfterAMeasurementWithoutIt) {
    warnWith(station, "8");
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    warnWith(station, "0");
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    EXPECT_TRUE(standing.empty());
    EXPECT_EQ(told, 2);
}

TEST_F(WarningTest, OldBackupBatteryAndDisturbedClockLeaveTheDistanceGood) {
    for (const char* code : {"9", "25", "26"}) {
        warnWith(station, code);
        EXPECT_TRUE(run(driver.measureDistance({})).has_value()) << code;
    }
    EXPECT_EQ(standing.size(), 3U);
}

TEST_F(WarningTest, LostMemoryGoesOnBeingToldAfterAGoodMeasurement) {
    station.next["RG,7"] = {"51\r\n>"};
    (void)run(driver.readPointing({}));
    ASSERT_EQ(standing.size(), 1U);
    EXPECT_EQ(standing[0].info_code, 51);
    EXPECT_EQ(run(driver.pollPointing({})).error().info_code, 51) << "the poller is told once more, and connects anew";
    const auto refused = run(driver.measureDistance({}));
    ASSERT_FALSE(refused.has_value()) << "its units may be others now";
    ASSERT_TRUE(run(driver.connectTo({})).has_value());
    EXPECT_EQ(standing.size(), 1U) << "asking for what was lost does not make it good";
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    EXPECT_EQ(standing.size(), 1U);
    ASSERT_TRUE(run(driver.connectTo({})).has_value());
    EXPECT_TRUE(standing.empty()) << "a new connection begins";
}

TEST_F(WarningTest, Info23IsToldWhenItComesAgainAndAgain) {
    const auto complain = [this](int times) {
        for (int i = 0; i < times; ++i) {
            link.say("23\r\n>");
            clock.advance(1ms);
        }
    };
    complain(2);
    EXPECT_TRUE(standing.empty()) << "once or twice is healed by asking again";
    complain(1);
    ASSERT_EQ(standing.size(), 1U);
    EXPECT_EQ(standing[0].info_code, 23);
    EXPECT_TRUE(standing[0].remedy.contains(QStringLiteral("three bus pins")));
    ASSERT_TRUE(run(driver.measureDistance({})).has_value());
    EXPECT_TRUE(standing.empty());
}

TEST_F(WarningTest, TiltedInstrumentStillRefusesTheDistance) {
    warnWith(station, "1");
    const auto shot = run(driver.measureDistance({}));
    ASSERT_FALSE(shot.has_value());
    EXPECT_EQ(shot.error().info_code, 1);
    EXPECT_TRUE(standing.empty());
}

TEST_F(WarningTest, TriggerAndMotionAnsweredWithAWarningGoOn) {
    station.link.respond = [this](const std::string& command) -> std::optional<std::string> {
        auto reply = station.answer(command);
        return reply == ">" ? "8\r\n>" : reply;
    };
    const auto arrived = run(driver.turnTo(pointing(12, 100), Angle::fromCc(10), {}));
    EXPECT_TRUE(arrived.has_value());
    EXPECT_TRUE(run(driver.measureDistance({})).has_value());
    EXPECT_EQ(standing.size(), 1U);
}

}  // namespace
}  // namespace pmts::instrument
