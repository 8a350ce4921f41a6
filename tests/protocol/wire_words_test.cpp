#include "pmts/protocol/wire_words.hpp"

#include <gtest/gtest.h>

namespace pmts::protocol {
namespace {

const WireUnits kUsual;  // gon, metre, Celsius, millibar

QString answer(std::string_view command, std::string_view block) {
    return replyInWords(command, parseReply(block, shapeOfAnswerTo(command)), kUsual);
}

TEST(WireWordsTest, CommandsAreSaidWithTheNamesOfTheLabels) {
    EXPECT_EQ(commandInWords("RG,7\r"), QStringLiteral("read HA"));
    EXPECT_EQ(commandInWords("RGD,56\r"), QStringLiteral("read Temp"));
    EXPECT_EQ(commandInWords("RG\r"), QStringLiteral("read the measurement"));
    EXPECT_EQ(commandInWords("WG,26=96.1684\r", kUsual), QStringLiteral("write SVA = 96.1684 gon"));
    EXPECT_EQ(commandInWords("WS=PH05V10\r"), QStringLiteral("turn to the target (HA to 5 cc, VA to 10 cc)"));
    EXPECT_EQ(commandInWords("TG\r"), QStringLiteral("measure the distance"));
    EXPECT_EQ(commandInWords("PG,3=1\r"), QStringLiteral("measuring mode TRK"));
}

TEST(WireWordsTest, EveryCommandOfTheDialectHasWords) {
    const Command commands[] = {ReadMeasurement{}, ReadLabel{.label = 8}, SignalTest{}, WriteLabel{.label = 5, .data = "12"},
                                Trigger{}, Position{.ha_tolerance_cc = 2, .va_tolerance_cc = {}}, SetMode{}, ListFiles{},
                                OutputFile{.directory = Directory::kJob, .name = "A", .via_protocol = {}},
                                LoadFile{.directory = Directory::kJob, .name = "A", .via_protocol = {}}, FreeMemory{}, EraseFile{.name = "A"},
                                CalibrateCompensator{}, SwitchOff{}};
    for (const Command& command : commands) {
        EXPECT_TRUE(commandInWords(encode(command)).has_value()) << encode(command);
    }
}

TEST(WireWordsTest, BytesOfAnotherDialectHaveNoWords) {
    EXPECT_EQ(commandInWords("A,166=12"), std::nullopt);
    EXPECT_EQ(commandInWords("RGX,7"), std::nullopt);
    EXPECT_EQ(commandInWords(""), std::nullopt);
}

TEST(WireWordsTest, AnswersCarryNameAndUnit) {
    EXPECT_EQ(answer("RG,7\r", "7=10.2345\r\n"), QStringLiteral("HA 10.2345 gon"));
    EXPECT_EQ(answer("RGD,7\r", "10.2345\r\n"), QStringLiteral("HA 10.2345 gon"));
    EXPECT_EQ(answer("RG\r", "0\r\n7=177.5612\r\n8=96.1684\r\n9=15.000\r\n"),
              QStringLiteral("HA 177.5612 gon, VA 96.1684 gon, SD 15.000 m"));
    EXPECT_EQ(answer("WG,26=96.1684\r", "0\r\n"), QStringLiteral("done"));
}

TEST(WireWordsTest, AnInfoCodeIsExplained) {
    const QString words = answer("WS=PH05V05\r", "156\r\n");
    EXPECT_TRUE(words.startsWith(QStringLiteral("info 156: "))) << words.toStdString();
    EXPECT_GT(words.size(), 14);
}

TEST(WireWordsTest, WithoutKnownUnitsNoneAreClaimed) {
    EXPECT_EQ(replyInWords("RG,7\r", parseReply("7=10.2345\r\n", shapeOfAnswerTo("RG,7\r"))), QStringLiteral("HA 10.2345"));
}

TEST(WireWordsTest, UnitsFollowLabel23) {
    const auto units = parseUnitStatus("3214");  // mil, metre, Fahrenheit, inHg
    ASSERT_TRUE(units.has_value());
    EXPECT_EQ(replyInWords("RG,7\r", parseReply("7=1600.0\r\n", shapeOfAnswerTo("RG,7\r")), *units),
              QStringLiteral("HA 1600.0 mil"));
}

}  // namespace
}  // namespace pmts::protocol
