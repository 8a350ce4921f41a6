#include "pmts/simulator/control_unit.hpp"

#include "pmts/core/virtual_clock.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;

/// A control unit on a cable whose other end is the test.
class ControlUnitTest : public testing::Test {
protected:
    ControlUnitTest() {
        unit.send = [this](std::string_view bytes) {
            heard.emplace_back(bytes);
            if (answers) {
                unit.receive(answers(heard.back()));
            }
        };
        unit.on_foreign = [this](const QString& sentence) { complaints.push_back(sentence.toStdString()); };
        unit.start();
    }
    /// What an instrument says that does as it is told.
    static std::string rightAnswer(const std::string& command, std::string& point_number) {
        if (command.starts_with("WG,5=")) {
            point_number = command.substr(5, command.size() - 6);
            return ">";
        }
        if (command == "TG\r") {
            return ">";
        }
        if (command == "RG\r") {
            return "0\r\n7=10.0000\r\n8=100.0000\r\n9=20.123\r\n>";
        }
        const auto label = command.substr(3, command.size() - 4);
        return label + "=" + (label == "55" ? "620123" : label == "5" ? point_number : "10.0000") + "\r\n>";
    }

    core::VirtualClock clock;
    ControlUnit unit{{}, clock};
    std::function<std::string(const std::string&)> answers;
    std::string point_number;
    std::vector<std::string> heard, complaints;
};

TEST_F(ControlUnitTest, ReadsAnglesAndLabelsWritesAndMeasures) {
    answers = [this](const std::string& command) { return rightAnswer(command, point_number); };
    clock.advance(5min);

    const std::set<std::string> kinds(heard.begin(), heard.end());
    EXPECT_TRUE(kinds.contains("RG,7\r") && kinds.contains("RG,8\r") && kinds.contains("TG\r") && kinds.contains("RG\r"));
    EXPECT_GT(unit.counts().answered, 100U);
    EXPECT_EQ(unit.counts().answered, unit.counts().asked);
    EXPECT_EQ(unit.counts().foreign, 0U);
}

TEST_F(ControlUnitTest, TheSameSeedAsksTheSameAtTheSameTimes) {
    ControlUnit twin({}, clock);
    std::vector<std::string> twin_heard;
    twin.send = [&](std::string_view bytes) { twin_heard.emplace_back(bytes); };
    twin.start();
    clock.advance(10min);

    EXPECT_EQ(heard, twin_heard);
}

TEST_F(ControlUnitTest, AnAnswerToSomebodyElsesQuestionIsNoticed) {
    answers = [](const std::string&) { return "26=96.1684\r\n>"; };
    clock.advance(10s);

    EXPECT_GE(unit.counts().foreign, 1U);
    EXPECT_EQ(unit.counts().answered, 0U);
    EXPECT_NE(complaints.at(0).find("26=96.1684"), std::string::npos);
}

TEST_F(ControlUnitTest, ARefusalIsNoAnswer) {
    answers = [](const std::string&) { return "30\r\n>"; };  // somebody wrote into its command
    clock.advance(10s);

    EXPECT_GE(unit.counts().foreign, 1U);
}

TEST_F(ControlUnitTest, AFragmentWhileItAsksNothingIsNoticedAndAWholeBlockIsNot) {
    unit.receive("37=100.000\r\n>");
    EXPECT_EQ(unit.counts().unasked, 1U);
    unit.receive(".000\r\n>");

    EXPECT_EQ(unit.counts().foreign, 1U);
}

TEST_F(ControlUnitTest, GivesUpOnASilentInstrumentAndGoesOn) {
    clock.advance(5min);

    EXPECT_GE(unit.counts().unanswered, 4U);
    EXPECT_EQ(unit.counts().foreign, 0U);
}

TEST_F(ControlUnitTest, AsksNothingWhileItsCableHangsLoose) {
    unit.is_plugged = [] { return false; };
    clock.advance(5min);

    EXPECT_TRUE(heard.empty());
}

}  // namespace
}  // namespace pmts::simulator
