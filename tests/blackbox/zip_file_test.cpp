#include "pmts/blackbox/zip_file.hpp"

#include "support/child_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

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

TEST(ZipFileTest, AnEmptyArchiveIsOnlyItsEnd) { EXPECT_EQ(zipOf({}, kTime).size(), 22); }

}  // namespace
}  // namespace pmts::blackbox
