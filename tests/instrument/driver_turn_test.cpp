#include "motion.hpp"
#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

const Angle kTolerance = Angle::fromCc(5);

TEST_F(DriverTest, TurnsBothAxesByTheManualsBytesAndVerifies) {
    connect();
    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), Angle::fromCc(2), {}));

    ASSERT_TRUE(arrived.has_value());
    EXPECT_THAT(link.written, ElementsAre("WG,26=96.1684\r", "RG,26\r", "WG,27=177.5612\r", "RG,27\r",
                                          "WS=PH02V02\r", "RG,7\r", "RG,8\r"));
    EXPECT_THAT(arrived->ha, test::IsNearAngle(Angle::fromGon(177.5612), Angle::fromCc(0.1)));
    EXPECT_THAT(arrived->va, test::IsNearAngle(Angle::fromGon(96.1684), Angle::fromCc(0.1)));
}

TEST_F(DriverTest, TurnsOneAxisOnly) {
    connect();
    ASSERT_TRUE(run(driver.turnHorizontal(Angle::fromGon(50.0), kTolerance, {})).has_value());
    EXPECT_EQ(sent("WS=PH05"), 1);
    ASSERT_TRUE(run(driver.turnVertical(Angle::fromGon(90.0), kTolerance, {})).has_value());
    EXPECT_EQ(sent("WS=PV05"), 1);

    EXPECT_EQ(station.ha, 50.0);
    EXPECT_EQ(station.va, 90.0);
}

TEST_F(DriverTest, WritesTargetsInTheInstrumentsUnit) {
    station.labels[23] = "1112";
    connect();
    const auto arrived = run(driver.turnHorizontal(Angle::fromGon(177.56115), kTolerance, {}));

    ASSERT_TRUE(arrived.has_value());
    EXPECT_EQ(sent("WG,27=159.4818"), 1);  // protocol page 4.2
}

TEST_F(DriverTest, ATargetThatLostADigitOnTheWayIsWrittenAgainBeforeTheMotorsStart) {
    connect();
    station.next["RG,27"] = {"27=17.5612\r\n>", "27=17.5612\r\n>"};

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    ASSERT_TRUE(arrived.has_value());
    EXPECT_EQ(sent("WG,27=177.5612"), 2);
    EXPECT_EQ(sent("WS=PH05V05"), 1);
}

TEST_F(DriverTest, ATargetThatIsNeverKeptDoesNotMoveTheInstrument) {
    connect();
    station.next["RG,27"] = std::deque<std::optional<std::string>>(500, "27=17.5612\r\n>");

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    EXPECT_FALSE(arrived.has_value());
    EXPECT_EQ(sent("WS=PH05V05"), 0);
}

TEST_F(DriverTest, AnInstrumentThatDoesNotShowItsTargetsIsTurnedAllTheSame) {
    connect();
    station.next["RG,26"] = {"20\r\n>", "20\r\n>"};

    EXPECT_TRUE(run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {})).has_value());
}

TEST_F(DriverTest, ArrivalIsReadFromTheCirclesNotBelieved) {
    connect();
    station.va_residual_cc = 60.0;

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    ASSERT_THAT(arrived, test::FailedWith(ErrorKind::kNotReached));
    EXPECT_THAT(arrived.error().happened.toStdString(), testing::HasSubstr("VA is off by 60 cc"));
}

TEST_F(DriverTest, ReportsInfo156WhenTheVerticalServoStopsShort) {
    connect();
    station.va_residual_cc = 18.0;
    station.link.respond = [this](const std::string& command) -> std::optional<std::string> {
        auto reply = station.answer(command);
        if (command.starts_with("WS=")) {
            station.link.say("156\r\n>", 1900ms);
        }
        return reply;
    };

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    ASSERT_FALSE(arrived.has_value());
    EXPECT_EQ(arrived.error().info_code, 156);
    EXPECT_EQ(arrived.error().kind, ErrorKind::kNotReached);
}

TEST_F(DriverTest, MotionSoftIsRepeatedOnceWithTwiceTheTolerance) {
    connect();
    station.next["WS"] = {"155\r\n>"};  // the motors were not run: still at 10 gon

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    ASSERT_TRUE(arrived.has_value());
    EXPECT_EQ(sent("WS=PH05V05"), 1);
    EXPECT_EQ(sent("WS=PH10V10"), 1);
}

TEST_F(DriverTest, AnEndSwitchGoesUpUnchanged) {
    connect();
    station.next["WS"] = {"153.12\r\n>"};

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    ASSERT_THAT(arrived, test::FailedWith(ErrorKind::kDevice));
    EXPECT_EQ(arrived.error().info_code, 153);
    EXPECT_EQ(sent("WS=PH05V05"), 1);
}

TEST_F(DriverTest, OutsideTheMotionLimitsNothingIsSent) {
    connect();
    const auto arrived = run(driver.turnTo(pointing(177.5612, 1.0), kTolerance, {}));

    EXPECT_THAT(arrived, test::FailedWith(ErrorKind::kLimit));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(DriverTest, AnHaSectorMayHoldTheZero) {
    GeodimeterSettings sector;
    sector.ha_min = Angle::fromGon(350);
    sector.ha_max = Angle::fromGon(50);

    EXPECT_FALSE(outsideLimits(sector, {.ha = Angle::fromGon(10), .va = std::nullopt, .tolerance = {}}));
    EXPECT_TRUE(outsideLimits(sector, {.ha = Angle::fromGon(200), .va = std::nullopt, .tolerance = {}}));
}

TEST_F(DriverTest, ALostBlockEndOfAMotionIsNoFailure) {
    connect();
    station.link.respond = [this](const std::string& command) -> std::optional<std::string> {
        if (command.starts_with("WS=")) {
            (void)station.turn(command);
            return std::nullopt;
        }
        return station.answer(command);
    };

    const auto arrived = run(driver.turnTo(pointing(177.5612, 96.1684), kTolerance, {}));

    EXPECT_TRUE(arrived.has_value());
}

TEST_F(DriverTest, StopIsOnTheWireAtOnceAndTheMotionIsCancelled) {
    connect();
    auto outcome = std::make_shared<std::optional<core::Result<geometry::Pointing>>>();
    auto turning = test::detail::keepOutcome(driver.turnTo(pointing(300.0, 96.0), kTolerance, {}), outcome);
    clock.advance(500ms);
    driver.stop();
    EXPECT_EQ(link.written.back(), "PG,3=0\r");  // before the event loop turns
    clock.advance(10ms);

    ASSERT_TRUE(outcome->has_value());
    EXPECT_THAT(outcome->value(), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(sent("PG,3=0"), 1);
}

TEST_F(DriverTest, AfterAStopTheNextMotionIsItsOwn) {
    connect();
    auto outcome = std::make_shared<std::optional<core::Result<geometry::Pointing>>>();
    auto turning = test::detail::keepOutcome(driver.turnTo(pointing(300.0, 96.0), kTolerance, {}), outcome);
    clock.advance(500ms);
    driver.stop();
    const auto arrived = run(driver.turnTo(pointing(20.0, 95.0), kTolerance, {}));

    EXPECT_THAT(arrived, test::FailedWith(ErrorKind::kRefused));  // the first has not ended yet
    const auto again = run(driver.turnTo(pointing(20.0, 95.0), kTolerance, {}));
    EXPECT_TRUE(again.has_value());
}

TEST_F(DriverTest, CancellingATurnStopsTheMotors) {
    connect();
    std::stop_source cancel;
    const auto timer = clock.callAfter(500ms, [&] { cancel.request_stop(); });

    const auto arrived = run(driver.turnTo(pointing(300.0, 96.0), kTolerance, cancel.get_token()));

    EXPECT_THAT(arrived, test::FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(sent("PG,3=0"), 1);
}

TEST_F(DriverTest, AStopTextOfTheProfileIsSentInstead) {
    auto settings = profile();
    settings.stop_text = "PV,9=0";
    GeodimeterDriver other(line, clock, settings);
    ASSERT_TRUE(run(other.connectTo({})).has_value());
    other.stop();

    EXPECT_EQ(link.written.back(), "PV,9=0\r");
}

TEST_F(DriverTest, AUserBreakOnTheInstrumentIsACancel) {
    connect();
    station.next["WS"] = {"190\r\n>"};

    EXPECT_THAT(run(driver.turnTo(pointing(300.0, 96.0), kTolerance, {})),
                test::FailedWith(ErrorKind::kCancelled));
}

TEST_F(DriverTest, ASecondRoutineIsRefusedWhileOneRuns) {
    connect();
    auto outcome = std::make_shared<std::optional<core::Result<geometry::Pointing>>>();
    auto turning = test::detail::keepOutcome(driver.turnTo(pointing(300.0, 96.0), kTolerance, {}), outcome);
    clock.advance(100ms);

    EXPECT_TRUE(driver.isBusy());
    EXPECT_THAT(run(driver.measureDistance({})), test::FailedWith(ErrorKind::kRefused));
}

TEST_F(DriverTest, ProgressRunsFromTheStartToTheArrival) {
    connect();
    std::vector<Progress> reports;
    driver.on_progress = [&](const Progress& progress) { reports.push_back(progress); };
    ASSERT_TRUE(run(driver.turnTo(pointing(110.0, 100.0), kTolerance, {})).has_value());

    ASSERT_GT(reports.size(), 10U);
    EXPECT_EQ(reports.front().activity, Activity::kTurning);
    EXPECT_GT(reports[reports.size() - 2].fraction, 0.5);
    EXPECT_EQ(reports.back().activity, Activity::kIdle);
}

TEST_F(DriverTest, UnpluggingWhileMovingEndsTheRoutine) {
    connect();
    int lost = 0;
    driver.on_lost = [&](const core::Error&) { ++lost; };
    const auto timer = clock.callAfter(500ms, [&] { link.unplug(); });

    const auto arrived = run(driver.turnTo(pointing(300.0, 96.0), kTolerance, {}));

    EXPECT_THAT(arrived, test::FailedWith(ErrorKind::kLinkLost));
    EXPECT_EQ(lost, 1);
    EXPECT_FALSE(driver.isBusy());
}

TEST_F(DriverTest, DestroyingTheDriverInMidMotionCompletesTheRoutine) {
    auto short_lived = std::make_unique<GeodimeterDriver>(line, clock, profile());
    ASSERT_TRUE(run(short_lived->connectTo({})).has_value());
    auto outcome = std::make_shared<std::optional<core::Result<geometry::Pointing>>>();
    auto turning =
        test::detail::keepOutcome(short_lived->turnTo(pointing(300.0, 96.0), kTolerance, {}), outcome);
    clock.advance(500ms);
    short_lived.reset();
    clock.advance(1s);

    ASSERT_TRUE(outcome->has_value());
    EXPECT_THAT(outcome->value(), test::FailedWith(ErrorKind::kCancelled));
}

TEST(MotionTime, IsThatOfATrapezoid) {
    const GeodimeterSettings settings;  // 50 gon/s, 100 gon/s2, 1 s to settle
    const auto seconds = [&](double gon) {
        return std::chrono::duration<double>(motionTime(settings, Angle::fromGon(gon))).count();
    };
    EXPECT_NEAR(seconds(100.0), 3.5, 1e-6);  // 0.5 s up, 75 gon at full speed, 0.5 s down
    EXPECT_NEAR(seconds(25.0), 2.0, 1e-6);   // just reaches full speed
    EXPECT_NEAR(seconds(1.0), 1.2, 1e-6);    // 2 sqrt(1/100)
}

}  // namespace
}  // namespace pmts::instrument
