#include "app/field_fixture.hpp"

namespace pmts::app {
namespace {

using testing::HasSubstr;

/// A trouble of the protocol page's fault table, what the surveyor does meanwhile, and what is read on the screen.
struct Fault {
    const char* name;
    const char* order;    ///< as the simulated instrument takes it
    bool while_turning;   ///< else while measuring and recording
    const char* sentence;  ///< part of what is shown; empty: it is healed without a word
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.order; }

std::string nameOf(const testing::TestParamInfo<Fault>& info) { return info.param.name; }

class FaultTableTest : public FieldTest, public testing::WithParamInterface<Fault> {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
        ASSERT_TRUE(turnTo(5, 98));
        QObject::connect(&messages, &MessageCentre::barKept, &recording, [this](const Message& bar) { note(bar); });
        QObject::connect(&messages, &MessageCentre::toastShown, &recording, [this](const Message& toast) { note(toast); });
        QObject::connect(&instrument, &InstrumentDesk::warningsChanged, &recording, [this](const auto& standing) {
            for (const core::Error& warning : standing) {
                shown += warning.sentence() + u'\n';
            }
        });
        shown.clear();
    }
    void note(const Message& message) { shown += message.happened + u' ' + message.remedy + u'\n'; }
    void inject(const char* order) { ASSERT_TRUE(station.injectFault(QString::fromLatin1(order)).has_value()) << order; }
    /// Everything that the screen said since the fault.
    [[nodiscard]] std::string words() const {
        const QString target = targeting.target() ? targeting.target()->sentence : QString();
        return (shown + recording.readings().sentence + u'\n' + target).toStdString();
    }
    /// As somebody who presses the same key again.
    bool worksAgain() {
        for (int i = 0; i < 5; ++i) {
            if (turnTo(8, 97) && targeting.target()->state == MoveState::kArrived && recordPoint() &&
                recording.readings().shot == ShotState::kRecorded) {
                return true;
            }
            pass(20s);
        }
        return false;
    }
    [[nodiscard]] bool isRight(const survey::Point& point) const {
        const auto echo = scene->echo(point.observation.pointing);
        return echo && point.observation.slope_distance_m &&
               std::abs(*point.observation.slope_distance_m - echo->distance_m) < 0.016;
    }

    QString shown;
};

TEST_P(FaultTableTest, IsSaidNothingWrongIsRecordedAndWorkGoesOn) {
    inject(GetParam().order);
    const bool ended = GetParam().while_turning ? turnTo(6, 97.5) : recordPoint();
    pass(5s);

    EXPECT_TRUE(ended) << "the action has no end";
    EXPECT_THAT(words(), HasSubstr(GetParam().sentence));
    inject("none");
    EXPECT_TRUE(worksAgain()) << words();
    for (const survey::Point& point : points.points()) {
        EXPECT_TRUE(isRight(point) || !point.observation.absurd_reason.isEmpty()) << point.observation.raw_reply.toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, FaultTableTest,
    testing::Values(
        // Absorbing target: endless retry.
        Fault{"AbsorbingTarget", "no_signal", false, "No distance came back"},
        // Start-up while the host is busy, late and lost bytes, overrun buffers.
        Fault{"Initialising", "initialising=4", true, ""},
        Fault{"LateAnswer", "late=3", false, ""},
        Fault{"LostBytes", "drop=0.02", false, ""},
        Fault{"GarbledAnswer", "garble", false, ""},
        Fault{"HalfABlock", "half_block", false, ""},
        Fault{"AnswerTwice", "twice", false, ""},
        // Two masters: somebody works at the control unit.
        Fault{"PanelTask", "panel_task=3", true, ""},
        // The distance is missing from RG for many seconds.
        Fault{"DistanceLate", "distance_late=60", false, "No distance came back"},
        // TG without effect, as on a body without control unit.
        Fault{"TriggerIgnored", "tg_ignored", false, "No distance came back"},
        // Wrong connector pins.
        Fault{"Info23Loop", "info_23_loop=0.3", false, ""},
        // Line errors 21.1, .2, .4, .8 and their sums.
        Fault{"Overrun", "line_error=1", false, ""},
        Fault{"ParityError", "line_error=2", false, ""},
        Fault{"FramingError", "line_error=4", false, ""},
        Fault{"BreakReceived", "line_error=12", false, ""},
        // Battery, power, level; an instrument that comes back within the motion's limit has carried on.
        Fault{"BatteryLow", "battery_low", false, "battery"},
        Fault{"SwitchesItselfOff", "power_off=8", true, ""},
        Fault{"LevelLost", "level_loss", true, "Level it"},
        // Target and motors.
        Fault{"TargetLost", "target_lost", false, "target was lost"},
        Fault{"TargetNotFound", "target_not_found", true, "not found"},
        Fault{"AccuracyNotReachedH", "residual_h=60", true, "beside its target"},
        Fault{"AccuracyNotReachedV", "residual_v=60", true, "beside its target"},
        Fault{"MotorOverloadH", "motor_overload_h", true, "motor"},
        Fault{"MotorOverloadV", "motor_overload_v", true, "motor"},
        Fault{"EndSwitch", "end_switch", true, "end"},
        // A jump after swapping prisms, memory lost, old backup cell.
        Fault{"DistanceJump", "distance_jump", false, ""},
        Fault{"MemoryLost", "memory_lost", false, ""},
        Fault{"BackupCellOld", "info=26", false, ""},
        // Block ends.
        Fault{"EndMarkLost", "missing_eot", false, ""},
        Fault{"StrayEndMarks", "stray_end_marks", false, ""}),
    nameOf);

class FaultsOfTwoTest : public FaultTableTest {};

/// Features L8: the thesis's base had to be started before the video.
class StartOrderTest : public FieldTest {};

TEST_F(StartOrderTest, VideoFirstThenTheInstrument) {
    showFrames();
    EXPECT_EQ(camera->state(), video::SourceState::kRunning);
    connectInstrument();
    openJob();
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());

    EXPECT_EQ(points.points().size(), 1U);
    showFrames();
    EXPECT_TRUE(live.scene().pointing.has_value()) << "pictures have their circle readings";
}

TEST_F(StartOrderTest, InstrumentFirstThenTheVideo) {
    camera->stop();
    connectInstrument();
    openJob();
    live.startCamera();
    showFrames();
    EXPECT_TRUE(live.scene().pointing.has_value());
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());

    EXPECT_EQ(points.points().size(), 1U);
}

/// Seed 4.7: a synchronous wait for a slow motion blocked everything.
TEST_F(FaultsOfTwoTest, ASlowMotionLeavesTheProgramAliveAndStopEndsIt) {
    targeting.aimAtText(QStringLiteral("190 gon"), QStringLiteral("100 gon"));
    targeting.move();
    pass(1s);
    EXPECT_TRUE(targeting.isMoving());
    targeting.stop();

    EXPECT_TRUE(until([this] { return !targeting.isMoving(); }, 5s));
    EXPECT_TRUE(worksAgain());
}

TEST_F(FaultsOfTwoTest, AMoveAskedForWhileADistanceIsPendingWaitsItsTurn) {
    recording.all();
    pass(500ms);
    ASSERT_TRUE(recording.isBusy());
    targeting.aimAtText(QStringLiteral("12 gon"), QStringLiteral("99 gon"));
    targeting.move();
    ASSERT_TRUE(until([this] { return !recording.isBusy() && !targeting.isMoving(); }));

    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_TRUE(isRight(points.points().front()));
    EXPECT_NEAR(points.points().front().observation.pointing.ha.gon(), 5.0, 20e-4) << "the shot belongs to where it began";
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 12.0, 20e-4);
}

}  // namespace
}  // namespace pmts::app
