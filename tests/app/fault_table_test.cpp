#include "app/field_fixture.hpp"
#include "pmts/app/desk/connection_checks.hpp"
#include "pmts/app/desk/simulation_desk.hpp"

#include <limits>

namespace pmts::app {
namespace {

using testing::HasSubstr;

enum class During { kTurning, kRecording };

/// The screen says no more than it does without the trouble.
constexpr const char* kHealed = nullptr;
/// It ends by itself, as the simulated instrument says of this fault.
constexpr const char* kByItself = nullptr;

/// A trouble of the protocol page's fault table, what the surveyor does meanwhile, what is read on the screen, and how
/// the trouble ends.
struct Fault {
    const char* name;
    const char* order;        ///< as the simulated instrument takes it
    During during;
    const char* sentence;     ///< part of what is shown, or kHealed
    const char* lifted_when;  ///< what somebody does about it before work goes on, or kByItself
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.order; }

std::string nameOf(const testing::TestParamInfo<Fault>& info) { return info.param.name; }

class FaultTableTest : public FieldTest, public testing::WithParamInterface<Fault> {
protected:
    explicit FaultTableTest(const simulator::StationSettings& settings = {}) : FieldTest(settings) {}
    void SetUp() override {
        connectInstrument();
        openJob();
        ASSERT_TRUE(turnTo(5, 98));
        listen();
    }
    void listen() {
        QObject::connect(&messages, &MessageCentre::barKept, &recording, [this](const Message& bar) { note(bar); });
        QObject::connect(&messages, &MessageCentre::toastShown, &recording, [this](const Message& toast) { note(toast); });
        said.clear();
    }
    void note(const Message& message) {
        said += QStringList{message.happened, message.remedy, message.details}.join(u' ').trimmed() + u'\n';
    }
    /// One order, or several with a blank between.
    void inject(const char* orders) {
        for (const QString& order : QString::fromLatin1(orders).split(u' ')) {
            ASSERT_TRUE(station.injectFault(order).has_value()) << orders;
        }
    }
    /// Of the one that struck least.
    [[nodiscard]] int timesStruck(const char* orders) const {
        int least = std::numeric_limits<int>::max();
        for (const QString& order : QString::fromLatin1(orders).split(u' ')) {
            least = std::min(least, station.timesStruck(order.section(u',', 0, 0).section(u'=', 0, 0)));
        }
        return least;
    }
    /// Everything that the screen said since the fault: messages, the line of the shot, the target unless it is reached.
    [[nodiscard]] std::string words() const {
        const bool is_reached = targeting.target() && targeting.target()->state == MoveState::kArrived;
        const QString target = targeting.target() && !is_reached ? targeting.target()->sentence : QString();
        return (said + recording.readings().sentence + u'\n' + target).trimmed().toStdString();
    }
    /// What it says when nothing is wrong.
    [[nodiscard]] static std::string wordsWithoutTrouble(During during) {
        return during == During::kTurning ? "" : "Point 1 is recorded.\nPoint 1 is recorded.";
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
    void expectNothingWrongRecorded() const {
        for (const survey::Point& point : points.points()) {
            EXPECT_TRUE(isRight(point) || !point.observation.absurd_reason.isEmpty())
                << point.observation.raw_reply.toStdString();
        }
    }

    QString said;
    SimulationDesk simulation;
    ConnectionPresenter connection{instrument, simulation, live, gate, preferences, messages};
};

TEST_P(FaultTableTest, IsSaidNothingWrongIsRecordedAndWorkGoesOn) {
    const Fault& fault = GetParam();
    inject(fault.order);
    const bool ended = fault.during == During::kTurning ? turnTo(6, 97.5) : recordPoint();
    pass(5s);

    EXPECT_TRUE(ended) << "the action has no end";
    EXPECT_GT(timesStruck(fault.order), 0) << "nothing happened that could be survived";
    if (fault.sentence == kHealed) {
        EXPECT_EQ(words(), wordsWithoutTrouble(fault.during));
    } else {
        EXPECT_THAT(words(), HasSubstr(fault.sentence));
    }
    if (fault.lifted_when != kByItself) {
        inject("none");
    }
    EXPECT_TRUE(worksAgain()) << words();
    expectNothingWrongRecorded();
}

using enum During;

INSTANTIATE_TEST_SUITE_P(
    Rows, FaultTableTest,
    testing::Values(
        // Absorbing target: endless retry.
        Fault{"AbsorbingTarget", "no_signal", kRecording, "No distance came back", "the prism is uncovered"},
        // Late and lost bytes, overrun buffers.
        Fault{"LateAnswer", "late=3", kRecording, kHealed, kByItself},
        Fault{"LostBytes", "drop=0.02", kRecording, kHealed, "the plug is pushed in"},
        Fault{"GarbledAnswer", "garble", kRecording, kHealed, kByItself},
        Fault{"GarbledLine", "garble=0.01", kRecording, kHealed, "the plug is pushed in"},
        Fault{"HalfABlock", "half_block", kRecording, kHealed, kByItself},
        Fault{"AnswerTwice", "twice", kRecording, kHealed, kByItself},
        // Two masters: somebody works at the control unit.
        Fault{"ShortPanelTask", "panel_task=0.5", kTurning, kHealed, kByItself},
        Fault{"PanelTask", "panel_task=60", kTurning, "A channel inside the instrument is busy.", kByItself},
        // The distance is missing from RG for many seconds.
        Fault{"DistanceLate", "distance_late=60", kRecording, "No distance came back", kByItself},
        // TG without effect, as on a body without control unit.
        Fault{"TriggerIgnored", "tg_ignored", kRecording, "No distance came back", "the control unit is put on"},
        // Wrong connector pins.
        Fault{"Info23Loop", "info_23_loop=0.3", kRecording, "a plug that touches the three bus pins", "the plug is changed"},
        // Line errors 21.1, .2, .4, .8 and their sums.
        Fault{"Overrun", "line_error=1", kRecording, kHealed, kByItself},
        Fault{"ParityError", "line_error=2", kRecording, kHealed, kByItself},
        Fault{"FramingError", "line_error=4", kRecording, kHealed, kByItself},
        Fault{"BreakReceived", "line_error=12", kRecording, kHealed, kByItself},
        Fault{"LineErrorsWithoutEnd", "line_error=4,times=0", kRecording, "The serial line was disturbed.", "the plug is pushed in"},
        // Battery, power, level; an instrument that comes back within the motion's limit has carried on.
        Fault{"BatteryLow", "battery_low", kRecording, "The battery of the instrument is low.", "the battery is changed"},
        Fault{"SwitchesItselfOff", "power_off=8", kTurning, kHealed, kByItself},
        Fault{"StaysOffLong", "power_off=90", kTurning, "PMTS connects again by itself", kByItself},
        Fault{"LevelLost", "level_loss", kTurning, "Level it", "somebody levels it"},
        // Target and motors.
        Fault{"TargetLost", "target_lost", kRecording, "target was lost", kByItself},
        Fault{"TargetNotFound", "target_not_found", kTurning, "not found", kByItself},
        Fault{"AccuracyNotReachedH", "residual_h=60", kTurning, "beside its target", "the wind falls"},
        Fault{"AccuracyNotReachedV", "residual_v=60", kTurning, "beside its target", "the wind falls"},
        Fault{"AccuracyNotReachedBoth", "residual_h=60 residual_v=60", kTurning, "beside its target", "the wind falls"},
        // Said by the instrument, but its circles say otherwise: arrival is verified, not believed.
        Fault{"Info157AtTheTarget", "info=157,on=WS", kTurning, kHealed, kByItself},
        Fault{"MotorOverloadH", "motor_overload_h", kTurning, "The horizontal motor is overloaded.", kByItself},
        Fault{"MotorOverloadV", "motor_overload_v", kTurning, "The vertical motor is overloaded.", kByItself},
        Fault{"EndSwitch", "end_switch", kTurning, "reached its end switch", kByItself},
        // A jump after swapping prisms, memory lost, old backup cell.
        Fault{"DistanceJump", "distance_jump", kRecording, kHealed, kByItself},
        Fault{"MemoryLost", "memory_lost", kRecording, "A check sum in the instrument's memory is wrong", kByItself},
        Fault{"MemoryLostOfCell", "info=54,on=RG", kRecording, "The instrument has lost its memory. Set units", kByItself},
        Fault{"BackupCellOld", "info=26,on=RG", kRecording, "The backup battery of the instrument is old.", kByItself},
        // Block ends.
        Fault{"EndMarkLost", "missing_eot", kRecording, kHealed, kByItself},
        Fault{"StrayEndMarks", "stray_end_marks", kRecording, kHealed, kByItself}),
    nameOf);

class FaultsOfTwoTest : public FaultTableTest {};

/// Start-up while the host is busy with video (thesis 8.3.4): bytes of the first questions are not heard.
class StartUpFaultTest : public FaultTableTest {
protected:
    explicit StartUpFaultTest(const simulator::StationSettings& settings = {}) : FaultTableTest(settings) {}
    void SetUp() override { listen(); }
    /// Pictures every 40 ms all the while.
    bool connectBesideVideo(core::Duration limit) {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        connection.connectSerial(choice);
        const core::Duration latest = clock.now() + limit;
        while (instrument.connectionState() != ConnectionState::kConnected && clock.now() < latest) {
            camera->show(clock.now());
            pass(40ms);
        }
        return instrument.connectionState() == ConnectionState::kConnected;
    }
};

TEST_F(StartUpFaultTest, AnInstrumentThatStillInitialisesIsFoundBesideTheVideo) {
    inject("initialising=2");

    ASSERT_TRUE(connectBesideVideo(60s)) << words();
    EXPECT_GT(timesStruck("initialising"), 0);
    EXPECT_EQ(said.toStdString(), "");
    openJob();
    EXPECT_TRUE(worksAgain()) << words();
    expectNothingWrongRecorded();
}

TEST_F(StartUpFaultTest, AnInstrumentThatInitialisesTooLongIsNamedAndFoundAtTheNextTry) {
    inject("initialising=30");

    ASSERT_FALSE(connectBesideVideo(25s));
    EXPECT_THAT(said.toStdString(), HasSubstr("Nothing answers on this port."));
    pass(10s);
    ASSERT_TRUE(connectBesideVideo(60s)) << words();
    openJob();
    EXPECT_TRUE(worksAgain()) << words();
}

/// Label 79 = 0: no block end, every answer ends with silence.
class NoEndMarkTest : public StartUpFaultTest {
protected:
    static simulator::StationSettings withoutEndMark() {
        simulator::StationSettings settings;
        settings.end_mark = 0;
        return settings;
    }
    NoEndMarkTest() : StartUpFaultTest(withoutEndMark()) {}
    ConnectionChecks checks{instrument};
};

TEST_F(NoEndMarkTest, IsNamedInTheCheckListAndWorkGoesOn) {
    ASSERT_TRUE(connectBesideVideo(60s)) << words();
    EXPECT_EQ(instrument.identity()->end_mark, std::nullopt);
    EXPECT_THAT(checks.items().at(ConnectionChecks::kEndMark).sentence.toStdString(), HasSubstr("set 62"));
    openJob();
    EXPECT_TRUE(worksAgain()) << words();
    expectNothingWrongRecorded();
}

/// Auto power-off after 60 s idle: the poll of the circles keeps the instrument awake, a panel that only looks does not.
TEST_F(FaultsOfTwoTest, AnInstrumentThatIsPolledDoesNotSwitchItselfOff) {
    inject("auto_power_off=60");
    pass(5min);

    EXPECT_EQ(timesStruck("auto_power_off"), 0);
    EXPECT_TRUE(station.isOn());
    EXPECT_EQ(said.toStdString(), "");
}

TEST_F(FaultsOfTwoTest, AnInstrumentLeftAloneSwitchesItselfOffIsMissedAndComesBack) {
    inject("auto_power_off=60");
    ControlSettings control;
    control.panel.emplace();
    control.panel->path = QStringLiteral("panel");
    control.mode = scheduler::ControlMode::kPanel;
    instrument.setControl(control);
    pass(90s);
    EXPECT_EQ(timesStruck("auto_power_off"), 1);
    EXPECT_FALSE(station.isOn());

    control.mode = scheduler::ControlMode::kComputer;
    instrument.setControl(control);
    EXPECT_TRUE(until([this] { return said.contains(QLatin1String("answer")); }, 60s)) << words();
    station.receiveBreak();  // somebody presses its key; it asks whether to go on, and he says yes
    station.receive("Y\r");
    EXPECT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }, 120s)) << words();
    EXPECT_TRUE(worksAgain()) << words();
    expectNothingWrongRecorded();
}

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

/// A dead backup cell takes the units with it: angles that are still taken for degrees would be wrong by a tenth.
TEST_F(FaultsOfTwoTest, UnitsThatGoWithTheMemoryAreAskedForAgain) {
    instrument.writeLabel(23, QStringLiteral("1112"));  // degrees, minutes, seconds
    pass(5s);
    ASSERT_TRUE(turnTo(6, 97.5));
    ASSERT_NEAR(true_pointing->at(clock.now()).ha.gon(), 6.0, 20e-4);

    inject("memory_lost");
    pass(10s);
    EXPECT_EQ(instrument.identity()->units.angle, protocol::WireAngleUnit::kGon);
    EXPECT_THAT(words(), HasSubstr("Check units, prism constant and ppm on the instrument"));
    EXPECT_TRUE(worksAgain()) << words();
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 8.0, 20e-4);
    expectNothingWrongRecorded();
    ASSERT_FALSE(messages.bars().empty()) << "it goes on being told after a good measurement";
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("check sum"))) << newestBar(messages).toStdString();
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
