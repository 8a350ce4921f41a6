#include "block_check.hpp"

#include <gtest/gtest.h>

namespace pmts::instrument {
namespace {

protocol::Reply reply(std::string raw) {
    return {.status = std::nullopt, .items = {}, .raw = std::move(raw)};
}

TEST(BlockCheck, TakesTheManualsMeasurementBlock) {
    const auto block = checkBlock(reply("0\r\n7=10.2345\r\n8=101.1005\r\n9=145.324\r\n"));

    EXPECT_EQ(block.kind, BlockKind::kItems);
    EXPECT_EQ(block.status, (protocol::Status{0, std::nullopt}));
    ASSERT_NE(block.find(9), nullptr);
    EXPECT_EQ(*block.find(9), "145.324");
}

TEST(BlockCheck, TakesEmptyAndStatusBlocks) {
    EXPECT_EQ(checkBlock(reply("")).kind, BlockKind::kEmpty);
    EXPECT_EQ(checkBlock(reply("\r\n")).kind, BlockKind::kEmpty);
    EXPECT_EQ(checkBlock(reply("35.8\r\n")).kind, BlockKind::kStatus);
    EXPECT_EQ(checkBlock(reply(">7=10.2345\r\n")).kind, BlockKind::kItems);
}

TEST(BlockCheck, RefusesEveryBlockWithABrokenLine) {
    for (const char* broken :
         {"7=10.2345", "=10.2345\r\n", "710.2345\r\n", "0\r\n7=10.2345\r\n23\r\n", "07=10.2345\r\n",
          "3\r\n3\r\n", "7=1\x15.0\r\n", "7=10.0000\r\n7=11.0000\r\n"}) {
        EXPECT_EQ(checkBlock(reply(broken)).kind, BlockKind::kMalformed) << broken;
    }
}

TEST(BlockCheck, CountsDecimalsOfWholeNumbersOnly) {
    EXPECT_EQ(decimalsOf("23.418"), 3);
    EXPECT_EQ(decimalsOf("0.1234"), 4);
    EXPECT_EQ(decimalsOf("-12.5"), 1);
    EXPECT_EQ(decimalsOf("620123"), 0);
    for (const char* broken : {"", "-", ".5", "5.", "1.2.3", "01.5", "12,5", "1e3", "96.168=38"}) {
        EXPECT_FALSE(decimalsOf(broken).has_value()) << broken;
    }
}

TEST(BlockCheck, ALabelIsAnsweredByItselfOrAStatusOrADamagedBlock) {
    EXPECT_TRUE(canAnswerLabel(reply("9=23.418\r\n"), 9));
    EXPECT_TRUE(canAnswerLabel(reply("7\r\n"), 9));
    EXPECT_TRUE(canAnswerLabel(reply("=23.418\r\n"), 9));
    EXPECT_FALSE(canAnswerLabel(reply("8=23.418\r\n"), 9));
    EXPECT_FALSE(canAnswerLabel(reply(""), 9));
    EXPECT_FALSE(canAnswerLabel(reply("0\r\n9=23.418\r\n"), 9));
}

TEST(BlockCheck, ACommandIsNotAnsweredByData) {
    EXPECT_TRUE(canAnswerCommand(reply("")));
    EXPECT_TRUE(canAnswerCommand(reply("0.0\r\n")));
    EXPECT_FALSE(canAnswerCommand(reply("37=1000.000\r\n38=2000.000\r\n")));
    EXPECT_TRUE(canAnswerCommand(reply("3\r\n")));  // TG may say so
    EXPECT_FALSE(canAnswerWrite(reply("3\r\n")));   // WG cannot: the REG key was pressed
    EXPECT_TRUE(canAnswerWrite(reply("35.8\r\n")));
}

}  // namespace
}  // namespace pmts::instrument
