#include "pmts/app/line/timeline.hpp"

#include "pmts/core/virtual_clock.hpp"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using namespace std::chrono_literals;
using scheduler::Outcome;
using scheduler::TransactionRecord;

class TimelineTest : public testing::Test {
protected:
    TimelineTest() { timeline.setUnits(protocol::WireUnits()); }

    /// Queued at `at`, sent 5 ms later.
    static TransactionRecord exchange(core::Duration at, std::string sent, std::string received, core::Duration on_wire = 50ms) {
        TransactionRecord record;
        record.sent = std::move(sent);
        record.received = std::move(received);
        record.queued_at = at;
        record.sent_at = at + 5ms;
        record.finished_at = at + 5ms + on_wire;
        return record;
    }
    QString cell(int row, Timeline::Column column) const { return timeline.index(row, column).data().toString(); }

    core::VirtualClock clock;
    Timeline timeline{clock};
};

TEST_F(TimelineTest, ATransactionIsSaidInPlainLanguageWithItsWaitAndItsTimeOnTheWire) {
    timeline.addTransaction(exchange(1s, "RG,7\r", "7=10.2345\r\n", 52ms));

    EXPECT_EQ(cell(0, Timeline::kWho), QStringLiteral("PMTS"));
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("read HA"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("HA 10.2345 gon"));
    EXPECT_EQ(cell(0, Timeline::kWaited), QStringLiteral("5.0 ms"));
    EXPECT_EQ(cell(0, Timeline::kOnWire), QStringLiteral("52 ms"));
    EXPECT_EQ(cell(0, Timeline::kOutcome), QStringLiteral("Answered."));
    EXPECT_TRUE(timeline.words().details(timeline.events()[0]).contains(QStringLiteral("Sent: RG,7<CR>")));
}

TEST_F(TimelineTest, ThePanelsAnswerIsReadWithoutItsBlockEnd) {
    auto record = exchange(1s, "RG,8\r", "8=96.1684\r\n>");
    record.master = scheduler::Master::kPanel;
    timeline.addTransaction(record);

    EXPECT_EQ(cell(0, Timeline::kWho), QStringLiteral("Panel"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("VA 96.1684 gon"));
    EXPECT_EQ(timeline.events()[0].health, LineHealth::kGood);
}

TEST_F(TimelineTest, NoAnswerAndARefusalAreFailures) {
    auto lost = exchange(1s, "RG,7\r", "", 3s);
    lost.outcome = Outcome::kTimedOut;
    timeline.addTransaction(lost);
    timeline.addTransaction(exchange(5s, "WS=PH05V05\r", "156\r\n", 4s));

    EXPECT_EQ(timeline.events()[0].health, LineHealth::kFailed);
    EXPECT_EQ(cell(0, Timeline::kOutcome), QStringLiteral("No answer within 3.0 s."));
    EXPECT_EQ(timeline.events()[1].health, LineHealth::kFailed);
    EXPECT_EQ(cell(1, Timeline::kOutcome), QStringLiteral("The instrument refused: info 156."));
}

TEST_F(TimelineTest, ABatteryWarningIsNoFailure) {
    timeline.addTransaction(exchange(1s, "RG\r", "8\r\n7=1.0\r\n8=2.0\r\n"));
    EXPECT_EQ(timeline.events()[0].health, LineHealth::kGood);
}

TEST_F(TimelineTest, ACodeThatReportsSuccessOrDataIsNoRefusal) {
    timeline.addTransaction(exchange(1s, "PV,8=9\r", "240.8\r"));
    timeline.addTransaction(exchange(2s, "WS=PH05V05\r", "150\r\n"));
    timeline.addTransaction(exchange(3s, "RGT\r", "301\r\n"));
    timeline.addTransaction(exchange(4s, "RGT\r", "300\r\n"));
    timeline.addTransaction(exchange(5s, "PV,8=9\r", "248.8\r"));  // the process failed

    for (int row = 0; row < 4; ++row) {
        EXPECT_EQ(timeline.events()[static_cast<std::size_t>(row)].health, LineHealth::kGood) << row;
        EXPECT_EQ(cell(row, Timeline::kOutcome), QStringLiteral("Answered.")) << row;
    }
    EXPECT_EQ(timeline.events()[4].health, LineHealth::kFailed);
    EXPECT_EQ(cell(4, Timeline::kOutcome), QStringLiteral("The instrument refused: info 248."));
}

TEST_F(TimelineTest, AReadingThatTakesMuchLongerThanItsKindIsSlow) {
    for (int i = 0; i < 20; ++i) {
        timeline.addTransaction(exchange(1s * i, "RG,7\r", "7=1.0\r\n", 50ms));
    }
    timeline.addTransaction(exchange(30s, "RG,7\r", "7=1.0\r\n", 900ms));
    timeline.addTransaction(exchange(32s, "WS=PH05V05\r", "0\r\n", 20s));  // a long way is not slow

    EXPECT_EQ(timeline.events()[19].health, LineHealth::kGood);
    EXPECT_EQ(timeline.events()[20].health, LineHealth::kSlow);
    EXPECT_EQ(timeline.words().outcome(timeline.events()[20]), QStringLiteral("Answered, but slowly: usually 50 ms."));
    EXPECT_EQ(timeline.events()[21].health, LineHealth::kGood);
}

TEST_F(TimelineTest, FramesDroppedByTheGateAreToldFromMissingOnes) {
    timeline.addFrame(1000ms, 10, 0);
    timeline.addFrame(1033ms, 11, 0);
    timeline.addFrame(1133ms, 14, 2);
    timeline.addFrame(2000ms, 40, 2);

    ASSERT_EQ(timeline.frames().size(), 4U);
    EXPECT_EQ(timeline.frames()[1].dropped + timeline.frames()[1].missing, 0);
    EXPECT_EQ(timeline.frames()[2].dropped, 2);
    EXPECT_EQ(timeline.frames()[2].missing, 0);
    EXPECT_EQ(timeline.frames()[3].missing, 25);
    ASSERT_EQ(timeline.rowCount(), 1) << "a gap of most of a second is worth a line";
    EXPECT_EQ(cell(0, Timeline::kWho), QStringLiteral("Camera"));
}

TEST_F(TimelineTest, ControlIsKeptWhereItChangesAndAChangeOfModeIsALine) {
    instrument::ControlStatus status;
    timeline.addControl(status);
    status.owner = scheduler::LineOwner::kComputer;
    status.owner_since = 1s;
    timeline.addControl(status);
    timeline.addControl(status);  // a counter moved
    status.mode = scheduler::ControlMode::kPanel;
    status.owner = scheduler::LineOwner::kPanel;
    status.owner_since = 2s;
    timeline.addControl(status);

    ASSERT_EQ(timeline.owners().size(), 3U);
    EXPECT_EQ(timeline.owners()[2].from, core::Duration(2s));
    ASSERT_EQ(timeline.rowCount(), 1);
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("The panel has control."));
}

TEST_F(TimelineTest, OnlyWhatCanReachIntoASpanIsLookedAt) {
    for (int i = 0; i < 1000; ++i) {
        timeline.addTransaction(exchange(100ms * i, "RG,7\r", "7=1.0\r\n"));
    }
    const auto [first, last] = timeline.eventsIn(50s, 51s);

    EXPECT_LE(first, 500U);
    EXPECT_GE(last, 510U);
    EXPECT_LE(last - first, 14U);
}

TEST_F(TimelineTest, ALongTurnReachesIntoTheSpanInItsMiddle) {
    timeline.addTransaction(exchange(1s, "WS=PH05V05\r", "0\r\n", 30s));
    const auto [first, last] = timeline.eventsIn(10s, 11s);
    EXPECT_EQ(first, 0U);
    EXPECT_EQ(last, 1U);
}

TEST_F(TimelineTest, TheOldestIsForgotten) {
    QSignalSpy removed(&timeline, &QAbstractItemModel::rowsRemoved);
    for (std::size_t i = 0; i < Timeline::kCapacity + 100; ++i) {
        timeline.addTransaction(exchange(10ms * static_cast<int>(i), "RG,7\r", "7=1.0\r\n"));
        timeline.addFrame(core::Duration(33ms) * static_cast<int>(i + 1), i + 1, 0);
    }
    EXPECT_LE(timeline.events().size(), Timeline::kCapacity);
    EXPECT_LE(timeline.frames().size(), Timeline::kCapacity);
    EXPECT_EQ(removed.count(), 1);
    EXPECT_EQ(timeline.events().back().began, core::Duration(10ms) * static_cast<int>(Timeline::kCapacity + 99));
}

TEST_F(TimelineTest, ABlockThatNobodyAskedForIsAnEventInWords) {
    timeline.addUnasked({.bytes = "7=10.2345\r\n8=96.1684\r\n9=15.000\r\n", .at = 2s});
    timeline.addUnasked({.bytes = "7=10.2345\r\n8=96.1684\r\n9=15.000\r\n", .at = 2500ms});
    timeline.addUnasked({.bytes = "7=11.0\r\n", .at = 2600ms});

    ASSERT_EQ(timeline.rowCount(), 2);
    EXPECT_EQ(cell(0, Timeline::kWho), QStringLiteral("Instrument"));
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("came unasked, 2 times"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("HA 10.2345 gon, VA 96.1684 gon, SD 15.000 m"));
    EXPECT_TRUE(cell(0, Timeline::kOutcome).isEmpty());
    EXPECT_TRUE(timeline.words().details(timeline.events()[1]).contains(QStringLiteral("Received: 7=11.0<CR><LF>")));
}

TEST_F(TimelineTest, WhatAnswersNobodyIsNamedAndMarked) {
    using scheduler::StrayKind;
    timeline.addUnasked({.kind = StrayKind::kLate, .bytes = "7=10.2345\r\n", .at = 1s});
    timeline.addUnasked({.kind = StrayKind::kDoubled, .bytes = "7=10.2345\r\n", .at = 1100ms});
    timeline.addUnasked({.kind = StrayKind::kNoise, .bytes = "\x15~", .at = 1200ms});
    timeline.addUnasked({.kind = StrayKind::kNoise, .bytes = {}, .at = 1300ms});

    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("an answer that came too late"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("HA 10.2345 gon"));
    EXPECT_EQ(cell(1, Timeline::kWhat), QStringLiteral("the same answer once more"));
    EXPECT_EQ(cell(2, Timeline::kWhat), QStringLiteral("noise"));
    EXPECT_EQ(cell(2, Timeline::kAnswer), QStringLiteral("<15>~"));
    EXPECT_EQ(cell(3, Timeline::kAnswer), QStringLiteral("a block end alone"));
    for (const LineEvent& event : timeline.events()) {
        EXPECT_EQ(event.health, LineHealth::kSlow);
    }
}

TEST_F(TimelineTest, AStepThatMayStaySilentIsNoFailure) {
    auto silent = exchange(1s, "PV,21\r", "", 2s);
    silent.outcome = Outcome::kTimedOut;
    silent.may_stay_silent = true;
    timeline.addTransaction(silent);

    EXPECT_EQ(timeline.events()[0].health, LineHealth::kNote);
    EXPECT_EQ(cell(0, Timeline::kOutcome), QStringLiteral("No answer within 2.0 s, as it may be."));
}

TEST_F(TimelineTest, TheAngleStreamIsOneLineASecondWithItsLastReading) {
    const auto pointing = [](double ha) {
        return geometry::Pointing{.ha = core::Angle::fromGon(ha), .va = core::Angle::fromGon(96.16838)};
    };
    for (int i = 0; i < 600; ++i) {  // an hour of it would be 3600 lines, not 12 000
        timeline.addStreamReading(pointing(100.0 + i), core::Duration(300ms) * i);
    }
    EXPECT_EQ(timeline.rowCount(), 150);
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("angle stream, readings: 4"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("HA 103.00000 gon, VA 96.16838 gon"));
    EXPECT_EQ(timeline.events()[0].ended, core::Duration(900ms));
}

TEST_F(TimelineTest, WhatGrowsOrCameLateIsStillFoundInItsSpan) {
    timeline.addStreamReading({.ha = core::Angle::fromGon(1), .va = core::Angle::fromGon(2)}, 10s);
    timeline.addTransaction(exchange(10100ms, "RG,7\r", "7=1.0\r\n"));
    timeline.addStreamReading({.ha = core::Angle::fromGon(1), .va = core::Angle::fromGon(2)}, 10900ms);
    timeline.addTransaction(exchange(9s, "RG,8\r", "8=1.0\r\n"));  // its report waited

    for (const auto& [from, to] : {std::pair{10500ms, 10600ms}, std::pair{10120ms, 10130ms}, std::pair{9010ms, 9020ms}}) {
        const auto [first, last] = timeline.eventsIn(from, to);
        bool is_there = false;
        for (std::size_t i = first; i < last; ++i) {
            is_there = is_there || (timeline.events()[i].began <= to && timeline.events()[i].ended >= from);
        }
        EXPECT_TRUE(is_there) << from.count() << " ms";
    }
}

TEST_F(TimelineTest, MissingRecordsAndTheAirAreEvents) {
    timeline.addMissing(12, 3s, 4s);
    timeline.addAir(18.5, std::nullopt, 5s);
    timeline.addAir(18.5, std::nullopt, 6s);
    timeline.addAir(19.0, 1013.2, 7s);

    ASSERT_EQ(timeline.rowCount(), 3);
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("Missing here: 12 records of the black box."));
    EXPECT_EQ(timeline.events()[0].health, LineHealth::kSlow);
    EXPECT_EQ(cell(1, Timeline::kWhat), QStringLiteral("Air: 18.5 °C."));
    EXPECT_EQ(cell(2, Timeline::kWhat), QStringLiteral("Air: 19.0 °C, 1013.2 mbar."));
}

TEST_F(TimelineTest, TheUsersNamesAreUsedAsSoonAsTheyAreGiven) {
    timeline.addTransaction(exchange(1s, "WV,102=0\r", "0.8\r"));
    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("write label 102 of the main board = 0"));
    EXPECT_EQ(cell(0, Timeline::kAnswer), QStringLiteral("done"));

    QSignalSpy changed(&timeline, &QAbstractItemModel::dataChanged);
    timeline.setNames({{QStringLiteral("V,102"), QStringLiteral("stream on")}});
    timeline.setNames({{QStringLiteral("V,102"), QStringLiteral("stream on")}});

    EXPECT_EQ(cell(0, Timeline::kWhat), QStringLiteral("write stream on = 0"));
    EXPECT_EQ(changed.count(), 1);
}

TEST_F(TimelineTest, SpansReadAsPeopleSayThem) {
    EXPECT_EQ(spanText(0ns), QStringLiteral("0"));
    EXPECT_EQ(spanText(8us), QStringLiteral("0")) << "a queue between threads, nothing to tell";
    EXPECT_EQ(spanText(300us), QStringLiteral("0.3 ms"));
    EXPECT_EQ(spanText(52ms), QStringLiteral("52 ms"));
    EXPECT_EQ(spanText(3200ms), QStringLiteral("3.2 s"));
    EXPECT_EQ(spanText(180s), QStringLiteral("3.0 min"));
}

TEST_F(TimelineTest, AClockThatIsSetMovesNothingThatWas) {
    const QDateTime at_1s = timeline.utcOf(1s);
    for (int second = 1; second <= 3; ++second) {
        timeline.addTransaction(exchange(1s * second, "RG,7\r", "7=10.2345\r\n", 50ms));
        clock.setTimeOfDayBy(std::chrono::hours(second == 1 ? -30 * 24 : 60 * 24));
    }
    EXPECT_EQ(timeline.utcOf(1s), at_1s);
    EXPECT_EQ(timeline.utcOf(timeline.events().back().began), at_1s.addSecs(2));
    EXPECT_EQ(timeline.eventsIn(0s, 10s), (std::pair<std::size_t, std::size_t>(0, 3)));
}

}  // namespace
}  // namespace pmts::app
