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

TEST(WireWordsTest, CommandsOfTheBusSayTheirUnit) {  // the seven lines of the protocol page, 5.3
    EXPECT_EQ(commandInWords("WV,102=0\r"), QStringLiteral("write label 102 of the main board = 0"));
    EXPECT_EQ(commandInWords("PV,8=9\r"), QStringLiteral("run process 8 of the main board with 9"));
    EXPECT_EQ(commandInWords("PV,4=0\r"), QStringLiteral("run process 4 of the main board with 0"));
    EXPECT_EQ(commandInWords("PV,3=0\r"), QStringLiteral("measuring mode STD"));
    EXPECT_EQ(commandInWords("PV,4\r"), QStringLiteral("run process 4 of the main board"));
    EXPECT_EQ(commandInWords("PV,20\r"), QStringLiteral("calibrate the compensator"));
    EXPECT_EQ(commandInWords("RV,102\r"), QStringLiteral("read label 102 of the main board"));
    EXPECT_EQ(commandInWords("RA,166\r"), QStringLiteral("read VA"));
    EXPECT_EQ(commandInWords("RR,56\r"), QStringLiteral("read Temp of the control unit"));
    EXPECT_EQ(commandInWords("WS,27=1\r"), QStringLiteral("write SHA of the servo = 1"));
    EXPECT_EQ(answer("PV,8=9\r", "240.8\r"), QStringLiteral("The process in the instrument is finished."));
    EXPECT_EQ(answer("WV,102=0\r", "0.8\r"), QStringLiteral("done"));
}

TEST(WireWordsTest, AValueOfTheAngleUnitIsInGonWhateverTheDisplayShows) {
    const auto mil = parseUnitStatus("3214");
    ASSERT_TRUE(mil.has_value());
    EXPECT_EQ(replyInWords({}, parseReply("A,166=96.16838\rA,165=177.56115"), *mil),
              QStringLiteral("VA 96.16838 gon, HA 177.56115 gon"));
    EXPECT_EQ(answer("RV,102\r", "102=1\r"), QStringLiteral("label 102 of the main board 1"));
}

TEST(WireWordsTest, TheUsersNamesGoBeforeTheMakers) {
    const NameOf name_of = [](char unit, int number) {
        return unit == 'V' && number == 102 ? QStringLiteral("stream on") : unit == 'G' && number == 7 ? QStringLiteral("direction") : QString();
    };
    EXPECT_EQ(commandInWords("WV,102=0\r", kUsual, name_of), QStringLiteral("write stream on = 0"));
    EXPECT_EQ(commandInWords("RG,7\r", kUsual, name_of), QStringLiteral("read direction"));
    EXPECT_EQ(commandInWords("RG,8\r", kUsual, name_of), QStringLiteral("read VA"));
    EXPECT_EQ(replyInWords("RG,7\r", parseReply("7=10.2345\r\n"), kUsual, name_of), QStringLiteral("direction 10.2345 gon"));
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
