#include "pmts/routines/instrument.hpp"

#include "driver_bench.hpp"
#include "support/child_program.hpp"
#include "support/scripted_link.hpp"

#include <QFile>
#include <QTemporaryDir>

#include <csignal>

namespace pmts::end_to_end {
namespace {

using routines::Dialect;
using routines::Instrument;
using routines::InstrumentSettings;
using routines::PortData;
using testing::HasSubstr;

std::string sentenceOf(const core::Error& error) { return error.sentence().toStdString(); }

/// The routines of the annexure over the simulated instrument, the line in memory, a virtual clock.
class RoutinesTest : public testing::Test {
protected:
    RoutinesTest() {
        far->on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { far->write(bytes); };
        EXPECT_TRUE(far->open().has_value());
    }

    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task) {
        auto outcome = test::runToEnd(std::move(task), clock, 10min);
        return outcome ? *outcome : core::Result<T>(core::fail(ErrorKind::kTimeOut, QStringLiteral("no end")));
    }
    void start() { ASSERT_TRUE(run(instrument->Start()).has_value()); }

    core::VirtualClock clock;
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    transport::MemoryPair wire = transport::makeMemoryPair(clock);
    std::unique_ptr<transport::MemoryLink> far = std::move(wire.second);
    simulator::Station station{{}, sharedYard(), truth, clock};
    std::optional<Instrument> instrument{std::in_place, std::move(wire.first), clock};
};

TEST_F(RoutinesTest, StartSaysWhoIsThere) {
    const auto who = run(instrument->Start());

    ASSERT_TRUE(who.has_value());
    EXPECT_EQ(who->serial_number, QStringLiteral("620123"));
}

TEST_F(RoutinesTest, StartSwitchesAnInstrumentOnWhereItIsAskedTo) {
    ASSERT_TRUE(station.injectFault(QStringLiteral("power_off=0")).has_value());
    ASSERT_FALSE(run(instrument->Start()).has_value()) << "it is off";

    auto pair = transport::makeMemoryPair(clock);
    far = std::move(pair.second);
    far->on_received = [this](std::string_view bytes) { station.receive(bytes); };
    far->on_break = [this] { station.receiveBreak(); };
    ASSERT_TRUE(far->open().has_value());
    InstrumentSettings settings;
    settings.switch_on.emplace();
    instrument.emplace(std::move(pair.first), clock, settings);
    const auto who = run(instrument->Start());
    ASSERT_TRUE(who.has_value()) << sentenceOf(who.error());
    EXPECT_EQ(who->serial_number, QStringLiteral("620123"));
}

TEST_F(RoutinesTest, NothingWorksBeforeStartAndTheSentenceSaysSo) {
    EXPECT_THAT(sentenceOf(run(instrument->movH(10.0)).error()), HasSubstr("Start"));
    EXPECT_EQ(run(instrument->Get(7)).error().kind, ErrorKind::kNotConnected);
}

TEST_F(RoutinesTest, SetWritesALabelAndGetReadsIt) {
    start();
    EXPECT_TRUE(run(instrument->Set(5, QStringLiteral("104"))).has_value());
    EXPECT_EQ(run(instrument->Get(5)).value(), QStringLiteral("104"));
}

TEST_F(RoutinesTest, SetOfAMeasuredLabelIsAnErrorInWords) {
    start();
    const auto outcome = run(instrument->Set(9, QStringLiteral("12.5")));

    ASSERT_FALSE(outcome.has_value());
    EXPECT_FALSE(outcome.error().happened.isEmpty());
}

TEST_F(RoutinesTest, MovHMovVAndMovHVTurnTheTelescope) {
    start();
    EXPECT_TRUE(run(instrument->movH(377.5612)).has_value());
    EXPECT_NEAR(truth->at(clock.now()).ha.gon(), 377.5612, 20e-4);
    EXPECT_TRUE(run(instrument->movV(96.1684)).has_value());
    EXPECT_NEAR(truth->at(clock.now()).va.gon(), 96.1684, 20e-4);
    const auto arrived = run(instrument->movHV(12.5, 98.3));

    ASSERT_TRUE(arrived.has_value());
    EXPECT_NEAR(truth->at(clock.now()).ha.gon(), 12.5, 20e-4);
    EXPECT_NEAR(arrived->va.gon(), 98.3, 20e-4);
}

TEST_F(RoutinesTest, DistIsTheWayToTheWall) {
    start();
    ASSERT_TRUE(run(instrument->movHV(0.0, 100.0)).has_value());
    const auto shot = run(instrument->Dist());

    ASSERT_TRUE(shot.has_value());
    EXPECT_NEAR(shot->slope_distance_m, 20.0, 0.013);  // four sigma of 3 mm + 3 ppm
}

TEST_F(RoutinesTest, DistIntoTheBlackIsAnAbsurdPointAndTheInstrumentWorksOn) {
    start();
    ASSERT_TRUE(run(instrument->movHV(200.0, 100.0)).has_value());
    EXPECT_EQ(run(instrument->Dist()).error().kind, ErrorKind::kAbsurdPoint);
    EXPECT_TRUE(run(instrument->movHV(0.0, 100.0)).has_value());
}

TEST_F(RoutinesTest, Prg1SendsOneInstructionAndGivesTheReplyAsItCame) {
    start();
    EXPECT_EQ(run(instrument->prg1("RG,23")).value().raw, "23=1111\r\n");
    EXPECT_EQ(run(instrument->prg1("WG,120=1")).error().kind, ErrorKind::kRefused);
    EXPECT_EQ(run(instrument->prg1("KM=JOB1")).error().kind, ErrorKind::kRefused);
    EXPECT_EQ(run(instrument->prg1("OM=JOB1")).error().kind, ErrorKind::kUnsupported);
    EXPECT_EQ(run(instrument->prg1("RG,7\rRG,8")).error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(run(instrument->prg1("PG,3=9")).value().status, (protocol::Status{35, std::nullopt}));
}

TEST_F(RoutinesTest, UnitsChangedThroughPrg1AreKnownToTheNextMotion) {
    start();
    ASSERT_TRUE(run(instrument->prg1("WG,79=35")).has_value());  // the block end is # from now on
    const auto arrived = run(instrument->movHV(50.0, 100.0));

    ASSERT_TRUE(arrived.has_value()) << sentenceOf(arrived.error());
    EXPECT_NEAR(truth->at(clock.now()).ha.gon(), 50.0, 20e-4);
}

TEST_F(RoutinesTest, TimerEventTellsReadingsAndBlocksNobodyAskedFor) {
    std::vector<PortData> told;
    instrument->Timer1_Timer = [&told](const PortData& data) { told.push_back(data); };
    start();
    ASSERT_TRUE(run(instrument->movHV(12.5, 98.3)).has_value());
    ASSERT_FALSE(told.empty());
    ASSERT_TRUE(told.back().pointing.has_value());
    EXPECT_NEAR(told.back().pointing->ha.gon(), 12.5, 20e-4);

    told.clear();
    far->write("0\r\n7=10.2345\r\n8=99.0000\r\n>");
    clock.advance(1s);
    ASSERT_EQ(told.size(), 1U);
    ASSERT_TRUE(told[0].block.has_value());
    EXPECT_NEAR(told[0].block->ha->gon(), 10.2345, 1e-9);
}

TEST_F(RoutinesTest, OneAtATimeAndStopEndsIt) {
    start();
    const auto turning = test::begun(instrument->movHV(150.0, 100.0));
    clock.advance(500ms);
    EXPECT_EQ(run(instrument->Get(5)).error().kind, ErrorKind::kRefused);
    instrument->stop();
    clock.advance(20s);

    ASSERT_TRUE(turning->has_value());
    EXPECT_EQ(turning->value().error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(run(instrument->Get(5)).has_value());
}

TEST_F(RoutinesTest, GoingAwayEndsWhatRuns) {
    start();
    const auto turning = test::begun(instrument->movHV(150.0, 100.0));
    clock.advance(500ms);
    instrument.reset();
    clock.advance(60s);

    ASSERT_TRUE(turning->has_value());
    EXPECT_EQ(turning->value().error().kind, ErrorKind::kCancelled);
}

TEST_F(RoutinesTest, TheExternalInterfaceHasNoLaser) {
    start();
    EXPECT_EQ(run(instrument->laserON()).error().kind, ErrorKind::kUnsupported);
    EXPECT_THAT(sentenceOf(run(instrument->laserOFF()).error()), HasSubstr("laser"));
}

/// The base on its bus, as the published program saw it: what it answers, in turn.
class BusRoutinesTest : public testing::Test {
protected:
    BusRoutinesTest() {
        far->respond = [this](const std::string& command) { return answerTo(command); };
        far->reply_delay = 20ms;
    }
    static std::string tableText() {
        QFile file(QStringLiteral(PMTS_RESOURCES "/instructions/geodimeter-bus.txt"));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    }
    static InstrumentSettings onTheBus() {
        InstrumentSettings settings;
        settings.dialect = Dialect::kBus;
        settings.instructions = protocol::readInstructionTable(tableText());
        return settings;
    }
    std::optional<std::string> answerTo(const std::string& command) {
        sent.push_back(command);
        if (command == "PV,4=0\r") {
            return std::nullopt;  // nothing is listed for it
        }
        return command.starts_with("WV") ? "0.8\r\x04" : "240.8\r\x04";
    }
    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task) {
        auto outcome = test::runToEnd(std::move(task), clock, 1min);
        return outcome ? *outcome : core::Result<T>(core::fail(ErrorKind::kTimeOut, QStringLiteral("no end")));
    }
    void start() {
        auto starting = test::begun(instrument.Start());
        far->say("A,166=96.16838\rA,165=177.56115\x04", 300ms);
        far->say("A,166=96.16838\rA,165=177.56115\x04", 600ms);
        clock.advance(1s);
        ASSERT_TRUE(starting->has_value() && starting->value().has_value());
        sent.clear();
    }

    core::VirtualClock clock;
    std::vector<std::string> sent;
    std::unique_ptr<test::ScriptedLink> link = std::make_unique<test::ScriptedLink>(clock);
    test::ScriptedLink* far = link.get();
    Instrument instrument{std::move(link), clock, onTheBus()};
};

TEST_F(BusRoutinesTest, LaserOnSendsThePublishedSevenInstructions) {
    start();
    ASSERT_TRUE(run(instrument.laserON()).has_value());
    EXPECT_THAT(sent, testing::ElementsAre("WV,102=0\r", "PV,8=9\r", "PV,4=0\r", "WV,102=1\r", "WV,102=0\r", "PV,3=0\r",
                                           "WV,102=1\r"));
}

TEST_F(BusRoutinesTest, LaserOffWasNeverPublishedAndNothingIsSent) {
    start();
    const auto outcome = run(instrument.laserOFF());

    EXPECT_EQ(outcome.error().kind, ErrorKind::kUnsupported);
    EXPECT_THAT(sentenceOf(outcome.error()), HasSubstr("laser_off"));
    EXPECT_THAT(sent, testing::IsEmpty());
}

TEST_F(BusRoutinesTest, AStreamThatStopsIsToldOnce) {
    std::vector<core::Error> told;
    instrument.on_lost = [&told](const core::Error& error) { told.push_back(error); };
    start();
    clock.advance(1s);
    EXPECT_TRUE(told.empty());
    clock.advance(20s);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_THAT(sentenceOf(told[0]), HasSubstr("silent"));
}

TEST_F(BusRoutinesTest, Prg1SendsOneInstructionOfTheBus) {
    start();
    EXPECT_EQ(run(instrument.prg1("PV,3=0")).value().status, (protocol::Status{240, 8}));
    EXPECT_THAT(sent, testing::ElementsAre("PV,3=0\r"));
}

/// The example as its user starts it, over a real pty.
TEST(MeasurePointsTest, ExampleMeasuresAListOfPointings) {
    QTemporaryDir folder;
    const QString port = folder.filePath(QStringLiteral("geodimeter"));
    QProcess simulator, example;
    simulator.start(QStringLiteral(PMTS_SIM_PROGRAM), {"--link", port, "--time-scale", "50", "--seed", "3"});
    ASSERT_FALSE(test::nextLineOf(simulator).isEmpty());
    example.start(QStringLiteral(MEASURE_POINTS_PROGRAM), {port, "350,100", "352.5,99"});
    EXPECT_EQ(test::nextLineOf(example), QStringLiteral("HA_gon,VA_gon,SD_m"));
    const QStringList first = test::nextLineOf(example).split(u','), second = test::nextLineOf(example).split(u',');
    test::awaitEnd(example);
    ::kill(static_cast<pid_t>(simulator.processId()), SIGTERM);
    test::awaitEnd(simulator);

    EXPECT_EQ(example.exitCode(), 0) << example.readAllStandardError().toStdString();
    EXPECT_NEAR(first.value(0).toDouble(), 350.0, 30e-4);
    EXPECT_NEAR(second.value(1).toDouble(), 99.0, 30e-4);
    EXPECT_GT(second.value(2).toDouble(), 1.0);
}

TEST(MeasurePointsTest, ExampleSaysWhatItWants) {
    QProcess example;
    example.start(QStringLiteral(MEASURE_POINTS_PROGRAM), {"/dev/null", "north"});
    test::awaitEnd(example);

    EXPECT_EQ(example.exitCode(), 2);
    EXPECT_THAT(example.readAllStandardError().toStdString(), HasSubstr("usage: measure-points PORT HA,VA"));
}

}  // namespace
}  // namespace pmts::end_to_end
