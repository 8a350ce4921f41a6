#include "box_support.hpp"

#include <gmock/gmock.h>

#include <random>

namespace pmts::blackbox {
namespace {

using testing::ElementsAre;

class RecordingTest : public testing::Test {
protected:
    std::shared_ptr<const Recording> open(const QByteArray& bytes) {
        auto opened = Recording::open(put(folder, bytes));
        EXPECT_TRUE(opened.has_value());
        return opened ? *opened : nullptr;
    }

    QTemporaryDir folder;
    const std::vector<Record> three{numbered(1), numbered(2), numbered(3)};
};

TEST_F(RecordingTest, TheCheckSumIsTheOneOfTheStandard) { EXPECT_EQ(crc32("123456789"), 0xCBF43926U); }

TEST_F(RecordingTest, ARecordStandsInTheFileAsDocumented) {
    const QByteArray bytes = encoded({.kind = Kind::kBytes, .at = core::Duration(0x0102), .body = QByteArray("123456789")});
    EXPECT_EQ(bytes.toHex(' '), QByteArray("b1 0b f8 58 02 00 00 00 09 00 00 00 02 01 00 00 00 00 00 00 ") +
                                    bytes.mid(20, 4).toHex(' ') + " 31 32 33 34 35 36 37 38 39 26 39 f4 cb");
}

TEST_F(RecordingTest, WholeFilesAreReadInOrder) {
    const auto recording = open(fileOf(three));
    EXPECT_THAT(numbersIn(*recording), ElementsAre(1, 2, 3));
    EXPECT_TRUE(recording->damages().empty());
    EXPECT_EQ(recording->entries()[1].at, core::Duration(std::chrono::milliseconds(2)));
}

TEST_F(RecordingTest, AHalfWrittenLastRecordCostsOnlyItself) {
    const QByteArray whole = fileOf(three);
    for (qsizetype cut = whole.size() - encoded(three[2]).size() + 1; cut < whole.size(); ++cut) {
        const auto recording = open(whole.left(cut));
        ASSERT_THAT(numbersIn(*recording), ElementsAre(1, 2)) << "cut at " << cut;
        ASSERT_EQ(recording->damages().size(), 1U);
    }
}

TEST_F(RecordingTest, EveryTurnedByteCostsOnlyTheRecordItIsIn) {
    const QByteArray whole = fileOf(three);
    const qsizetype first = static_cast<qsizetype>(kFileHead.size()) + encoded(three[0]).size();
    for (qsizetype at = first; at < first + encoded(three[1]).size(); ++at) {
        QByteArray damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        const auto recording = open(damaged);
        ASSERT_THAT(numbersIn(*recording), ElementsAre(1, 3)) << "byte " << at;
        ASSERT_EQ(recording->damages().size(), 1U);
        ASSERT_EQ(recording->damages()[0].offset, first);
        ASSERT_EQ(recording->damages()[0].size, encoded(three[1]).size());
    }
}

TEST_F(RecordingTest, ADamagedHeadOfTheFileAndNoiseBetweenArePassedOver) {
    QByteArray bytes = "garbage" + encoded(three[0]) + QByteArray(5000, '\xB1') + encoded(three[1]);
    const auto recording = open(bytes);
    EXPECT_THAT(numbersIn(*recording), ElementsAre(1, 2));
    EXPECT_EQ(recording->damages().size(), 2U);
}

TEST_F(RecordingTest, ARecordInsideABodyIsNotTakenForOne) {
    const Record outer{.kind = Kind::kLog, .at = {}, .body = bodyOf({{QStringLiteral("n"), 7}, {QStringLiteral("b"), encoded(three[0])}})};
    EXPECT_THAT(numbersIn(*open(fileOf({outer, three[1]}))), ElementsAre(7, 2));
}

TEST_F(RecordingTest, NoiseIsRefusedWithASentence) {
    std::mt19937 random(4);
    QByteArray noise(20000, Qt::Uninitialized);
    for (char& byte : noise) {
        byte = static_cast<char>(random());
    }
    for (const QByteArray& bytes : {noise, QByteArray(), QByteArray("PMTS black box 1\n")}) {
        const auto opened = Recording::open(put(folder, bytes));
        ASSERT_FALSE(opened.has_value());
        EXPECT_EQ(opened.error().kind, core::ErrorKind::kFile);
    }
    EXPECT_FALSE(Recording::open(folder.filePath(QStringLiteral("none"))).has_value());
}

}  // namespace
}  // namespace pmts::blackbox
