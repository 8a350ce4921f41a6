#include "pmts/protocol/instruction_table.hpp"

#include "support/matchers.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace pmts::protocol {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

InstructionTable shipped() {
    std::ifstream file(PMTS_TEST_DATA "/../../resources/instructions/geodimeter-bus.txt");
    std::stringstream text;
    text << file.rdbuf();
    return readInstructionTable(text.str());
}

std::vector<int> problemLines(std::string_view text) {
    std::vector<int> lines;
    for (const auto& problem : readInstructionTable(text).problems) {
        EXPECT_FALSE(problem.sentence.isEmpty());
        lines.push_back(problem.line);
    }
    return lines;
}

TEST(InstructionTable, TheShippedLaserRoutineIsThePublishedOne) {
    const auto table = shipped();
    EXPECT_TRUE(table.problems.empty());
    const auto* laser = table.find("laser_on");
    ASSERT_NE(laser, nullptr);
    std::vector<std::string> sent;
    for (const auto& step : laser->steps) {
        sent.push_back(bytesOf(step, {}).value());
    }

    EXPECT_THAT(sent, ElementsAre("WV,102=0\r", "PV,8=9\r", "PV,4=0\r", "WV,102=1\r", "WV,102=0\r", "PV,3=0\r",
                                  "WV,102=1\r"));
    EXPECT_TRUE(laser->steps[2].optional);  // the third reply is not in the publication
    EXPECT_NE(laser->note.find("unverified"), std::string::npos);
}

TEST(InstructionTable, TheShippedModeRoutineTakesTheModesThereAre) {
    const auto table = shipped();
    const auto* mode = table.find("measuring_mode");
    ASSERT_NE(mode, nullptr);
    EXPECT_THAT(mode->parameters(), ElementsAre(TableParameter{"mode", 0.0, 4.0}));

    EXPECT_EQ(bytesOf(mode->steps[1], {{"mode", 3}}).value(), "PV,3=3\r");
    EXPECT_THAT(bytesOf(mode->steps[1], {{"mode", 5}}), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_THAT(bytesOf(mode->steps[1], {}), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_NE(mode->note.find("Inferred"), std::string::npos);
}

TEST(InstructionTable, EveryWordOfAStepIsRead) {
    const auto table = readInstructionTable(
        "routine find\nsend PV,9={angle}\n expect 240.8 24*\n fail 248.8\n within 2.5\n optional\n time_critical\n");
    ASSERT_TRUE(table.problems.empty());
    const auto& step = table.routines.at(0).steps.at(0);

    EXPECT_EQ(step.within, core::Duration(2500ms));
    EXPECT_TRUE(step.optional && step.time_critical);
    EXPECT_EQ(bytesOf(step, {{"angle", 96.16838}}).value(), "PV,9=96.16838\r");
    EXPECT_EQ(bytesOf(step, {{"angle", 100}}).value(), "PV,9=100\r");
}

TEST(InstructionTable, RepliesAreJudgedWithoutTheirLineEnds) {
    const auto table = readInstructionTable("routine a\nsend PV,8=9\nexpect 240.8 30*\nfail 24* 300\n");
    const auto& step = table.routines.at(0).steps.at(0);

    EXPECT_EQ(judge(step, "301\r\n"), TableVerdict::kExpected);
    EXPECT_EQ(judge(step, "\r300\r"), TableVerdict::kFailed);  // a failure that is named counts before a star
    EXPECT_EQ(judge(step, "248.8\r"), TableVerdict::kFailed);
    EXPECT_EQ(judge(step, "0.8\r"), TableVerdict::kUnknown);
    EXPECT_EQ(judge(step, ""), TableVerdict::kUnknown);
}

TEST(InstructionTable, EveryProblemIsNamedWithItsLine) {
    EXPECT_THAT(problemLines("send WV,102=0\n"), ElementsAre(1));                       // before a routine
    EXPECT_THAT(problemLines("routine a\nexpect 0.8\nsend WV,1=0\nexpect 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\n# nothing\n"), ElementsAre(1));
    EXPECT_THAT(problemLines("routine a b\nsend WV,1=0\nexpect 0\n"), ElementsAre(1));
    EXPECT_THAT(problemLines("routine a\nsend wv,1=0\nexpect 0\n"), ElementsAre(2));    // lower case: info 30
    EXPECT_THAT(problemLines("routine a\nsend WV, 1=0\nexpect 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\n"), ElementsAre(2));              // no reply said
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect\n"), ElementsAre(2, 3));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect 2*4\n"), ElementsAre(3));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect 0\nwithin soon\nwithin -1\n"), ElementsAre(4, 5));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect 0\nfail 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect 0\nrepeat 3\n"), ElementsAre(4));
    EXPECT_THAT(problemLines("routine a\nsend WV,1={n 4..0}\nexpect 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect 0\nroutine a\nsend WV,1=0\nexpect 0\n"), ElementsAre(4));
}

TEST(InstructionTable, WhatMustNeverBeSentIsRefusedInATableToo) {
    EXPECT_THAT(problemLines("routine a\nsend KM=JOB1\nexpect 0\nsend LV,1=0\nexpect 0\n"), ElementsAre(2, 4));
}

TEST(InstructionTable, ANumberThatMakesADeniedCommandIsRefusedBeforeItIsSent) {
    const auto table = readInstructionTable(
        "routine a\nsend WG,{label 1..200}={v}\nexpect 0\nsend WV,{n 0..200}=0\nexpect 0\n");
    ASSERT_TRUE(table.problems.empty());
    const auto& steps = table.routines.at(0).steps;

    EXPECT_EQ(bytesOf(steps[0], {{"label", 42}, {"v", 1.5}}).value(), "WG,42=1.5\r");
    EXPECT_THAT(bytesOf(steps[0], {{"label", 150}, {"v", 1}}), test::FailedWith(core::ErrorKind::kRefused));
    EXPECT_EQ(bytesOf(steps[1], {{"n", 126}}).value(), "WV,126=0\r");
    EXPECT_THAT(bytesOf(steps[1], {{"n", 127}}), test::FailedWith(core::ErrorKind::kRefused));
    EXPECT_THAT(bytesOf(steps[1], {{"n", 126.9999999}}), test::FailedWith(core::ErrorKind::kRefused));  // rounded on the wire
    EXPECT_THAT(bytesOf(steps[1], {{"n", 12.5}}), test::FailedWith(core::ErrorKind::kBadInput));        // no label
}

/// The library's regular expressions take a stack frame for each character.
TEST(InstructionTable, ALineOfAHundredThousandCharactersIsAProblemNotACrash) {
    const std::string long_one(100'000, 'A');
    const std::string lower(100'000, 'a');
    EXPECT_THAT(problemLines("routine " + long_one + "\nsend WV,1=0\nexpect 0\n"), ElementsAre(1));
    EXPECT_THAT(problemLines("routine a\nsend WV" + long_one + "\nexpect 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\nsend WV,1={" + lower + "}\nexpect 0\n"), ElementsAre(2));
    EXPECT_THAT(problemLines("routine a\nsend WV,1=0\nexpect " + long_one + "\n"), ElementsAre(3));
    const TableStep step{.text = "WV,1={" + lower + "}", .expect = {}, .fail = {}};
    EXPECT_THAT(bytesOf(step, {}), test::FailedWith(core::ErrorKind::kBadInput));
    const auto table = readInstructionTable("routine a\nsend " + long_one + "\nexpect " + long_one + "\n");
    for (const TableProblem& problem : table.problems) {
        EXPECT_LT(problem.sentence.size(), 300);
    }
    EXPECT_TRUE(table.routines.at(0).parameters().empty());
}

TEST(InstructionTable, WindowsLineEndsAndBlankLinesMakeNoDifference) {
    EXPECT_TRUE(problemLines("\r\nroutine a\r\n\r\n  send WV,1=0\r\n\texpect 0.8\r\n").empty());
}

}  // namespace
}  // namespace pmts::protocol
