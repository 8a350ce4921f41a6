#include "pmts/instrument/pointing_poller.hpp"

#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

class PollerTest : public DriverTest {
protected:
    void SetUp() override {
        connect();
        driver.on_pointing = [this](const geometry::Pointing& now, core::Duration) { seen.push_back(now); };
    }
    PointingPoller poller{driver, clock};
    std::vector<geometry::Pointing> seen;
};

TEST_F(PollerTest, KeepsThePointingFreshTenTimesASecond) {
    poller.start();
    clock.advance(2s);

    EXPECT_GE(seen.size(), 19U);
    EXPECT_LE(seen.size(), 21U);
}

TEST_F(PollerTest, ShowsAHandTurningTheInstrument) {
    poller.start();
    for (int i = 0; i < 20; ++i) {
        station.ha += 1.0;
        clock.advance(100ms);
    }
    EXPECT_THAT(seen.back().ha, test::IsNearAngle(Angle::fromGon(30), Angle::fromGon(1.1)));
}

TEST_F(PollerTest, AReadingThatLostADigitIsNotShown) {
    station.ha = 177.5612;
    station.next["RG,7"] = {};
    poller.start();
    clock.advance(1s);
    station.next["RG,7"] = {"7=17.5612\r\n>"};
    clock.advance(1s);

    for (const auto& pointing : std::vector(seen.begin() + 3, seen.end())) {
        EXPECT_THAT(pointing.ha, test::IsNearAngle(Angle::fromGon(177.5612), Angle::fromCc(1)));
    }
}

TEST_F(PollerTest, KeepsStillWhileARoutineRuns) {
    poller.start();
    clock.advance(1s);
    link.written.clear();
    (void)run(driver.turnTo(pointing(177.5612, 96.1684), Angle::fromCc(5), {}));

    const auto ws = std::find(link.written.begin(), link.written.end(), "WS=PH05V05\r");
    ASSERT_NE(ws, link.written.end());
    EXPECT_EQ(std::count(link.written.begin(), ws, "RG,7\r"), 0);
}

TEST_F(PollerTest, ACommandWaitsForNoMoreThanOneShortRead) {
    poller.start();
    clock.advance(10ms);  // RG,7 is on the wire
    auto outcome = std::make_shared<std::optional<core::Result<geometry::Pointing>>>();
    auto turning =
        test::detail::keepOutcome(driver.turnHorizontal(Angle::fromGon(50), Angle::fromCc(5), {}), outcome);
    clock.advance(20ms);

    EXPECT_EQ(sent("WG,27=50.0000"), 1);
}

TEST_F(PollerTest, BacksOffAndReportsSilenceOnce) {
    int silences = 0;
    poller.on_silence = [&](const core::Error&) { ++silences; };
    poller.start();
    clock.advance(1s);
    station.silent = true;
    link.written.clear();
    clock.advance(60s);

    EXPECT_EQ(silences, 1);
    EXPECT_LT(link.written.size(), 65U);  // one question a second
    station.silent = false;
    seen.clear();
    clock.advance(5s);
    EXPECT_GT(seen.size(), 20U);
}

TEST_F(PollerTest, StopsAtOnce) {
    poller.start();
    clock.advance(1s);
    poller.stop();
    link.written.clear();
    clock.advance(5s);

    EXPECT_LE(link.written.size(), 1U);
    EXPECT_FALSE(poller.isRunning());
}

}  // namespace
}  // namespace pmts::instrument
