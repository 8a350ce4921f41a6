#include "pmts/app/line/replay_presenter.hpp"

#include "line/black_box_records.hpp"
#include "field_fixture.hpp"
#include "support/run_until.hpp"

#include <QCborArray>
#include <QFile>
#include <gmock/gmock.h>

#include <limits>

namespace pmts::app {
namespace {

using blackbox::Kind;

/// A recording made by hand, shown on the desk of the field.
class ReplayTest : public FieldTest {
protected:
    ReplayTest() {
        QObject::connect(&instrument, &InstrumentDesk::transactionFinished, &timeline, &Timeline::addTransaction);
        QObject::connect(&instrument, &InstrumentDesk::controlChanged, &timeline, &Timeline::addControl);
        QObject::connect(&messages, &MessageCentre::toastShown, [this](const Message& toast) { toasts.append(toast.happened); });
    }

    void put(Kind kind, core::Duration at, const QCborMap& map) { file += blackbox::encoded({.kind = kind, .at = kZero + at, .body = blackbox::bodyOf(map)}); }

    /// Ten minutes: connected from the first second, a reading, a transaction and a log line each second, a picture every ten.
    void record() {
        put(Kind::kSession, 0s, {{QStringLiteral("utc"), QStringLiteral("2026-06-01T06:00:00.000Z")}});
        instrument::Identity identity;
        identity.model = QStringLiteral("Geodimeter 600");
        put(Kind::kConnection, 1s, mapOf(ConnectionState::kConnected, QStringLiteral("It answers."), identity));
        for (int second = 1; second <= 600; ++second) {
            const core::Duration at = 1s * second;
            if (second == 500) {
                Message bar;
                bar.happened = QStringLiteral("The instrument is gone.");
                put(Kind::kMessage, at, {{QStringLiteral("bars"), QCborArray{mapOf(bar)}}});
            }
            put(Kind::kReading, at, mapOf(geometry::Pointing{.ha = Angle::fromGon(second / 2.0), .va = Angle::fromGon(100)}));
            scheduler::TransactionRecord exchange;
            exchange.sent = "RG,7\r";
            exchange.received = "7=" + std::to_string(second) + ".0\r\n";
            exchange.queued_at = exchange.sent_at = kZero + at;
            exchange.finished_at = kZero + at + 50ms;
            put(Kind::kTransaction, at + 50ms, mapOf(exchange));
            put(Kind::kLog, at + 60ms, mapOf(LogLine{.utc = {}, .level = QtInfoMsg, .category = {}, .text = QString::number(second)}));
            if (second % 10 == 0) {
                camera::Frame frame;
                frame.image = cv::Mat(36, 64, CV_8UC3, cv::Scalar::all(second % 250));
                frame.pointing = geometry::Pointing{.ha = Angle::fromGon(second / 2.0), .va = Angle::fromGon(100)};
                put(Kind::kTick, at + 30ms, {{QStringLiteral("sequence"), second / 10}, {QStringLiteral("dropped"), 0}});
                put(Kind::kFrame, at + 30ms, pictureMap(frame, 640));
            }
        }
        Message toast;
        toast.happened = QStringLiteral("Point 104 is recorded.");
        put(Kind::kMessage, 600s, {{QStringLiteral("toast"), mapOf(toast)}});
    }
    void open(double speed = 1.0) {
        const QString path = folder.filePath(QStringLiteral("a.pmtsbox"));
        QFile out(path);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(file);
        out.close();
        replay.take(*blackbox::Run::open(path), speed);
    }
    [[nodiscard]] double haShown() const {
        const auto newest = instrument.track().newest();
        return newest ? newest->pointing.ha.gon() : std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] int logRows() {
        core::deliverQueuedEvents();
        return log.rowCount();
    }

    static constexpr core::Duration kZero = 5000s;  ///< the clock of the recorded program
    QByteArray file;
    QStringList toasts;
    LogModel log{QString()};
    Timeline timeline{clock};
    InstrumentHealth health{instrument, preferences, messages, clock};
    ReplayPresenter replay{{.instrument = instrument, .live = live, .log = log, .messages = messages, .timeline = timeline, .range = range,
                            .health = &health},
                           clock};
};

TEST_F(ReplayTest, ItPlaysAsItWasReadingsLineLogAndPictures) {
    record();
    open();
    pass(20500ms);

    EXPECT_TRUE(replay.isPlaying());
    EXPECT_NEAR(std::chrono::duration<double>(replay.position()).count(), 20.5, 0.1);
    EXPECT_EQ(instrument.connectionState(), ConnectionState::kConnected);
    EXPECT_EQ(instrument.identity()->model, QStringLiteral("Geodimeter 600"));
    EXPECT_NEAR(haShown(), 10.5, 1e-6) << "the recording begins with its first second";
    EXPECT_EQ(timeline.rowCount(), 21);
    EXPECT_EQ(logRows(), 21);
    ASSERT_TRUE(live.scene().frame);
    EXPECT_NEAR(live.scene().frame->pointing->ha.gon(), 10.0, 1e-9);
    EXPECT_EQ(timeline.frames().size(), 2U);
}

TEST_F(ReplayTest, TheTimeLineShowsTheTimeOfDayOfTheRecording) {
    record();
    open();
    pass(9s);
    EXPECT_EQ(timeline.utcOf(timeline.events().front().sent).toUTC(),
              QDateTime(QDate(2026, 6, 1), QTime(6, 0, 1), Qt::UTC));
    EXPECT_NEAR(static_cast<double>(replay.utc().toMSecsSinceEpoch()),
                static_cast<double>(QDateTime(QDate(2026, 6, 1), QTime(6, 0, 10), Qt::UTC).toMSecsSinceEpoch()), 100.0);
}

TEST_F(ReplayTest, FourTimesAsFastAndPausedItStandsStill) {
    record();
    open(4.0);
    pass(10s);
    EXPECT_NEAR(std::chrono::duration<double>(replay.position()).count(), 40.0, 0.3);
    replay.pause();
    const core::Duration stands = replay.position();
    pass(10s);
    EXPECT_EQ(replay.position(), stands);
    replay.setSpeed(1.0);
    replay.play();
    pass(5s);
    EXPECT_NEAR(std::chrono::duration<double>(replay.position() - stands).count(), 5.0, 0.1);
}

TEST_F(ReplayTest, AJumpShowsHowThingsStoodThereAndTheMinutesBefore) {
    record();
    open();
    replay.pause();
    replay.seek(550s);

    EXPECT_EQ(instrument.connectionState(), ConnectionState::kConnected) << "said ten minutes ago, and still so";
    EXPECT_NEAR(haShown(), 275.5, 0.6);
    EXPECT_NEAR(timeline.rowCount(), 300, 2) << "five minutes";
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_EQ(messages.bars()[0].happened, QStringLiteral("The instrument is gone."));

    replay.seek(100s);
    EXPECT_NEAR(haShown(), 50.5, 0.6);
    EXPECT_NEAR(timeline.rowCount(), 101, 1);
    EXPECT_TRUE(messages.bars().empty());
    EXPECT_NEAR(logRows(), 101, 1);
}

TEST_F(ReplayTest, AtTheEndItPausesAndPlaysFromTheBeginningAgain) {
    record();
    open(64.0);
    pass(12s);
    EXPECT_FALSE(replay.isPlaying());
    EXPECT_TRUE(replay.isAtEnd());
    EXPECT_THAT(toasts, testing::Contains(QStringLiteral("Point 104 is recorded.")));
    replay.play();
    EXPECT_LT(replay.position(), core::Duration(1s));
}

TEST_F(ReplayTest, ADamagedFileIsPlayedBeyondTheDamage) {
    record();
    for (qsizetype at = file.size() / 4; at < file.size() / 4 + 300; ++at) {
        file[at] = 'x';
    }
    open(64.0);
    pass(12s);
    EXPECT_TRUE(replay.isAtEnd());
    EXPECT_FALSE(replay.damageText().isEmpty());
    EXPECT_NEAR(haShown(), 300.0, 1e-6);
}

QCborMap bytesOf(const char* direction, const QByteArray& bytes) {
    return {{QStringLiteral("port"), QStringLiteral("/dev/ttyUSB0")},
            {QStringLiteral("dir"), QLatin1String(direction)},
            {QStringLiteral("bytes"), bytes}};
}

TEST_F(ReplayTest, WhatNobodyAskedForAndWhatIsMissingAndTheAirAreLinesToo) {
    put(Kind::kSession, 0s, {{QStringLiteral("utc"), QStringLiteral("2026-06-01T06:00:00.000Z")}});
    put(Kind::kAir, 0s, mapOf(InstrumentAir{.temperature_degc = 21.0, .pressure_mbar = 1001.0, .humidity_percent = {}, .ppm = {}}, {}));
    for (int second = 1; second <= 10; ++second) {
        const core::Duration at = 1s * second;
        if (second == 4) {
            put(Kind::kBytes, at - 500ms, bytesOf("<", "7=77.0000\r\n8=99.0000\r\n>"));  // the REG key
            put(Kind::kLost, at - 400ms, {{QStringLiteral("lost"), 12}});
        }
        scheduler::TransactionRecord exchange;
        exchange.sent = "RG,7\r";
        exchange.received = "7=" + std::to_string(second) + ".0\r\n";
        exchange.queued_at = exchange.sent_at = kZero + at;
        exchange.finished_at = kZero + at + 50ms;
        put(Kind::kBytes, at, bytesOf(">", "RG,7\r"));
        put(Kind::kBytes, at + 50ms, bytesOf("<", QByteArray::fromStdString((second == 7 ? "#" : "") + exchange.received + '>')));
        put(Kind::kTransaction, at + 50ms, mapOf(exchange));
    }
    open();
    replay.pause();
    replay.seek(10s);

    std::vector<LineEvent> unasked;
    int air = 0, missing = 0;
    for (const LineEvent& event : timeline.events()) {
        if (event.kind == LineEvent::Kind::kUnasked) {
            unasked.push_back(event);
        }
        air += event.kind == LineEvent::Kind::kAir ? 1 : 0;
        missing += event.kind == LineEvent::Kind::kMissing ? static_cast<int>(event.count) : 0;
    }
    ASSERT_EQ(unasked.size(), 2U) << "answers are in their transactions";
    EXPECT_EQ(unasked[0].record.received, "7=77.0000\r\n8=99.0000\r\n");
    EXPECT_EQ(unasked[0].began, kZero + 3500ms);
    EXPECT_EQ(unasked[1].record.received, "#") << "noise before an answer";
    EXPECT_EQ(missing, 12);
    EXPECT_EQ(air, 1);
    EXPECT_EQ(health.airUsed().text, QStringLiteral("21.0 °C, 1001.0 mbar"));
}

TEST_F(ReplayTest, OnALineWithoutCommandsTheStreamAndWhatCameUnaskedAreThereAtOnce) {
    put(Kind::kSession, 0s, {{QStringLiteral("utc"), QStringLiteral("2026-06-01T06:00:00.000Z")}});
    for (int second = 1; second <= 20; ++second) {
        put(Kind::kBytes, 1s * second, bytesOf("<", "A,166=96.16838\rA,165=177.56115\x04"));
        put(Kind::kReading, 1s * second, mapOf(geometry::Pointing{.ha = Angle::fromGon(second), .va = Angle::fromGon(96)}));
        if (second == 15) {
            put(Kind::kBytes, 15200ms, bytesOf("<", "7=77.0000\r\n>"));
        }
    }
    open();
    replay.pause();
    replay.seek(14500ms);  // from the first second on

    std::vector<double> streamed;
    std::string unasked;
    for (const LineEvent& event : timeline.events()) {
        if (event.kind == LineEvent::Kind::kStream) {
            EXPECT_EQ(event.ended - kZero, 1s * event.pointing->ha.gon()) << "each with its own reading";
            streamed.push_back(event.pointing->ha.gon());
        } else if (event.kind == LineEvent::Kind::kUnasked) {
            unasked += event.record.received;
        }
    }
    ASSERT_EQ(streamed.size(), 15U);
    EXPECT_EQ(streamed.back(), 15.0);
    EXPECT_EQ(unasked, "7=77.0000\r\n");
}

TEST_F(ReplayTest, ADistanceIsShownFromWhereItWasMeasuredAndNotBefore) {
    const geometry::Pointing there{.ha = Angle::fromGon(50), .va = Angle::fromGon(100)};
    put(Kind::kSession, 0s, {{QStringLiteral("utc"), QStringLiteral("2026-06-01T06:00:00.000Z")}});
    put(Kind::kReading, 1s, mapOf(there));
    QCborMap shot = mapOf(there);
    shot[QStringLiteral("sd_m")] = 17.5;
    put(Kind::kReading, 100s, shot);
    for (int second = 101; second <= 590; ++second) {
        put(Kind::kReading, 1s * second, mapOf(geometry::Pointing{.ha = Angle::fromGon(second / 2.0), .va = Angle::fromGon(100)}));
    }
    open();
    replay.pause();
    replay.seek(580s);
    EXPECT_EQ(range.rangeAt(there).source, RangeSource::kMeasured) << "measured eight minutes before";
    EXPECT_EQ(range.rangeAt(there).slope_distance_m, 17.5);
    replay.seek(50s);
    EXPECT_EQ(range.rangeAt(there).source, RangeSource::kAssumed) << "not measured yet";
}

/// Twenty readings a second with their transactions and bytes, as a connected instrument gives them.
TEST_F(ReplayTest, AJumpOverFiveFullMinutesIsShownInPiecesAndIsWhole) {
    constexpr int kPolls = 20 * 320;
    put(Kind::kSession, 0s, {{QStringLiteral("utc"), QStringLiteral("2026-06-01T06:00:00.000Z")}});
    for (int poll = 1; poll <= kPolls; ++poll) {
        const core::Duration at = 50ms * poll;
        scheduler::TransactionRecord exchange;
        exchange.sent = "RG,7\r";
        exchange.received = "7=" + std::to_string(poll) + ".0\r\n";
        exchange.queued_at = exchange.sent_at = kZero + at;
        exchange.finished_at = kZero + at + 40ms;
        put(Kind::kBytes, at, bytesOf(">", "RG,7\r"));
        put(Kind::kBytes, at + 40ms, bytesOf("<", QByteArray::fromStdString(exchange.received + '>')));
        put(Kind::kReading, at + 40ms, mapOf(geometry::Pointing{.ha = Angle::fromGon(poll / 20.0), .va = Angle::fromGon(100)}));
        put(Kind::kTransaction, at + 40ms, mapOf(exchange));
    }
    open();
    replay.pause();
    core::deliverQueuedEvents();
    replay.seek(310s);
    EXPECT_TRUE(test::runUntil([this] { return std::abs(haShown() - 310.0) < 0.2; })) << "HA " << haShown();
    EXPECT_NEAR(timeline.rowCount(), 20 * 300, 3);
    EXPECT_FALSE(replay.isPlaying());
}

/// Two files of one run, the clock set back between them.
TEST_F(ReplayTest, AllFilesOfARunAreOneRecordingInTheOrderTheyWereWritten) {
    const auto put_file = [&](const char* name, core::Duration begin, const char* utc) {
        file.clear();
        put(Kind::kSession, begin, {{QStringLiteral("utc"), QLatin1String(utc)}, {QStringLiteral("run"), QStringLiteral("r")}});
        put(Kind::kConnection, 1s, mapOf(ConnectionState::kConnected, QStringLiteral("It answers."), std::nullopt));
        for (core::Duration at = begin + 1s; at <= begin + 99s; at += 1s) {
            put(Kind::kReading, at, mapOf(geometry::Pointing{.ha = Angle::fromGon(std::chrono::duration<double>(at).count()), .va = Angle::fromGon(100)}));
        }
        QFile out(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(file);
        return out.fileName();
    };
    const QString first = put_file("z.pmtsbox", 0s, "2026-06-01T06:00:00.000Z");
    const QString second = put_file("a.pmtsbox", 100s, "2026-05-01T06:00:00.000Z");
    int connections = 0;
    QObject::connect(&instrument, &InstrumentDesk::connectionChanged, [&](ConnectionState state) { connections += state == ConnectionState::kConnected ? 1 : 0; });
    replay.take(*blackbox::Run::open(second), 1.0);

    EXPECT_NEAR(std::chrono::duration<double>(replay.length()).count(), 199.0, 1.1);
    EXPECT_NEAR(std::chrono::duration<double>(replay.position()).count(), 100.0, 1.1) << "from the file that was chosen";
    EXPECT_EQ(replay.utc().date(), QDate(2026, 5, 1));
    EXPECT_EQ(connections, 1) << "said again at the beginning of the second file";
    replay.pause();
    replay.seek(50s);
    EXPECT_EQ(replay.utc().date(), QDate(2026, 6, 1));
    EXPECT_NEAR(haShown(), 51.0, 1.1);
    EXPECT_TRUE(QFile::exists(first));
}

TEST_F(ReplayTest, NothingReachesAnInstrument) {
    record();
    open();
    pass(20s);
    std::optional<core::Error> refused;
    QObject::connect(&instrument, &InstrumentDesk::requestFailed, [&](Ticket, const core::Error& error) { refused = error; });
    instrument.turnTo({.ha = Angle::fromGon(10), .va = Angle::fromGon(100)}, Angle::fromCc(5));
    pass(5s);
    EXPECT_TRUE(sent.empty());
    EXPECT_TRUE(refused.has_value());

    const auto link = ReplayPresenter::barredLink();
    const auto opened = link->open();
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().kind, core::ErrorKind::kRefused);
    link->write("RG\r");
    EXPECT_FALSE(link->isOpen());
}

TEST(BlackBoxRecordsTest, ASilenceThatIsUsualIsOneAfterwardsToo) {
    scheduler::TransactionRecord record;
    record.sent = "PV,21\r";
    record.outcome = scheduler::Outcome::kTimedOut;
    record.may_stay_silent = true;

    const auto back = transactionFrom(mapOf(record));
    EXPECT_TRUE(back.may_stay_silent);
    EXPECT_EQ(back.outcome, scheduler::Outcome::kTimedOut);
    EXPECT_EQ(back.sent, record.sent);
    record.may_stay_silent = false;
    EXPECT_FALSE(transactionFrom(mapOf(record)).may_stay_silent);
}

}  // namespace
}  // namespace pmts::app
