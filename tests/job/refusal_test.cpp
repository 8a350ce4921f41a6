#include "job_support.hpp"

#include <QDir>
#include <QFile>

namespace pmts::job {
namespace {

using core::ErrorKind;
using test::FailedWith;

/// Refused as kFile, with a sentence on what happened that holds `words`, and one on what to do.
MATCHER_P(RefusedSaying, words, "") {
    if (arg.has_value() || arg.error().kind != ErrorKind::kFile) {
        return false;
    }
    *result_listener << arg.error().sentence().toStdString() << " [" << arg.error().detail.toStdString()
                     << ']';
    return arg.error().happened.contains(QLatin1String(words)) && !arg.error().remedy.isEmpty();
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

TEST_F(JobTest, AMissingFileIsNotCreatedByOpening) {
    EXPECT_THAT(Job::open(path), RefusedSaying("no job file"));
    EXPECT_THAT(Job::open(folder.path()), RefusedSaying("no job file"));
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(JobTest, AnExistingFileIsNotOverwritten) {
    write(path, "the notes of somebody");
    EXPECT_THAT(Job::create(path), RefusedSaying("exists already"));
    EXPECT_EQ(contents(path), QByteArray("the notes of somebody"));
}

TEST_F(JobTest, ATextFileIsForeign) {
    write(path, "id,e,n,h\n1,2,3,4\n");
    EXPECT_THAT(Job::open(path), RefusedSaying("is not a PMTS job"));
    EXPECT_EQ(contents(path), QByteArray("id,e,n,h\n1,2,3,4\n"));
}

TEST_F(JobTest, AGeoPackageOfAnotherProgramIsForeignAndStaysAsItWas) {
    GDALAllRegister();
    GDALDataset* const other = GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
        path.toUtf8().constData(), 0, 0, 0, GDT_Unknown, nullptr);
    other->CreateLayer("points", nullptr, wkbPoint, nullptr);
    GDALClose(other);
    const QByteArray before = contents(path);

    EXPECT_THAT(Job::open(path), RefusedSaying("not a PMTS job"));

    EXPECT_EQ(contents(path), before);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

TEST_F(JobTest, AJobOfANewerProgramIsRefusedAndStaysAsItWas) {
    createWith(1);
    EXPECT_EQ(OtherProgram(path, GDAL_OF_UPDATE)
                  .refusal("UPDATE meta SET value = '99' WHERE key = 'schema_version'"),
              QString());
    const QByteArray before = contents(path);

    EXPECT_THAT(Job::open(path), RefusedSaying("newer PMTS"));

    EXPECT_EQ(contents(path), before);
}

TEST_F(JobTest, AJobWhoseColumnAnotherProgramRemovedIsRefused) {
    createWith(1);
    EXPECT_EQ(OtherProgram(path, GDAL_OF_UPDATE).refusal("ALTER TABLE points DROP COLUMN remark"), QString());
    const auto outcome = Job::open(path);
    ASSERT_THAT(outcome, RefusedSaying("damaged"));
    EXPECT_TRUE(outcome.error().detail.contains(QStringLiteral("points.remark")));
}

TEST_F(JobTest, AReadOnlyFileIsRefused) {
    createWith(1);
    ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::ReadUser));
    EXPECT_THAT(Job::open(path), RefusedSaying("read-only"));
}

TEST_F(JobTest, AReadOnlyFolderIsRefused) {
    createWith(1);
    const QString closed_path = folder.filePath(QStringLiteral("other.gpkg"));
    ASSERT_TRUE(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::ExeOwner));
    EXPECT_THAT(Job::open(path), RefusedSaying("read-only"));
    EXPECT_THAT(Job::create(closed_path), RefusedSaying("read-only"));
    ASSERT_TRUE(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
}

TEST_F(JobTest, AFolderThatDoesNotExistIsRefused) {
    EXPECT_THAT(Job::create(folder.filePath(QStringLiteral("nowhere/a.gpkg"))),
                RefusedSaying("does not exist"));
}

TEST_F(JobTest, ASecondWriterIsRefusedUntilTheFirstCloses) {
    auto first = created();
    EXPECT_THAT(Job::open(path), RefusedSaying("opened in another PMTS"));
    const QString link = folder.filePath(QStringLiteral("link.gpkg"));
    ASSERT_TRUE(QFile::link(path, link));
    EXPECT_THAT(Job::open(link), RefusedSaying("opened in another PMTS"));
    EXPECT_TRUE(first->record(shotPoint(1)).has_value());
    first.reset();
    EXPECT_TRUE(Job::open(path).has_value());
}

TEST_F(JobTest, AJobFileDeletedWhileOpenTakesNoMoreRecords) {
    const auto job = created();
    ASSERT_TRUE(QFile::rename(path, path + QStringLiteral(".away")));
    EXPECT_THAT(job->record(shotPoint(1)), RefusedSaying("moved or deleted"));
    ASSERT_TRUE(QFile::rename(path + QStringLiteral(".away"), path));
    EXPECT_TRUE(job->record(shotPoint(1)).has_value());
}

TEST_F(JobTest, AProgramThatHoldsTheFileForWritingIsNamedAsTheReason) {
    auto job = created();
    ASSERT_TRUE(job->record(shotPoint(1)).has_value());
    {
        const OtherProgram qgis(path, GDAL_OF_UPDATE);
        ASSERT_EQ(qgis.refusal("BEGIN IMMEDIATE"), QString());
        EXPECT_THAT(job->record(shotPoint(2)), RefusedSaying("Another program is writing"));
    }
    EXPECT_TRUE(job->record(shotPoint(2)).has_value());
    EXPECT_EQ(job->points()->size(), 2U);
    job.reset();
    EXPECT_EQ(
        OtherProgram(path).value("SELECT feature_count FROM gpkg_ogr_contents WHERE table_name = 'points'"),
        QStringLiteral("2"));
}

}  // namespace
}  // namespace pmts::job
