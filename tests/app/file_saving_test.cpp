#include "pmts/app/desk/file_saving.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include <atomic>

namespace pmts::app {
namespace {

class FileSavingTest : public testing::Test {
protected:
    static QByteArray bytesOf(const QString& written) {
        QFile file(written);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("a.csv"));
    FileSaving saving{Threading::kCallersThread};
    QSignalSpy ended{&saving, &FileSaving::ended};
};

TEST_F(FileSavingTest, AFileIsMadeAndWrittenAndItsEndIsTold) {
    QSignalSpy shown(&saving, &FileSaving::transferChanged);
    ASSERT_TRUE(saving.save(path, [](const FileSaving::Progress&) { return QByteArray("a,b\n"); }).has_value());
    EXPECT_TRUE(saving.isBusy());
    QCoreApplication::processEvents();

    EXPECT_EQ(bytesOf(path), "a,b\n");
    EXPECT_FALSE(saving.isBusy());
    ASSERT_EQ(ended.count(), 1);
    EXPECT_TRUE(ended[0][0].toString().endsWith(QStringLiteral("is written.")));
    EXPECT_TRUE(shown.front()[0].value<TransferView>().busy);
    EXPECT_FALSE(shown.back()[0].value<TransferView>().busy);
}

TEST_F(FileSavingTest, ACancelledFileIsNotWrittenAndTheOldOneStays) {
    {
        QFile old(path);
        ASSERT_TRUE(old.open(QIODevice::WriteOnly));
        old.write("old");
    }
    ASSERT_TRUE(saving.save(path, [this](const FileSaving::Progress& progress) {
        EXPECT_TRUE(progress(0.1));
        saving.cancel();
        EXPECT_FALSE(progress(0.2));
        return QByteArray("half");
    }).has_value());
    QCoreApplication::processEvents();

    EXPECT_EQ(bytesOf(path), "old");
    ASSERT_EQ(ended.count(), 1);
    EXPECT_TRUE(ended[0][0].toString().startsWith(QStringLiteral("Cancelled"))) << ended[0][0].toString().toStdString();
}

TEST_F(FileSavingTest, OneFileAtATimeAndTheReasonWhereItCannotBeWritten) {
    ASSERT_TRUE(saving.save(QStringLiteral("/proc/none/a.csv"), [](const FileSaving::Progress&) { return QByteArray("a"); }).has_value());
    const auto second = saving.save(path, [](const FileSaving::Progress&) { return QByteArray("b"); });
    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().kind, core::ErrorKind::kRefused);
    QCoreApplication::processEvents();

    ASSERT_EQ(ended.count(), 1);
    EXPECT_TRUE(ended[0][0].toString().contains(QStringLiteral("a.csv")));
    EXPECT_FALSE(QFile::exists(path));
    EXPECT_TRUE(saving.save(path, [](const FileSaving::Progress&) { return QByteArray("b"); }).has_value());
    QCoreApplication::processEvents();
    EXPECT_EQ(bytesOf(path), "b");
}

TEST(FileSavingInThePoolTest, WhoLeavesCancelsAndWaits) {
    const QTemporaryDir folder;
    std::atomic<bool> was_told{false};
    {
        FileSaving saving;
        ASSERT_TRUE(saving.save(folder.filePath(QStringLiteral("a")), [&was_told](const FileSaving::Progress& progress) {
            while (progress(0.5)) {
            }
            was_told = true;
            return QByteArray("late");
        }).has_value());
    }
    EXPECT_TRUE(was_told);
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("a"))));
}

}  // namespace
}  // namespace pmts::app
