#include "pmts/blackbox/zip_file.hpp"

#include "support/child_program.hpp"

#include <QBuffer>
#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include <algorithm>

namespace pmts::blackbox {
namespace {

const QDateTime kTime(QDate(2026, 6, 1), QTime(12, 34, 56), Qt::UTC);

TEST(ZipFileTest, AnotherProgramReadsTheArchive) {
    QTemporaryDir folder;
    QByteArray bytes(70000, 'x');
    bytes[100] = '\0';
    const QByteArray archive = zipOf({{QStringLiteral("a.txt"), "hello\n"}, {QStringLiteral("süd/b.bin"), bytes}}, kTime);
    QFile file(folder.filePath(QStringLiteral("a.zip")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(archive);
    file.close();

    QProcess python;
    python.start(QStringLiteral("/usr/bin/python3"),
                 {QStringLiteral("-X"), QStringLiteral("utf8"), QStringLiteral("-c"),
                  QStringLiteral("import sys, zipfile\n"
                                 "z = zipfile.ZipFile(sys.argv[1])\n"
                                 "print(z.testzip(), z.namelist(), z.read('a.txt'), len(z.read('süd/b.bin')), "
                                 "z.getinfo('a.txt').date_time)"),
                  file.fileName()});
    test::awaitEnd(python);
    EXPECT_EQ(QString::fromUtf8(python.readAllStandardOutput()).trimmed(),
              QStringLiteral("None ['a.txt', 'süd/b.bin'] b'hello\\n' 70000 (2026, 6, 1, 12, 34, 56)"));
}

TEST(ZipFileTest, WritingTellsHowFarItIsAndEndsWhenToldTo) {
    const std::vector<ZipEntry> entries{{QStringLiteral("a.bin"), QByteArray(5000000, 'x')}};
    QBuffer all, ended;
    all.open(QIODevice::WriteOnly);
    ended.open(QIODevice::WriteOnly);
    std::vector<double> done;
    EXPECT_TRUE(writeZip(all, entries, kTime, [&done](double part) { done.push_back(part); return true; }));
    EXPECT_EQ(all.data(), zipOf(entries, kTime));
    EXPECT_GE(done.size(), 5U);
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
    EXPECT_FALSE(writeZip(ended, entries, kTime, [](double part) { return part < 0.3; }));
    EXPECT_LT(ended.data().size(), 3000000);
}

TEST(ZipFileTest, AnEmptyArchiveIsOnlyItsEnd) { EXPECT_EQ(zipOf({}, kTime).size(), 22); }

}  // namespace
}  // namespace pmts::blackbox
