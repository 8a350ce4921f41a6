#include "pmts/protocol/seen_routine.hpp"

#include "pmts/protocol/line_talk.hpp"

#include <gtest/gtest.h>

namespace pmts::protocol {
namespace {

using Characters = std::vector<DecodedCharacter>;

/// A dialogue: commands to the instrument, replies from it, one after the other.
Characters dialogue(const std::vector<std::pair<TalkSide, std::string>>& said) {
    Characters all;
    for (const auto& [side, text] : said) {
        const auto characters = charactersOf(text, side, all.size());
        all.insert(all.end(), characters.begin(), characters.end());
    }
    return all;
}

constexpr auto kTo = TalkSide::kToInstrument;
constexpr auto kFrom = TalkSide::kFromInstrument;

/// The program of protocol page 5.3; the third command has no reply there.
Characters laserOn() {
    return dialogue({{kFrom, "A,166=96.16838\rA,165=177.56115\x04"}, {kTo, "WV,102=0\r"}, {kFrom, "0.8\r\x04"},
                     {kTo, "PV,8=9\r"}, {kFrom, "240.8\x04"}, {kTo, "PV,4=0\r"}, {kTo, "WV,102=1\r"}, {kFrom, "0.8\x04"},
                     {kFrom, "A,166=96.16839\rA,165=177.56115\x04"}});
}

TEST(SeenRoutineTest, DialogueBecomesATableThatIsAccepted) {
    const SeenRoutine seen = seenRoutine(laserOn(), "laser_on", "Seen on the bus.");
    EXPECT_TRUE(seen.left_out.isEmpty());
    const InstructionTable table = readInstructionTable(instructionTableText({&seen.routine, 1}, {"A,166 is VA"}));
    EXPECT_TRUE(table.problems.empty()) << table.problems[0].sentence.toStdString();
    const TableRoutine* const routine = table.find("laser_on");
    ASSERT_NE(routine, nullptr);
    ASSERT_EQ(routine->steps.size(), 4U);
    EXPECT_EQ(routine->note, "Seen on the bus.");
    EXPECT_EQ(routine->steps[1].text, "PV,8=9");
    EXPECT_EQ(routine->steps[1].expect, std::vector<std::string>{"240.8"});
    EXPECT_EQ(routine->steps[3].expect, std::vector<std::string>{"0.8"});
}

TEST(SeenRoutineTest, CommandWithoutAReplyIsOptional) {
    const auto steps = seenRoutine(laserOn(), "laser_on", {}).routine.steps;
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_TRUE(steps[2].optional);
    EXPECT_FALSE(steps[1].optional);
}

TEST(SeenRoutineTest, ValueThatChangesIsExpectedByItsLabel) {
    const auto seen = seenRoutine(dialogue({{kTo, "RG,7\r"}, {kFrom, "7=10.2345\r\n>"}, {kTo, "RG,7\r"}, {kFrom, "7=11.0000\r\n>"}}),
                                  "poll", {});
    ASSERT_EQ(seen.routine.steps.size(), 1U);
    EXPECT_EQ(seen.routine.steps[0].expect, std::vector<std::string>{"7=*"});
    EXPECT_EQ(judge(seen.routine.steps[0], "7=399.9999\r\n"), TableVerdict::kExpected);
}

TEST(SeenRoutineTest, ReplyOfSeveralLinesIsExpectedByItsFirst) {
    const auto seen = seenRoutine(dialogue({{kTo, "RG\r"}, {kFrom, "0\r\n7=10.2345\r\n8=101.1005\r\n>"}}), "read", {});
    ASSERT_EQ(seen.routine.steps.size(), 1U);
    EXPECT_EQ(judge(seen.routine.steps[0], "0\r\n7=1.0000\r\n8=100.0000\r\n"), TableVerdict::kExpected);
}

TEST(SeenRoutineTest, DoubtfulAndForbiddenCommandsAreLeftOutAndNamed) {
    auto characters = laserOn();
    characters.back().margin = 0.0F;  // of the stream: no harm
    characters[33].margin = 0.0F;     // of WV,102=0
    const auto erase = dialogue({{kTo, "KM=JOB1\r"}, {kFrom, "0\r\n>"}});
    characters.insert(characters.end(), erase.begin(), erase.end());
    const auto seen = seenRoutine(characters, "laser_on", {});
    ASSERT_EQ(seen.left_out.size(), 2);
    EXPECT_TRUE(seen.left_out[0].contains(QStringLiteral("WV,102=0"))) << seen.left_out[0].toStdString();
    EXPECT_EQ(seen.routine.steps.size(), 3U);
}

TEST(SeenRoutineTest, WithoutSidesWhatLooksLikeACommandIsOne) {
    const auto seen = seenRoutine(charactersOf("WV,102=0\r0.8\x04PV,8=9\r240.8\x04"), "both", {});
    ASSERT_EQ(seen.routine.steps.size(), 2U);
    EXPECT_EQ(seen.routine.steps[0].expect, std::vector<std::string>{"0.8"});
}

TEST(SeenRoutineTest, ALineOfAHundredThousandCharactersIsReadAndDoesNotCrash) {
    const std::string digits(100'000, '1');
    const auto seen = seenRoutine(dialogue({{kFrom, "A,166=" + digits + "\r\x04"}, {kTo, "WV," + digits + "=0\r"}, {kFrom, "0.8\x04"},
                                            {kTo, "RV,7\r"}, {kFrom, digits + "\x04"}}),
                                  "long", {});
    ASSERT_EQ(seen.routine.steps.size(), 1U);
    EXPECT_EQ(seen.routine.steps[0].text, "RV,7");
    ASSERT_EQ(seen.routine.steps[0].expect.size(), 1U);
    EXPECT_EQ(judge(seen.routine.steps[0], digits), TableVerdict::kExpected);
    ASSERT_EQ(seen.left_out.size(), 1);
    EXPECT_LT(seen.left_out[0].size(), 300);
    EXPECT_FALSE(isSeenCommand("WV" + digits));
}

/// Where nobody said which side speaks, every line is asked whether it is a command.
TEST(SeenRoutineTest, OneLongLineOfUnknownSideDoesNotCrash) {
    const auto characters = charactersOf("WV" + std::string(100'000, 'A') + "\rA,1" + std::string(100'000, '2') + "=3\r");
    EXPECT_TRUE(seenRoutine(characters, "long", {}).routine.steps.empty());
}

TEST(SeenRoutineTest, EveryWordOfAStepIsWrittenAndReadAgain) {
    using namespace std::chrono_literals;
    const TableStep step{.text = "PV,8={n 1..9}", .expect = {"240.8", "24*"}, .fail = {"242.8", "35*"}, .within = 2500ms,
                         .optional = true, .time_critical = true, .always = true, .pause = 300ms};
    const TableRoutine routine{.name = "all", .note = "every word", .steps = {step}};
    const auto table = readInstructionTable(instructionTableText({&routine, 1}, {}));
    ASSERT_TRUE(table.problems.empty()) << table.problems[0].sentence.toStdString();
    ASSERT_EQ(table.routines.size(), 1U);
    ASSERT_EQ(table.routines[0].steps.size(), 1U);
    const auto& [line, text, expect, fail, within, optional, time_critical, always, pause] = table.routines[0].steps[0];
    EXPECT_GT(line, 0);
    EXPECT_EQ(text, step.text);
    EXPECT_EQ(expect, step.expect);
    EXPECT_EQ(fail, step.fail);
    EXPECT_EQ(within, step.within);
    EXPECT_TRUE(optional);
    EXPECT_TRUE(time_critical);
    EXPECT_TRUE(always);
    EXPECT_EQ(pause, step.pause);
}

}  // namespace
}  // namespace pmts::protocol
