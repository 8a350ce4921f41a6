#include "pmts/protocol/reply.hpp"

#include "protocol/bytes.hpp"
#include "support/matchers.hpp"

namespace pmts::protocol {
namespace {

using core::ErrorKind;
using test::bytesFromHex;
using test::FailedWith;
using testing::ElementsAre;

const Item kHaItem{7, "", "10.2345"};
const Item kVaItem{8, "", "101.1005"};
const Item kSdItem{9, "", "145.324"};

TEST(ReplyTest, StandardMeasurementOfTheProtocolPage) {
    const auto reply =
        parseReply(bytesFromHex("30 0D 0A 37 3D 31 30 2E 32 33 34 35 0D 0A 38 3D 31 30 31 2E 31 30 30 35 "
                                "0D 0A 39 3D 31 34 35 2E 33 32 34 0D 0A"));
    EXPECT_EQ(reply.status, (Status{0, std::nullopt}));
    EXPECT_THAT(reply.items, ElementsAre(kHaItem, kVaItem, kSdItem));
    ASSERT_NE(reply.find(9), nullptr);
    EXPECT_EQ(reply.find(9)->data, "145.324");
    EXPECT_EQ(reply.find(17), nullptr);
}

TEST(ReplyTest, ErrorsOfTheProtocolPage) {
    EXPECT_EQ(parseReply(bytesFromHex("32 30 0D 0A")).status, (Status{20, std::nullopt}));
    EXPECT_EQ(parseReply(bytesFromHex("33 30 2E 31 0D 0A")).status, (Status{30, 1}));
    EXPECT_EQ(parseReply(bytesFromHex("33 30 31 0D 0A")).status, (Status{301, std::nullopt}));
}

TEST(ReplyTest, NamesForm) {
    const auto reply =
        parseReply("0\r\nHA=10.2345\r\nVA=101.1005\r\nSD=145.324\r\n", {ReadForm::kNames, false, false});
    EXPECT_EQ(reply.status->code, 0);
    EXPECT_THAT(reply.items, ElementsAre(Item{{}, "HA", "10.2345"}, Item{{}, "VA", "101.1005"},
                                         Item{{}, "SD", "145.324"}));
}

TEST(ReplyTest, DataOnlyForm) {
    const auto reply =
        parseReply("0\r\n10.2345\r\n101.1005\r\n145.324\r\n", {ReadForm::kDataOnly, false, false});
    EXPECT_EQ(reply.status->code, 0);
    EXPECT_THAT(reply.items,
                ElementsAre(Item{{}, "", "10.2345"}, Item{{}, "", "101.1005"}, Item{{}, "", "145.324"}));
    EXPECT_EQ(parseReply("0\r\n10.2345\r\n101.1005\r\n145.324\r\n").items, reply.items);
}

TEST(ReplyTest, SeparateFormPairsLabelAndData) {
    const auto reply = parseReply("0\r\n7\r\n10.2345\r\n8\r\n101.1005\r\n9\r\n145.324\r\n", true);
    EXPECT_EQ(reply.status->code, 0);
    EXPECT_THAT(reply.items, ElementsAre(kHaItem, kVaItem, kSdItem));
}

TEST(ReplyTest, OneLabelHasNoStatusLineInAnyForm) {
    EXPECT_THAT(parseReply("5=104\r\n", shapeOf(ReadLabel{5})).items, ElementsAre(Item{5, "", "104"}));
    EXPECT_THAT(parseReply("Pno=104\r\n", shapeOf(ReadLabel{5, ReadForm::kNames})).items,
                ElementsAre(Item{{}, "Pno", "104"}));
    EXPECT_THAT(parseReply("104\r\n", shapeOf(ReadLabel{5, ReadForm::kDataOnly})).items,
                ElementsAre(Item{{}, "", "104"}));
    const auto separate = parseReply("5\r\n104\r\n", shapeOf(ReadLabel{5, ReadForm::kSeparate}));
    EXPECT_THAT(separate.items, ElementsAre(Item{5, "", "104"}));
    EXPECT_FALSE(separate.status.has_value());
}

TEST(ReplyTest, FreeMemoryIsANumberAndNoStatus) {
    const auto reply = parseReply("512\r\n", shapeOf(FreeMemory{}));
    EXPECT_FALSE(reply.status.has_value());
    EXPECT_THAT(reply.items, ElementsAre(Item{{}, "", "512"}));
}

TEST(ReplyTest, StatusIsOneToThreeDigitsWithAtMostTwoOfSuffix) {
    EXPECT_EQ(parseStatus("0"), (Status{0, std::nullopt}));
    EXPECT_EQ(parseStatus("240.8"), (Status{240, 8}));
    EXPECT_EQ(parseStatus("21.12"), (Status{21, 12}));
    for (const char* line : {"", "1234", "7=3", ".8", "8.", "35.123", "-1", "3 0", "30.x", "1.2.3"}) {
        EXPECT_FALSE(parseStatus(line).has_value()) << line;
    }
}

TEST(ReplyTest, EmptyBlockAnswersAWrite) {
    const auto reply = parseReply("");
    EXPECT_FALSE(reply.status.has_value());
    EXPECT_TRUE(reply.items.empty());
}

TEST(ReplyTest, StrayMarkAndLineNoiseAheadOfALiveMeasurementArePassedOver) {
    const std::string block = "0\r\n7=10.2345\r\n8=101.1005\r\n9=145.324\r\n";
    for (const std::string start : {">", ">>", "\r\n>", "\xFF\x00", "\x80>\xFE"}) {
        const auto reply = parseReply(start + block);
        EXPECT_EQ(reply.status, (Status{0, std::nullopt}));
        EXPECT_THAT(reply.items, ElementsAre(kHaItem, kVaItem, kSdItem));
    }
}

TEST(ReplyTest, DamagedByteInsideANumberStaysVisible) {
    const auto reply = parseReply(
        "0\r\n7=10.\xFF"
        "345\r\n");
    EXPECT_EQ(reply.find(7)->data,
              "10.\xFF"
              "345");
}

TEST(ReplyTest, BlocksThatRanIntoOneAnotherAreCalledDamaged) {
    EXPECT_TRUE(parseReply("0\r\n7=10.2345\r\n8=101.1005\r\n0\r\n7=20.0000\r\n8=101.1005\r\n").damaged);
    EXPECT_TRUE(parseReply("7=10.2345\r\n7=20.0000\r\n").damaged);
    EXPECT_TRUE(parseReply("7=10.2345\r\n20\r\n").damaged);
}

TEST(ReplyTest, LostAndTurnedBytesThatShowAreCalledDamaged) {
    EXPECT_TRUE(parseReply("0\r\n710.2345\r\n8=101.1005\r\n").damaged) << "lost equals sign";
    EXPECT_TRUE(parseReply("0\r\n7=10.\xFF"
                           "345\r\n")
                    .damaged);
    EXPECT_TRUE(parseReply("0\r\n7\r\n10.2345\r\n101.1005\r\n", true).damaged) << "lost label line";
    EXPECT_TRUE(parseReply("0.\r\n7=10.2345\r\n").damaged) << "half a status";
}

TEST(ReplyTest, WholeBlocksAreNotCalledDamaged) {
    EXPECT_FALSE(parseReply(">0\r\n7=10.2345\r\n8=101.1005\r\n").damaged);
    EXPECT_FALSE(parseReply("0\r\n10.2345\r\n10.2345\r\n", {ReadForm::kDataOnly, false, false}).damaged);
    EXPECT_FALSE(parseReply("50=JOB1\r\n50=JOB2\r\n", shapeOf(ListFiles{})).damaged);
    EXPECT_FALSE(parseReply("").damaged);
}

TEST(ReplyTest, ValueMayHoldAnEqualsSign) {
    EXPECT_THAT(parseReply("0=A=B\r\n").items, ElementsAre(Item{0, "", "A=B"}));
}

TEST(ReplyTest, BareCarriageReturnsEndLinesToo) {
    EXPECT_THAT(parseReply("0\r7=10.2345\r8=101.1005\r").items, ElementsAre(kHaItem, kVaItem));
}

TEST(ReplyTest, EndMarkIsReadFromLabel79) {
    EXPECT_EQ(endMarkFromLabel("62").value(), '>');
    EXPECT_EQ(endMarkFromLabel("4").value(), '\x04');
    EXPECT_EQ(endMarkFromLabel("0").value(), std::nullopt);
    EXPECT_THAT(endMarkFromLabel("300"), FailedWith(ErrorKind::kProtocol));
    EXPECT_THAT(endMarkFromLabel(""), FailedWith(ErrorKind::kProtocol));
    EXPECT_EQ(endMarkText('>'), "62");
    EXPECT_EQ(endMarkText(std::nullopt), "0");
}

}  // namespace
}  // namespace pmts::protocol
