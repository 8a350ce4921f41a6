#include "pmts/protocol/info_code.hpp"

namespace pmts::protocol {
namespace {

using core::ErrorKind;
using enum InfoClass;

struct PrintedRow {
    InfoClass info_class;
    std::vector<int> codes;
};

/// The column `driver class` of the protocol page, section 2.10, typed again from the page.
const std::vector<PrintedRow> kPage{
    {kOk, {0, 150, 159, 240}},
    {kOperator, {1, 2, 6, 48, 167, 168}},
    {kRemeasure, {3, 4, 7, 28, 171, 172, 173, 174, 175}},
    {kConfiguration, {5, 10, 16, 17, 18, 27}},
    {kPower, {8, 9}},
    {kComm, {19,  21,  22,  23,  36,  37,  39,  45,  46,  49,  100, 101,
             103, 107, 110, 122, 123, 125, 136, 137, 207, 217, 218}},
    {kProtocol, {20, 30, 31, 32, 33, 34, 35, 41, 42, 162, 163, 242}},
    {kState, {24, 40, 43, 44, 191, 201, 241, 243, 244, 245, 246, 247, 248}},
    {kService, {25,  26,  50,  51,  53,  54,  164, 199, 200, 203, 204,
                205, 206, 210, 211, 212, 213, 219, 221, 230, 234, 255}},
    {kMotion, {151, 152, 153, 154, 160}},
    {kMotionSoft, {155, 156, 157}},
    {kTarget, {158, 161, 166}},
    {kRetry, {197}},
    {kAbort, {190}},
    {kData, {300, 301}},
};

TEST(InfoCodeTest, EveryCodeHasTheDriverClassOfTheProtocolPage) {
    for (const auto& row : kPage) {
        for (const int code : row.codes) {
            EXPECT_EQ(infoCode(code).info_class, row.info_class) << "info " << code;
        }
    }
}

TEST(InfoCodeTest, OnlyWhatLeavesTheDataGoodIsAWarning) {
    std::vector<int> warnings;
    for (int code = 0; code < 400; ++code) {
        if (isWarning(code)) {
            warnings.push_back(code);
        }
    }
    EXPECT_EQ(warnings, (std::vector{8, 9, 25, 26}));
}

TEST(InfoCodeTest, EveryCodeSpeaksInPlainSentences) {
    for (int code = 0; code <= 301; ++code) {
        const InfoCode info = infoCode(code);
        EXPECT_TRUE(info.happened.endsWith(u'.')) << code;
        EXPECT_TRUE(info.remedy.isEmpty() || info.remedy.endsWith(u'.')) << code;
        const bool needs_nothing =
            info.info_class == kOk || info.info_class == kAbort || info.info_class == kData;
        EXPECT_TRUE(needs_nothing || !info.remedy.isEmpty()) << code << " does not say what to do";
    }
}

TEST(InfoCodeTest, UnlistedCodeIsNamedByItsNumber) {
    for (const int code : {11, 29, 52, 202, 220, 999}) {
        EXPECT_EQ(infoCode(code).info_class, kUnknown);
        EXPECT_TRUE(infoCode(code).happened.contains(QString::number(code)));
    }
}

TEST(InfoCodeTest, SuffixNamesTheDevice) {
    EXPECT_EQ(suffixMeaning({35, 8}), QStringLiteral("main board"));
    EXPECT_EQ(suffixMeaning({4, 7}), QStringLiteral("distance meter"));
    EXPECT_EQ(suffixMeaning({156, 12}), QStringLiteral("servo"));
    EXPECT_EQ(suffixMeaning({30, std::nullopt}), QString());
}

TEST(InfoCodeTest, SuffixOfALineErrorIsABitSum) {
    EXPECT_EQ(suffixMeaning({21, 12}), QStringLiteral("framing, break received"));
    EXPECT_EQ(suffixMeaning({21, 1}), QStringLiteral("overrun"));
    EXPECT_EQ(suffixMeaning({21, 2}), QStringLiteral("parity"));
}

TEST(InfoCodeTest, SuffixOfServoStartIsTheKnobAndOfFullQueueTheQueue) {
    EXPECT_EQ(suffixMeaning({164, 3}), QStringLiteral("knob 3"));
    EXPECT_EQ(suffixMeaning({207, 1}), QStringLiteral("second queue"));
}

TEST(InfoCodeTest, ErrorKeepsTheCodeForTheLogAndTheSentenceForThePerson) {
    const auto error = errorFromStatus({24, 1});
    EXPECT_EQ(error.kind, ErrorKind::kDevice);
    EXPECT_EQ(error.info_code, 24);
    EXPECT_EQ(error.detail, QStringLiteral("info 24.1 (serial port)"));
    EXPECT_FALSE(error.sentence().contains(QStringLiteral("24")));
    EXPECT_EQ(errorFromStatus({156, std::nullopt}).kind, ErrorKind::kNotReached);
}

}  // namespace
}  // namespace pmts::protocol
