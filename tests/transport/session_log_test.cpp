#include "pmts/transport/session_log.hpp"

#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>

#include <random>

namespace pmts::transport {
namespace {

using namespace std::chrono_literals;
using core::ErrorKind;
using test::FailedWith;
using testing::ElementsAre;

class SessionLogTest : public testing::Test {
protected:
    QString write(const QByteArray& text) {
        QFile file(folder.filePath(QStringLiteral("session.log")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }

    QTemporaryDir folder;
};

TEST_F(SessionLogTest, LinesAreReadableByPeople) {
    EXPECT_EQ(sessionLine({0us, Direction::kSent, "RG\r"}), "       0.000 > RG\\r\n");
    EXPECT_EQ(sessionLine({52083us, Direction::kReceived, "0\r\n>"}), "      52.083 < 0\\r\\n>\n");
    EXPECT_EQ(sessionLine({72h, Direction::kLost, "The cable."}), "259200000.000 ! The cable.\n");
}

TEST_F(SessionLogTest, EveryByteComesBack) {
    std::mt19937 random(11);
    for (int i = 0; i < 200; ++i) {
        std::string bytes;
        for (unsigned n = random() % 40; n > 0; --n) {
            bytes += static_cast<char>(random() % 256);
        }
        EXPECT_EQ(bytesFromEscaped(escapedBytes(bytes)), bytes);
    }
    EXPECT_EQ(escapedBytes("A \\ B "), "A \\\\ B\\x20");
    EXPECT_EQ(bytesFromEscaped("\\q"), std::nullopt);
    EXPECT_EQ(bytesFromEscaped("\\x4"), std::nullopt);
}

TEST_F(SessionLogTest, HandWrittenLogIsRead) {
    const auto sessions =
        readSessionLog(write("# PMTS session log 1\n"
                             "@ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1\n"
                             "0.000 > RG\\r\n"
                             "52.083 < 0\\r\\n>\n"));
    ASSERT_TRUE(sessions.has_value());
    ASSERT_EQ(sessions->size(), 1U);
    EXPECT_EQ(sessions->front().link, QStringLiteral("/dev/ttyUSB0 at 9600 8N1"));
    EXPECT_EQ(sessions->front().began_utc, QDateTime(QDate(2026, 6, 1), QTime(6, 0), Qt::UTC));
    EXPECT_THAT(sessions->front().events, ElementsAre(SessionEvent{0us, Direction::kSent, "RG\r"},
                                                      SessionEvent{52083us, Direction::kReceived, "0\r\n>"}));
}

TEST_F(SessionLogTest, HalfWrittenAndForeignLinesArePassedOver) {
    const auto sessions =
        readSessionLog(write("@ 2026-06-01T06:00:00.000Z x\n"
                             "hello\n"
                             "1.0 ? RG\\r\n"
                             "2.0 > TG\\r\n"
                             "3.0 > WG,26=9"));
    ASSERT_TRUE(sessions.has_value());
    EXPECT_THAT(sessions->front().events, ElementsAre(SessionEvent{2ms, Direction::kSent, "TG\r"}));
}

TEST_F(SessionLogTest, MissingOrForeignFileIsRefused) {
    EXPECT_THAT(readSessionLog(folder.filePath(QStringLiteral("none.log"))), FailedWith(ErrorKind::kFile));
    EXPECT_THAT(readSessionLog(write("5=1\r\n7=75.0000\r\n")), FailedWith(ErrorKind::kFile));
}

}  // namespace
}  // namespace pmts::transport
