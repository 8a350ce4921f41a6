#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;

class StationFilesTest : public StationTest {
protected:
    /// Sends a file as the manual says: wait for `*`, lines, end mark.
    std::string load(std::string_view command, std::string_view contents) {
        if (const std::string prompt = ask(command); prompt != "*") {
            return prompt;
        }
        station().receive(std::string(contents) + '>');
        return heard();
    }
};

TEST_F(StationFilesTest, JobZeroAndAreaZeroAlwaysExist) {
    EXPECT_EQ(ask("OMC"), "50=0\r\n>");
    EXPECT_EQ(ask("OIC"), "15=0\r\n>");
    EXPECT_EQ(ask("OUC"), ">");
    EXPECT_EQ(ask("O*C"), "15=0\r\n50=0\r\n>");
}

TEST_F(StationFilesTest, LoadedFileComesBackLineByLine) {
    EXPECT_EQ(load("LM=DEMO1", "2=100\r\n23=2111\r\n37=1000.000\r\n"), ">");
    EXPECT_EQ(ask("OM=DEMO1"), "2=100\r\n23=2111\r\n37=1000.000\r\n>");
    EXPECT_EQ(ask("OMC"), "50=0\r\n50=DEMO1\r\n>");
}

TEST_F(StationFilesTest, BareReturnsEndLinesToo) {
    EXPECT_EQ(load("LI=REF", "5=100\r4=WALL\r"), ">");
    EXPECT_EQ(ask("OI=REF"), "5=100\r\n4=WALL\r\n>");
    EXPECT_EQ(ask("OI3=REF"), "5=100\r\n4=WALL\r\n>");  // through protocol 3
}

TEST_F(StationFilesTest, PromptIsOneBareByte) {
    EXPECT_EQ(ask("LM=JOB1"), "*");
    EXPECT_EQ(ask("RG", 1s), "");  // a line of the file now
}

TEST_F(StationFilesTest, MissingFileIsInfo32) {
    EXPECT_EQ(ask("OM=NONE"), "32\r\n>");
    EXPECT_EQ(ask("KM=NONE"), "32\r\n>");
    load("LM=Case", "5=1\r");
    EXPECT_EQ(ask("OM=CASE"), "32\r\n>");
}

TEST_F(StationFilesTest, ExistingFileIsNotOverwritten) {
    load("LM=JOB1", "5=1\r");
    EXPECT_EQ(ask("LM=JOB1"), "33\r\n>");
    EXPECT_EQ(ask("LM=0"), "33\r\n>");
}

TEST_F(StationFilesTest, BadLinesAreRefusedWhole) {
    EXPECT_EQ(load("LM=A", "5=1\rno separator\r"), "34\r\n>");
    EXPECT_EQ(load("LM=A", "5=\r"), "35\r\n>");
    EXPECT_EQ(load("LM=A", "5x=1\r"), "35\r\n>");
    EXPECT_EQ(ask("OM=A"), "32\r\n>");
}

TEST_F(StationFilesTest, NameHasAtMostFifteenCharacters) {
    EXPECT_EQ(ask("LM=SIXTEENLETTERS16"), "35\r\n>");
    EXPECT_EQ(ask("LM="), "35\r\n>");
}

TEST_F(StationFilesTest, FileThatNeverEndsTimesOut) {
    ask("LM=JOB1");
    station().receive("5=1\r");
    clock.advance(9s);
    EXPECT_EQ(heard(), "");
    clock.advance(1s);
    EXPECT_EQ(heard(), "23\r\n>");
    EXPECT_EQ(ask("OM=JOB1"), "32\r\n>");
}

TEST_F(StationFilesTest, FreeMemoryShrinksAndComesBack) {
    EXPECT_EQ(ask("M"), "60000\r\n>");
    load("LM=JOB1", "5=1234\r");
    EXPECT_EQ(ask("MG"), "59993\r\n>");
    EXPECT_EQ(ask("MR"), "60000\r\n>");
    EXPECT_EQ(ask("KM=JOB1"), ">");
    EXPECT_EQ(ask("M"), "60000\r\n>");
}

TEST_F(StationFilesTest, FullMemoryIsInfo36) {
    settings.memory_bytes = 12;
    EXPECT_EQ(load("LM=A", "5=1\r5=2\r"), ">");
    EXPECT_EQ(load("LM=B", "5=1\r5=2\r"), "36\r\n>");
}

TEST_F(StationFilesTest, EraseAllLeavesTheEmptyJobAndArea) {
    load("LM=A", "5=1\r");
    load("LI=B", "5=1\r");
    EXPECT_EQ(ask("K*"), ">");
    EXPECT_EQ(ask("O*C"), "15=0\r\n50=0\r\n>");
}

TEST_F(StationFilesTest, RegisteredPointIsInTheCurrentJob) {
    ask("WG,50=WORK");
    ask("WG,5=12");
    ask("TG", 5s);
    station().pressRegKey();
    heard();
    EXPECT_EQ(ask("OM=WORK"), "5=12\r\n7=0.0000\r\n8=100.0000\r\n9=20.000\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
