#include "app/field_fixture.hpp"

#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using testing::IsEmpty;

/// The desks over a computer whose calendar somebody sets, the network sets, or a dead battery loses. The parameter is by
/// how much it jumps.
class ClockJumpTest : public FieldTest, public testing::WithParamInterface<std::chrono::seconds> {
protected:
    void SetUp() override {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        desk.connectSerial(choice);
        ASSERT_TRUE(until([this] { return desk.track().newest().has_value() && !desk.isBusy(); }));
        openJob();
        ASSERT_TRUE(turned(5, 98));
        QObject::connect(&messages, &MessageCentre::barKept, &shots, [this](const Message& bar) {
            bars.push_back(QString(bar.happened + u' ' + bar.remedy).toStdString());
        });
    }
    void TearDown() override {
        desk.disconnectInstrument();
        FieldTest::TearDown();
    }
    void jump() { clock.setTimeOfDayBy(GetParam()); }
    void startMove(double ha_gon, double va_gon) {
        aim.aimAtText(QStringLiteral("%1 gon").arg(ha_gon), QStringLiteral("%1 gon").arg(va_gon));
        aim.move();
    }
    bool turned(double ha_gon, double va_gon) {
        startMove(ha_gon, va_gon);
        return until([this] { return !aim.isMoving(); }) && aim.target()->state == MoveState::kArrived;
    }
    bool recorded() {
        const std::size_t before = points.points().size();
        shots.all();
        return until([this] { return !shots.isBusy(); }) && points.points().size() == before + 1;
    }
    /// How long a shot takes that gets no echo.
    core::Duration timeToGiveUp(bool with_jump) {
        const core::Duration began_at = clock.now();
        shots.measure();
        pass(1s);
        if (with_jump) {
            jump();
        }
        EXPECT_TRUE(until([this] { return !shots.isBusy(); }, 120s));
        return clock.now() - began_at;
    }
    void expectRightAndDatedNow(const survey::Point& point) const {
        const auto echo = scene->echo(true_pointing->at(clock.now()));
        ASSERT_TRUE(echo && point.observation.slope_distance_m);
        EXPECT_NEAR(*point.observation.slope_distance_m, echo->distance_m, 0.016);
        EXPECT_LE(std::abs(point.observation.utc.secsTo(clock.utcNow())), 10) << "the record follows the calendar";
        EXPECT_LT(point.observation.time_taken_s, 15.0) << "and its duration does not";
        EXPECT_GT(point.observation.time_taken_s, 0.0);
    }

    InstrumentDesk desk{gate, wiring()};
    TargetingPresenter aim{desk, live, points, station_page, range, preferences, messages};
    RecordingPresenter shots{desk, job_desk, points, station_page, range, preferences, messages, clock};
    std::vector<std::string> bars;
};

TEST_P(ClockJumpTest, ADistanceThatIsPendingComesAndIsDatedByTheNewCalendar) {
    shots.all();
    pass(2s);
    ASSERT_EQ(shots.readings().shot, ShotState::kMeasuring);
    jump();
    ASSERT_TRUE(until([this] { return !shots.isBusy(); }, 30s));

    ASSERT_EQ(points.points().size(), 1U);
    expectRightAndDatedNow(points.points().back());
    EXPECT_THAT(bars, IsEmpty()) << "nothing has happened to the work";
}

TEST_P(ClockJumpTest, ADistanceThatNeverComesIsGivenUpAfterTheSameTime) {
    ASSERT_TRUE(station.injectFault(QStringLiteral("no_signal")).has_value());
    const auto without = timeToGiveUp(false);
    const auto with = timeToGiveUp(true);

    EXPECT_NEAR(std::chrono::duration<double>(with).count(), std::chrono::duration<double>(without).count(), 1.0);
    EXPECT_EQ(shots.readings().shot, ShotState::kAbsurd);
    EXPECT_TRUE(shots.readings().sentence.startsWith(QStringLiteral("No distance came back within")))
        << shots.readings().sentence.toStdString();
}

TEST_P(ClockJumpTest, AMoveThatRunsArrivesAndIsNotMissed) {
    startMove(120, 95);
    pass(1s);
    ASSERT_TRUE(aim.isMoving());
    jump();
    ASSERT_TRUE(until([this] { return !aim.isMoving(); }, 20s));

    EXPECT_EQ(aim.target()->state, MoveState::kArrived) << aim.target()->sentence.toStdString();
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 120.0, 20e-4);
    EXPECT_THAT(bars, IsEmpty());
    ASSERT_TRUE(turned(5, 98));
    ASSERT_TRUE(recorded());
    expectRightAndDatedNow(points.points().back());
}

TEST_P(ClockJumpTest, AMoveThatNeverEndsIsNotForgottenForAYear) {
    startMove(120, 95);
    pass(500ms);
    answers = false;  // the instrument hears nothing any more, its block end is all that may still come
    instrument_end->on_received = nullptr;
    station.send = [](std::string_view) {};
    jump();

    ASSERT_TRUE(until([this] { return !aim.isMoving(); }, 120s)) << "the limit of the motion is a span, not a date";
    EXPECT_NE(aim.target()->state, MoveState::kArrived);
    EXPECT_FALSE(aim.target()->sentence.isEmpty());
}

TEST_P(ClockJumpTest, PollingGoesOnAtItsPaceAndNothingIsCalledSilent) {
    pass(5s);
    sent.clear();
    pass(10s);
    const auto asked_before = std::count(sent.begin(), sent.end(), '\r');
    sent.clear();
    jump();
    pass(10s);
    const auto asked_after = std::count(sent.begin(), sent.end(), '\r');

    EXPECT_GT(asked_before, 5);
    EXPECT_NEAR(static_cast<double>(asked_after), static_cast<double>(asked_before), 3.0);
    EXPECT_EQ(desk.connectionState(), ConnectionState::kConnected);
    ASSERT_TRUE(desk.track().newest().has_value());
    EXPECT_LT(clock.now() - desk.track().newest()->at, 2s) << "the newest reading is new";
    EXPECT_THAT(bars, IsEmpty());
}

TEST_P(ClockJumpTest, APulledCableIsFoundAgainWhateverTheCalendarSays) {
    unplug();
    pass(2s);
    jump();
    plugIn();

    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected && !desk.isBusy(); }, 60s));
    ASSERT_TRUE(turned(8, 97));
    ASSERT_TRUE(recorded());
    expectRightAndDatedNow(points.points().back());
}

TEST_P(ClockJumpTest, PointsKeepTheOrderOfTheirWorkNotOfTheirDates) {
    ASSERT_TRUE(recorded());
    const QDateTime first = points.points().back().observation.utc;
    jump();
    ASSERT_TRUE(turned(8, 97));
    ASSERT_TRUE(recorded());

    ASSERT_EQ(points.points().size(), 2U);
    EXPECT_EQ(points.points()[0].id, QStringLiteral("1"));
    EXPECT_EQ(points.points()[1].id, QStringLiteral("2"));
    EXPECT_LT(points.points()[0].row_id, points.points()[1].row_id);
    EXPECT_NEAR(static_cast<double>(first.secsTo(points.points()[1].observation.utc)),
                static_cast<double>(GetParam().count()), 60.0);
    EXPECT_THAT(bars, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(By, ClockJumpTest, testing::Values(-30 * 86400s, -3600s, 3600s, 30 * 86400s),
                         [](const testing::TestParamInfo<std::chrono::seconds>& jump) {
                             const auto hours = std::chrono::duration_cast<std::chrono::hours>(jump.param).count();
                             return std::string(hours < 0 ? "Back" : "Forth") + std::to_string(std::abs(hours)) + "h";
                         });

}  // namespace
}  // namespace pmts::app
