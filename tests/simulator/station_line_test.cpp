#include "station_fixture.hpp"

#include <random>

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;

class StationLineTest : public StationTest {
protected:
    /// Clock time from a command's first byte until the block end was said.
    core::Duration timeOf(std::string_view command) {
        const auto start = clock.now();
        std::string said = ask(command);
        while (!said.ends_with('>') && clock.now() - start < 1min) {
            clock.advance(100us);
            said += heard();
        }
        return clock.now() - start;
    }
};

constexpr double kByte_s = 10.0 / 9600.0;

TEST_F(StationLineTest, BytesTakeTheirTimeBothWays) {
    settings.baud = 9600.0;
    // `RG,7` CR, then `7=0.0000` CR LF `>`: 5 + 11 bytes of ten bits.
    EXPECT_NEAR(std::chrono::duration<double>(timeOf("RG,7")).count(), 16 * kByte_s, 2e-4);
}

TEST_F(StationLineTest, TimeScaleMakesTheWireFaster) {
    settings.baud = 9600.0;
    settings.time_scale = 4.0;
    EXPECT_NEAR(std::chrono::duration<double>(timeOf("RG,7")).count(), 4 * kByte_s, 2e-4);
}

TEST_F(StationLineTest, LineParametersChangeThePace) {
    settings.baud = 9600.0;
    timeOf("WG,78=1.8.0.1200");
    EXPECT_NEAR(std::chrono::duration<double>(timeOf("RG,7")).count(), 16 * 10.0 / 1200.0, 2e-4);
}

TEST_F(StationLineTest, CommandExistsWhenItsLastByteHasArrived) {
    settings.baud = 9600.0;
    ask("WG,27=100.0000", 1s);
    ask("WS=PH02", 8ms);  // 8 bytes: 8.3 ms
    EXPECT_EQ(pointing->motions().ha.end_gon, 0.0);
    clock.advance(1ms);
    EXPECT_NEAR(pointing->motions().ha.end_gon, 100.0, 2e-4);
}

TEST_F(StationLineTest, LineFeedAfterTheReturnIsIgnored) {
    station().receive("WG,5=7\r\nRG,5\r\n\r\n");
    EXPECT_EQ(heard(), ">5=7\r\n>");
}

TEST_F(StationLineTest, AnyChunkingIsTheSameCommand) {
    for (const char byte : std::string("RG,7\r\n")) {
        station().receive(std::string_view(&byte, 1));
    }
    EXPECT_EQ(heard(), "7=0.0000\r\n>");
}

TEST_F(StationLineTest, TooLongACommandIsInfo218) {
    EXPECT_EQ(ask("WG,5=" + std::string(75, '1')), "35\r\n>");  // 80 characters are still read
    EXPECT_EQ(ask("WG,5=" + std::string(76, '1')), "218\r\n>");
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
}

TEST_F(StationLineTest, CommandWithoutEndIsInfo217) {
    station().receive("RG,7");
    clock.advance(9999ms);
    EXPECT_EQ(heard(), "");
    clock.advance(1ms);
    EXPECT_EQ(heard(), "217\r\n>");
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
}

TEST_F(StationLineTest, CommandWithoutEndMayStayUnanswered) {
    settings.unterminated_status = 0;
    station().receive("RG,7");
    clock.advance(1min);
    EXPECT_EQ(heard(), "");
    EXPECT_EQ(ask("RG,8"), "8=100.0000\r\n>");
}

TEST_F(StationLineTest, TenCommandsWaitForTheEndOfTheCurrentOne) {
    ask("WG,27=100.0000");
    ask("WS=PH02");
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(ask("RG,5"), "");
    }
    EXPECT_EQ(ask("RG,5"), "207\r\n>");
    clock.advance(10s);
    std::string expected = ">";
    for (int i = 0; i < 10; ++i) {
        expected += "5=\r\n>";
    }
    EXPECT_EQ(heard(), expected);
}

TEST_F(StationLineTest, AnswersNeverMixOnTheWire) {
    settings.baud = 9600.0;
    station().receive("RG,7\rRG,8\r");
    clock.advance(1s);
    EXPECT_EQ(heard(), "7=0.0000\r\n>8=100.0000\r\n>");
}

TEST_F(StationLineTest, ThinkingTimeIsAddedToEveryAnswer) {
    settings.turn_around = 30ms;
    EXPECT_EQ(ask("RG,7", 29ms), "");
    clock.advance(1ms);
    EXPECT_EQ(heard(), "7=0.0000\r\n>");
}

TEST_F(StationLineTest, RandomBytesNeverSilenceIt) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> byte(0, 255);
    for (int i = 0; i < 20000; ++i) {
        const char noise = static_cast<char>(byte(random));
        station().receive(std::string_view(&noise, 1));
        clock.advance(1ms);
    }
    station().receive("\r");
    clock.advance(11s);
    heard();
    EXPECT_EQ(ask("RG,7"), "7=0.0000\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
