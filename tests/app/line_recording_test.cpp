#include "pmts/app/line/line_recording.hpp"

#include "pmts/app/line/line_findings.hpp"
#include "pmts/blackbox/record.hpp"
#include "pmts/job/archive.hpp"
#include "support/matchers.hpp"

#include <QCborMap>
#include <QFile>
#include <QTemporaryDir>
#include <QtEndian>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using namespace std::chrono_literals;
using protocol::TalkSide;
using test::FailedWith;
using testing::HasSubstr;

class LineRecordingTest : public testing::Test {
protected:
    QString write(const char* name, const QByteArray& bytes) const {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }
    /// What went one way, `>` to the instrument.
    static std::string said(const LineRecording& recording, TalkSide side) {
        std::string text;
        for (const auto& character : recording.said) {
            text += character.side == side ? std::string(1, static_cast<char>(character.value)) : std::string();
        }
        return text;
    }

    QTemporaryDir folder;
};

template <class Number>
void put(QByteArray& bytes, Number number) {
    const Number little = qToLittleEndian(number);
    bytes.append(reinterpret_cast<const char*>(&little), sizeof little);
}

/// A zip archive with one deflated file (APPNOTE 6.3, method 8).
QByteArray zipWith(const QByteArray& name, const QByteArray& content) {
    const QByteArray zlib = qCompress(content, 9).mid(4);
    const QByteArray deflated = zlib.mid(2, zlib.size() - 6);  // without zlib's head and check sum
    const auto common = [&](QByteArray& to) {
        put<quint16>(to, 20);  // version 2.0
        put<quint16>(to, 0);
        put<quint16>(to, 8);
        put<quint32>(to, 0x00210000);  // 1980-01-01 00:00
        put<quint32>(to, blackbox::crc32({content.constData(), static_cast<std::size_t>(content.size())}));
        put<quint32>(to, static_cast<quint32>(deflated.size()));
        put<quint32>(to, static_cast<quint32>(content.size()));
        put<quint16>(to, static_cast<quint16>(name.size()));
        put<quint16>(to, 0);
    };
    QByteArray zip("PK\x03\x04", 4);
    common(zip);
    zip += name + deflated;
    const auto directory = static_cast<quint32>(zip.size());
    zip += QByteArray("PK\x01\x02", 4);
    put<quint16>(zip, 20);
    common(zip);
    zip += QByteArray(14, '\0') + name;  // no remark, disk 0, no attributes, first file
    const auto directory_size = static_cast<quint32>(zip.size()) - directory;
    zip += QByteArray("PK\x05\x06\0\0\0\0", 8);
    put<quint16>(zip, 1);
    put<quint16>(zip, 1);
    put<quint32>(zip, directory_size);
    put<quint32>(zip, directory);
    put<quint16>(zip, 0);
    return zip;
}

QByteArray bytesRecord(core::Duration at, const char* port, const char* direction, const char* bytes) {
    const QCborMap body{{QStringLiteral("port"), QString::fromLatin1(port)},
                        {QStringLiteral("dir"), QString::fromLatin1(direction)},
                        {QStringLiteral("bytes"), QByteArray(bytes)}};
    return blackbox::encoded({.kind = blackbox::Kind::kBytes, .at = at, .body = blackbox::bodyOf(body)});
}

TEST_F(LineRecordingTest, AnArchiveUnpacksNoMoreThanIsAskedFor) {
    const QString bomb = write("bomb.sr", zipWith("metadata", "capturefile=logic-1\n" + QByteArray(64 << 20, ' ')));
    ASSERT_LT(QFile(bomb).size(), 100'000);
    EXPECT_EQ(job::archivedFile(bomb, QStringLiteral("metadata"), 19), QByteArray("capturefile=logic-1"));
    EXPECT_EQ(job::archivedFile(bomb, QStringLiteral("metadata"), 3 << 20)->size(), 3 << 20);
    EXPECT_EQ(job::archivedFile(bomb, QStringLiteral("logic-1"), 100), std::nullopt);
    EXPECT_THAT(readLineRecording(bomb, {}, {}), FailedWith(core::ErrorKind::kBadInput));  // no samples in it
}

TEST_F(LineRecordingTest, ABlackBoxSaysWhatWentOverEachPortWithItsTimes) {
    QByteArray box(blackbox::kFileHead.data(), static_cast<qsizetype>(blackbox::kFileHead.size()));
    box += bytesRecord(100s, "/dev/ttyUSB0", ">", "RG,7\r");
    box += bytesRecord(100s + 20ms, "/dev/ttyUSB1", "<", "RG\r");
    box += bytesRecord(100s + 52083us, "/dev/ttyUSB0", "<", "7=10.2345\r\n>");
    box += "damage";
    box += bytesRecord(101s, "/dev/ttyUSB0", "!", "The port has gone.");
    const auto recording = readLineRecording(write("1.pmtsbox", box), {}, {});
    ASSERT_TRUE(recording) << recording.error().sentence().toStdString();

    EXPECT_EQ(recording->format, protocol::CaptureFormat::kSession);
    EXPECT_EQ(said(*recording, TalkSide::kToInstrument), "RG,7\r");
    EXPECT_EQ(said(*recording, TalkSide::kFromInstrument), "7=10.2345\r\n>RG\r") << "the second port behind the first";
    EXPECT_EQ(recording->said[5].sample, 52083U);
    EXPECT_EQ(recording->samples_per_s, 1e6);
    ASSERT_EQ(recording->capture.doubts.size(), 2U);
    EXPECT_THAT(recording->capture.doubts[0].what.toStdString(), HasSubstr("/dev/ttyUSB0 (17 bytes), /dev/ttyUSB1 (3 bytes)"));
    EXPECT_THAT(recording->capture.doubts[1].what.toStdString(), HasSubstr("Damaged"));
}

TEST_F(LineRecordingTest, ReadingEndsWhenItIsTold) {
    QByteArray csv("a,b\n");
    for (int i = 0; i < 200'000; ++i) {
        csv += i % 2 == 0 ? "0,1\n" : "1,1\n";
    }
    int asked = 0;
    const protocol::Progress twice = [&asked](double) { return ++asked < 3; };
    EXPECT_THAT(readLineRecording(write("long.csv", csv), {}, {}, twice), FailedWith(core::ErrorKind::kCancelled));
    EXPECT_EQ(asked, 3);
    asked = 0;
    EXPECT_THAT(readLineRecording(write("long.bin", csv), protocol::CaptureFormat::kSamples, {}, twice),
                FailedWith(core::ErrorKind::kCancelled));
    EXPECT_EQ(asked, 3);
}

TEST_F(LineRecordingTest, EveryStageOfTheExaminationEndsWhenItIsTold) {
    const auto recording = readLineRecording(QStringLiteral(PMTS_TEST_DATA "/bus-capture.txt"), {}, {});
    ASSERT_TRUE(recording);
    for (int goes_on = 0; goes_on < 4; ++goes_on) {
        int asked = 0;
        const auto found = examined(*recording, [&](double) { return asked++ < goes_on; });
        EXPECT_THAT(found, FailedWith(core::ErrorKind::kCancelled)) << goes_on;
        EXPECT_EQ(asked, goes_on + 1);
    }
}

TEST(SampleRateTest, ARateIsReadWithItsUnit) {
    const auto rate = [](const char* text) { return sampleRateFrom(QString::fromLatin1(text)); };
    EXPECT_EQ(rate("1 MHz"), 1e6);
    EXPECT_EQ(rate("1,5 MHz"), 1.5e6);
    EXPECT_EQ(rate("1.5"), 1.5);
    EXPECT_EQ(rate(" 500kHz "), 5e5);
    EXPECT_EQ(rate("24 MS/s"), 24e6);
    EXPECT_EQ(rate("115200"), 115200.0);
    for (const char* const wrong : {"", " ", "fast", "0", "-5", "1 MHz or so", "1.2.3", "1e999"}) {
        EXPECT_EQ(rate(wrong), std::nullopt) << wrong;
    }
}

}  // namespace
}  // namespace pmts::app
