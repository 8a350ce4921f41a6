#include "pmts/app/desk/log_model.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/core/virtual_clock.hpp"

#include <QTemporaryDir>
#include <gmock/gmock.h>

#include <thread>

namespace pmts::app {
namespace {

QString textAt(const LogModel& log, int row, int column = LogModel::kText) {
    return log.data(log.index(row, column), Qt::DisplayRole).toString();
}

TEST(LogModelTest, MessagesOfTheProgramAppearWithTheirCategory) {
    LogModel log{QString()};
    log.install();
    qCWarning(core::logApp) << "the wind blows";
    core::deliverQueuedEvents();
    ASSERT_EQ(log.rowCount(), 1);
    EXPECT_EQ(textAt(log, 0), QStringLiteral("the wind blows"));
    EXPECT_EQ(textAt(log, 0, LogModel::kCategory), QStringLiteral("pmts.app"));
}

TEST(LogModelTest, LinesOfOtherThreadsAreTakenOver) {
    LogModel log{QString()};
    std::thread([&log] {
        for (int i = 0; i < 100; ++i) {
            log.appendWire(QString::number(i));
        }
    }).join();
    core::deliverQueuedEvents();
    ASSERT_EQ(log.rowCount(), 100);
    EXPECT_EQ(textAt(log, 99), QStringLiteral("99"));
}

TEST(LogModelTest, OldestLinesMakeRoomForNewOnes) {
    LogModel log{QString()};
    for (int burst = 0; burst < 3; ++burst) {
        for (int i = 0; i < 3000; ++i) {
            log.appendWire(QString::number(burst * 3000 + i));
        }
        core::deliverQueuedEvents();
    }
    EXPECT_EQ(log.rowCount(), LogModel::kCapacity);
    EXPECT_EQ(textAt(log, log.rowCount() - 1), QStringLiteral("8999"));
    EXPECT_EQ(textAt(log, 0), QStringLiteral("4000"));
}

TEST(LogModelTest, BurstLargerThanTheRingKeepsTheNewest) {
    LogModel log{QString()};
    for (int i = 0; i < LogModel::kCapacity + 10; ++i) {
        log.appendWire(QString::number(i));
    }
    core::deliverQueuedEvents();
    EXPECT_EQ(log.rowCount(), LogModel::kCapacity);
    EXPECT_EQ(textAt(log, 0), QStringLiteral("10"));
}

TEST(LogModelTest, LineIsInTheFileBeforeAnythingElseHappens) {
    const QTemporaryDir folder;
    LogModel log(folder.filePath(QStringLiteral("log/pmts.log")));
    log.appendWire(QStringLiteral("RG\\r -> 0"));
    QFile file(log.filePath());  // not closed, not destroyed: as after a crash
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_THAT(file.readAll().toStdString(), testing::HasSubstr("wire RG\\r -> 0\n"));
}

TEST(LogModelTest, LargeFileOfEarlierDaysIsPutAside) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pmts.log"));
    QFile old(path);
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    old.resize(6 * 1024 * 1024);
    old.close();
    LogModel log(path);
    EXPECT_LT(QFile(path).size(), 1000);
    EXPECT_TRUE(QFile::exists(path + QStringLiteral(".1")));
}

}  // namespace
}  // namespace pmts::app
