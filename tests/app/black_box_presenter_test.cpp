#include "pmts/app/line/black_box_presenter.hpp"

#include "field_fixture.hpp"
#include "line/black_box_records.hpp"
#include "line/unasked_bytes.hpp"
#include "pmts/app/line/instrument_health.hpp"
#include "pmts/app/line/line_findings.hpp"
#include "pmts/blackbox/recording.hpp"
#include "support/run_until.hpp"

#include <QCborArray>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using blackbox::Kind;
using testing::Contains;

/// A field whose line is recorded.
class BlackBoxTest : public FieldTest {
protected:
    void TearDown() override {
        recorded.disconnectInstrument();
        FieldTest::TearDown();
    }
    InstrumentWiring recordedWiring() {
        auto wires = wiring();
        wires.make_link = [this](const SerialChoice&) { return black_box.tapped(makeLink()); };
        return wires;
    }
    void start() {
        black_box.watch(recorded);
        black_box.watch(live, gate);
        black_box.start();
        black_box.waitUntilWritten();
    }
    void connectRecorded() {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        recorded.connectSerial(choice);
        ASSERT_TRUE(until([this] { return recorded.connectionState() == ConnectionState::kConnected; }));
        pass(1s);
    }
    std::vector<QCborMap> of(Kind kind) {
        black_box.waitUntilWritten();
        std::vector<QCborMap> maps;
        const auto written = blackbox::Recording::open(black_box.path());
        for (const blackbox::Entry& entry : (*written)->entries()) {
            if (entry.kind == kind) {
                maps.push_back((*written)->body(entry));
            }
        }
        return maps;
    }
    /// What a replay finds in the bytes of the instrument beside the answers.
    std::vector<std::string> leftOver() {
        black_box.waitUntilWritten();
        const auto written = blackbox::Recording::open(black_box.path());
        UnaskedBytes bytes;
        std::vector<std::string> left;
        for (const blackbox::Entry& entry : (*written)->entries()) {
            const QCborMap map = (*written)->body(entry);
            if (entry.kind == Kind::kBytes && text(map, "dir") == QLatin1String("<")) {
                bytes.addReceived(map.value(QStringLiteral("bytes")).toByteArray().toStdString(), entry.at);
            } else if (entry.kind == Kind::kTransaction) {
                for (const UnaskedPiece& piece : bytes.take(transactionFrom(map))) {
                    left.push_back(piece.bytes);
                }
            }
        }
        return left;
    }
    static QString text(const QCborMap& map, const char* name) { return map.value(QLatin1String(name)).toString(); }

    BlackBoxPresenter black_box{folder.filePath(QStringLiteral("box")), preferences, messages, clock};
    InstrumentDesk recorded{gate, recordedWiring()};
};

TEST_F(BlackBoxTest, EveryByteThatReachedTheInstrumentIsInTheBox) {
    start();
    connectRecorded();

    std::string in_box;
    for (const QCborMap& map : of(Kind::kBytes)) {
        if (text(map, "dir") == QLatin1String(">")) {
            in_box += map.value(QStringLiteral("bytes")).toByteArray().toStdString();
        }
    }
    EXPECT_GT(sent.size(), 30U);
    EXPECT_EQ(in_box.substr(0, sent.size()), sent) << "what was written last may still be on its way";
}

TEST_F(BlackBoxTest, OfAHealthyLineEveryByteBelongsToATransaction) {
    start();
    connectRecorded();
    recorded.measureDistance();
    pass(20s);

    EXPECT_GT(of(Kind::kTransaction).size(), 200U);
    EXPECT_THAT(leftOver(), testing::IsEmpty());
}

TEST_F(BlackBoxTest, AnAnswerThatCameTwiceIsLeftOver) {
    start();
    connectRecorded();
    ASSERT_TRUE(station.injectFault(QStringLiteral("twice,on=RG")).has_value());
    pass(5s);

    EXPECT_THAT(leftOver(), testing::ElementsAre(testing::MatchesRegex("[78]=[0-9.]+\r\n")));
}

TEST_F(BlackBoxTest, TheBenchForLinesReadsTheDialogueFromTheBox) {
    start();
    connectRecorded();
    black_box.waitUntilWritten();

    const auto dialogue = readLineRecording(black_box.path(), {}, {});
    ASSERT_TRUE(dialogue) << dialogue.error().sentence().toStdString();
    const auto found = decoded(*examined(*dialogue), {});
    ASSERT_TRUE(found);
    std::string to_instrument;
    for (const auto& character : found->characters) {
        to_instrument += character.side == protocol::TalkSide::kToInstrument ? std::string(1, static_cast<char>(character.value)) : "";
    }
    EXPECT_EQ(to_instrument.substr(0, sent.size()), sent) << "what was written last may still be on its way";
    EXPECT_FALSE(found->values.empty()) << "what the station answered";
    EXPECT_GT(found->characters.back().sample, 500'000U) << "microseconds of a second and more";
}

TEST_F(BlackBoxTest, TransactionsReadingsAndTheConnectionAreInTheBox) {
    start();
    connectRecorded();

    EXPECT_GT(of(Kind::kTransaction).size(), 5U);
    EXPECT_GT(of(Kind::kReading).size(), 1U);
    EXPECT_EQ(of(Kind::kConnection).back().value(QStringLiteral("state")).toInteger(), static_cast<int>(ConnectionState::kConnected));
    EXPECT_EQ(text(of(Kind::kConnection).back(), "serial_number"), recorded.identity()->serial_number);
}

TEST_F(BlackBoxTest, EachPictureHasItsTimeAndFewAreKeptReduced) {
    start();
    for (int i = 0; i < 30; ++i) {
        camera->show(clock.now(), cv::Mat(1080, 1920, CV_8UC3, cv::Scalar::all(90)));
        black_box.waitUntilWritten();
        pass(100ms);
    }

    EXPECT_EQ(of(Kind::kTick).size(), 30U);
    const auto pictures = of(Kind::kFrame);
    EXPECT_GE(pictures.size(), 3U);
    EXPECT_LE(pictures.size(), 4U);
    EXPECT_EQ(pictures[0].value(QStringLiteral("width")).toInteger(), 1920);
    EXPECT_LT(pictures[0].value(QStringLiteral("jpeg")).toByteArray().size(), 100000);
}

TEST_F(BlackBoxTest, MessagesActionsAirAndLogLinesAreInTheBox) {
    LogModel log{QString()};
    black_box.watch(log);
    start();
    messages.toast(QStringLiteral("Point 104 is recorded."));
    messages.warn(QStringLiteral("The battery is low."), QStringLiteral("Change it."));
    black_box.noteAction(QStringLiteral("Move"), QStringLiteral("action"), QPoint(3, 4));
    black_box.noteAir(21.5);
    log.append({.utc = clock.utcNow(), .level = QtWarningMsg, .category = QStringLiteral("pmts.job"), .text = QStringLiteral("slow disk")});

    const auto told = of(Kind::kMessage);
    EXPECT_EQ(text(told.at(told.size() - 2).value(QStringLiteral("toast")).toMap(), "happened"), QStringLiteral("Point 104 is recorded."));
    EXPECT_EQ(text(told.back().value(QStringLiteral("bars")).toArray().at(0).toMap(), "remedy"), QStringLiteral("Change it."));
    EXPECT_EQ(text(of(Kind::kAction).back(), "what"), QStringLiteral("Move"));
    EXPECT_EQ(of(Kind::kAir).back().value(QStringLiteral("temperature_c")).toDouble(), 21.5);
    EXPECT_EQ(text(of(Kind::kLog).back(), "text"), QStringLiteral("slow disk"));
}

TEST_F(BlackBoxTest, TheAirTheInstrumentUsesIsReadAtConnectAndToldWithItsSource) {
    InstrumentHealth health{recorded, preferences, messages, clock};
    QObject::connect(&health, &InstrumentHealth::changed, [&] { black_box.noteAir(health.air()); });
    start();
    station.receive("WG,74=1001.5\r");
    station.receive("WG,30=12.0\r");
    connectRecorded();
    ASSERT_TRUE(until([&] { return health.air().ppm.has_value(); })) << health.airUsed().details.toStdString();

    const QCborMap air = of(Kind::kAir).back();
    EXPECT_EQ(air.value(QStringLiteral("temperature_c")).toDouble(), 20.0);
    EXPECT_EQ(text(air, "source"), QStringLiteral("instrument"));
    EXPECT_EQ(air.value(QStringLiteral("label_56_c")).toDouble(), 20.0);
    EXPECT_EQ(air.value(QStringLiteral("label_74_mbar")).toDouble(), 1001.5);
    EXPECT_EQ(air.value(QStringLiteral("label_30_ppm")).toDouble(), 12.0);
    EXPECT_TRUE(health.airUsed().text.contains(QStringLiteral("1001.5 mbar"))) << health.airUsed().text.toStdString();

    black_box.noteAir(18.0);
    EXPECT_EQ(of(Kind::kAir).back().value(QStringLiteral("temperature_c")).toDouble(), 18.0);
    EXPECT_EQ(text(of(Kind::kAir).back(), "source"), QStringLiteral("lab"));
}

TEST_F(BlackBoxTest, ANewFileBeginsWithConnectionControlAndAir) {
    start();
    connectRecorded();
    instrument::ControlStatus computers;
    computers.mode = scheduler::ControlMode::kComputer;
    Q_EMIT recorded.controlChanged(computers);
    black_box.noteAir(21.5);
    const QString first = black_box.path();
    black_box.startAgain();

    EXPECT_EQ(of(Kind::kConnection).back().value(QStringLiteral("state")).toInteger(), static_cast<int>(ConnectionState::kConnected));
    ASSERT_NE(black_box.path(), first);
    ASSERT_FALSE(of(Kind::kControl).empty());
    EXPECT_EQ(of(Kind::kControl).back().value(QStringLiteral("mode")).toInteger(), static_cast<int>(scheduler::ControlMode::kComputer));
    ASSERT_FALSE(of(Kind::kAir).empty());
    EXPECT_EQ(of(Kind::kAir).back().value(QStringLiteral("temperature_c")).toDouble(), 21.5);
}

TEST_F(BlackBoxTest, SwitchedOffNothingIsWrittenAndSwitchedOnANewFileBegins) {
    start();
    const QString first = black_box.path();
    black_box.setSettings({.on = false});
    EXPECT_FALSE(black_box.isRecording());
    EXPECT_EQ(black_box.status().state, DeviceState::kIdle);
    black_box.setSettings({.on = true});
    black_box.waitUntilWritten();
    EXPECT_TRUE(black_box.isRecording());
    EXPECT_NE(black_box.path(), first);
}

TEST_F(BlackBoxTest, AnotherRateOfPicturesBeginsNoNewFileAndMoreRoomDoes) {
    start();
    const QString first = black_box.path();
    black_box.setSettings({.on = true, .kept_mb = 300, .frames_per_s = 5.0});
    black_box.waitUntilWritten();
    EXPECT_EQ(black_box.path(), first);
    for (int i = 0; i < 11; ++i) {
        camera->show(clock.now());
        black_box.waitUntilWritten();
        pass(100ms);
    }
    EXPECT_GE(of(Kind::kFrame).size(), 5U) << "and yet it is followed";
    black_box.setSettings({.on = true, .kept_mb = 400, .frames_per_s = 5.0});
    black_box.waitUntilWritten();
    EXPECT_NE(black_box.path(), first);
}

TEST_F(BlackBoxTest, AFolderThatCannotBeWrittenIsAMessageAndTheWorkGoesOn) {
    BlackBoxPresenter nowhere{QStringLiteral("/proc/none/box"), preferences, messages, clock};
    nowhere.start();
    nowhere.waitUntilWritten();
    ASSERT_TRUE(test::runUntil([this] { return !messages.bars().empty(); })) << "nothing was said";

    EXPECT_EQ(nowhere.status().state, DeviceState::kFailed);
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("Your work goes on."))) << newestBar(messages).toStdString();
    connectInstrument();
}

TEST(BlackBoxSettingsTest, AreKeptAndNonsenseIsNotTaken) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("s.ini"));
    Settings settings;
    settings.black_box = {.on = false, .kept_mb = 1000, .frames_per_s = 2.0};
    ASSERT_TRUE(settings.save(path).has_value());
    EXPECT_EQ(Settings::load(path).black_box, settings.black_box);
    settings.black_box.kept_mb = -4;
    ASSERT_TRUE(settings.save(path).has_value());
    EXPECT_EQ(Settings::load(path).black_box.kept_mb, BlackBoxSettings().kept_mb);
}

}  // namespace
}  // namespace pmts::app
