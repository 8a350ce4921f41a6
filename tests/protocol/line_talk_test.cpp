#include "pmts/protocol/line_talk.hpp"

#include "support/matchers.hpp"

#include <gtest/gtest.h>

namespace pmts::protocol {
namespace {

using pmts::test::FailedWith;

std::string textOfLine(const std::vector<DecodedCharacter>& characters, const TalkLine& line) {
    return textOf(std::span(characters).subspan(line.first, line.count));
}

TEST(LineTalkTest, LinesEndBehindTheirEndMarks) {
    const auto characters = charactersOf("RG\r0\r\n7=10.2345\r\n>A,166=96.16838\rA,165=1\x04");
    std::vector<std::string> texts;
    for (const TalkLine& line : talkLines(characters, 1e9)) {
        texts.push_back(textOfLine(characters, line));
    }
    EXPECT_EQ(texts, (std::vector<std::string>{"RG<CR>", "0<CR><LF>", "7=10.2345<CR><LF>>", "A,166=96.16838<CR>",
                                               "A,165=1<EOT>"}));
}

TEST(LineTalkTest, PauseAndChangeOfSideEndALine) {
    auto characters = charactersOf("WV");
    characters[1].sample = 500;
    const auto answer = charactersOf("08", TalkSide::kFromInstrument, 501);
    characters.insert(characters.end(), answer.begin(), answer.end());
    EXPECT_EQ(talkLines(characters, 100.0).size(), 3U);
}

TEST(LineTalkTest, DoubtfulCharactersAreMarkedInTextAndHex) {
    auto characters = charactersOf("A,1");
    characters[1].margin = 0.1F;
    EXPECT_EQ(textOf(characters), "A[?,]1");
    EXPECT_EQ(hexOf(characters), "41 2C? 31");
    EXPECT_EQ(talkLines(characters, 100.0)[0].unsure, 1U);
}

TEST(LineTalkTest, BytesOfALogLookLikeThoseOfARecording) {
    EXPECT_EQ(shownBytes("0.8\r\x04\x07\xE9"), "0.8<CR><EOT><07><E9>");
    EXPECT_EQ(shownBytes("0.8\r\x04\x07\xE9"), textOf(charactersOf("0.8\r\x04\x07\xE9")));
}

TEST(LineTalkTest, TwoLinesAreMergedInTheOrderOfTime) {
    const auto merged = mergedTalk(charactersOf("AC", TalkSide::kUnknown, 0), charactersOf("B", TalkSide::kUnknown, 1));
    EXPECT_EQ(merged.size(), 3U);
    EXPECT_LE(merged[1].sample, merged[2].sample);
}

TEST(LineTalkTest, CommandsWentToTheInstrument) {
    EXPECT_EQ(likelySide(charactersOf("WV,102=0\rPV,8=9\r")), TalkSide::kToInstrument);
    EXPECT_EQ(likelySide(charactersOf("0.8\x04" "240.8\x04" "A,166=96.16838\r")), TalkSide::kFromInstrument);
    EXPECT_EQ(likelySide({}), TalkSide::kUnknown);
}

TEST(LineTalkTest, SearchUnderstandsWhatIsShown) {
    EXPECT_EQ(searchedBytes("96.1<CR>A"), std::string("96.1\rA"));
    EXPECT_EQ(searchedBytes("0D 41"), std::string("\rA"));
    EXPECT_EQ(searchedBytes("<1B>"), std::string("\x1B"));
    EXPECT_EQ(searchedBytes("41"), std::string("41"));
    EXPECT_THAT(searchedBytes(""), FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::protocol
