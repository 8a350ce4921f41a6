#include "pmts/protocol/label_backup.hpp"

#include <algorithm>
#include <gmock/gmock.h>

namespace pmts::protocol {
namespace {

using testing::ElementsAre;

LabelBackup backup() {
    return {.utc = QDateTime({2026, 6, 1}, {12, 30, 5}, Qt::UTC),
            .serial_number = "620123",
            .temperature = "21.5",
            .readings = {{.label = 7, .data = "177.5612", .refused = {}, .steady = false},
                         {.label = 20, .data = "0.000", .refused = {}},
                         {.label = 57, .data = {}, .refused = Status{20, 8}},
                         {.label = 90, .data = "", .refused = {}}}};
}

TEST(LabelBackupTest, TheTextSaysDateSerialNumberAndTemperatureAndReadsBackWhole) {
    const auto text = backupText(backup());
    EXPECT_THAT(text, testing::HasSubstr("# date: 2026-06-01T12:30:05Z\n# serial number: 620123\n# temperature: 21.5\n"));
    EXPECT_THAT(text, testing::HasSubstr("7~177.5612\n20=0.000\n57!20.8\n90=\n"));
    const auto read = parseBackup(text);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->readings, backup().readings);
    EXPECT_EQ(read->utc, backup().utc);
    EXPECT_EQ(read->serial_number, "620123");
}

TEST(LabelBackupTest, AnotherFileIsRefusedWithItsLine) {
    EXPECT_THAT(parseBackup("5=1\r\n").error().happened.toStdString(), testing::HasSubstr("Line 1"));
    EXPECT_THAT(parseBackup(backupText(backup()) + "what\n").error().happened.toStdString(), testing::HasSubstr("Line 9"));
}

TEST(LabelBackupTest, WhatChangedIsToldAndASettingIsToldApartFromAReading) {
    auto later = backup();
    later.readings[0].data = "12.0000";  // HA: measured
    later.readings[1].data = "0.035";    // offset: somebody set it
    EXPECT_THAT(changesBetween(backup(), later), ElementsAre(LabelChange{7, "177.5612", "12.0000", false},
                                                             LabelChange{20, "0.000", "0.035", true}));
}

TEST(LabelBackupTest, ALabelThatDidNotAnswerIsKeptOpenAndSaysNothingOfAChange) {
    auto silent = backup();
    silent.readings[1].data.reset();
    const auto text = backupText(silent);
    EXPECT_THAT(text, testing::HasSubstr("\n20?\n"));
    const auto read = parseBackup(text);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->readings, silent.readings);
    EXPECT_TRUE(changesBetween(backup(), silent).empty());
    EXPECT_TRUE(changesBetween(silent, backup()).empty());
}

TEST(LabelBackupTest, TheServiceAccessAndTheRadioAreNeverAskedFor) {
    const auto& labels = backupLabels();
    EXPECT_EQ(std::ranges::count_if(labels, [](int label) { return label < 110; }), 110);
    for (const int never : {127, 247, 250, 251, 252, 253, 254}) {
        EXPECT_EQ(std::ranges::count(labels, never), 0) << never;
    }
}

}  // namespace
}  // namespace pmts::protocol
