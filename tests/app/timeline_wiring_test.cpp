#include "pmts/app/desk/bus_simulation_desk.hpp"
#include "pmts/app/line/timeline.hpp"
#include "pmts/app/desk/workbench.hpp"
#include "support/run_until.hpp"

#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using namespace std::chrono_literals;
using Kind = LineEvent::Kind;

/// The whole program without its window and with no device but what a test connects.
class TimelineWiringTest : public testing::Test {
protected:
    static StartOptions optionsIn(const QTemporaryDir& folder) {
        StartOptions options;
        options.data_folder = folder.path();
        return options;
    }
    [[nodiscard]] std::vector<LineEvent> events(Kind kind) const {
        std::vector<LineEvent> found;
        for (const LineEvent& event : bench.timeline->events()) {
            if (event.kind == kind) {
                found.push_back(event);
            }
        }
        return found;
    }

    QTemporaryDir folder;
    Workbench bench{optionsIn(folder)};
};

TEST_F(TimelineWiringTest, ABlockOfTheRegKeyIsOnTheTimeLine) {
    Q_EMIT bench.instrument.strayCame({.bytes = "7=10.2345\r\n8=96.1684\r\n", .at = 1s});

    ASSERT_EQ(events(Kind::kUnasked).size(), 1U);
    EXPECT_EQ(events(Kind::kUnasked)[0].record.received, "7=10.2345\r\n8=96.1684\r\n");
}

TEST_F(TimelineWiringTest, APolledReadingIsNoStream) {
    Q_EMIT bench.instrument.pointingChanged({.pointing = {.ha = core::Angle::fromGon(1), .va = core::Angle::fromGon(2)}, .at = 1s});
    EXPECT_TRUE(events(Kind::kStream).empty()) << "it is in the transactions";
}

TEST_F(TimelineWiringTest, TheTemperatureThatIsToldIsOnTheTimeLine) {
    bench.profiles.setTemperature(18.5);
    ASSERT_EQ(events(Kind::kAir).size(), 1U);
    EXPECT_EQ(events(Kind::kAir)[0].text, QStringLiteral("Air: 18.5 °C."));
}

TEST_F(TimelineWiringTest, ANameGivenOnTheBenchForUnknownLinesIsUsed) {
    scheduler::TransactionRecord record;
    record.sent = "WV,102=0\r";
    record.received = "0.8\r";
    Q_EMIT bench.instrument.transactionFinished(record);
    bench.line_bench.nameVariable(QStringLiteral("V,102"), QStringLiteral("stream on"));

    EXPECT_EQ(bench.timeline->index(0, Timeline::kWhat).data().toString(), QStringLiteral("write stream on = 0"));
}

class TimelineOfTheBusTest : public TimelineWiringTest {};

TEST_F(TimelineOfTheBusTest, TheStreamFillsItWithoutARoutineALineASecond) {
    BusSimulationDesk bus;
    QObject::connect(&bus, &BusSimulationDesk::started, &bench.instrument, [this](const QString& path) {
        SerialChoice choice;
        choice.path = path;
        choice.dialect = instrument::LineDialect::kBus;
        bench.instrument.connectSerial(choice);
    });
    bus.start();

    ASSERT_TRUE(test::runUntil([this] { return events(Kind::kStream).size() == 3; }));
    EXPECT_TRUE(events(Kind::kTransaction).empty());
    const auto whole = events(Kind::kStream)[1];
    EXPECT_GE(whole.count, 2U) << "about three readings in a second";
    EXPECT_GE(events(Kind::kStream)[2].began - whole.began, core::Duration(1s));
    EXPECT_TRUE(bench.timeline->words().answer(whole).startsWith(QStringLiteral("HA ")));
}

}  // namespace
}  // namespace pmts::app
