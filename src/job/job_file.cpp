#include "job_file.hpp"

#include "pmts/job/job.hpp"
#include "schema.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <unistd.h>

namespace pmts::job {
namespace {

using core::ErrorKind;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

tl::unexpected<core::Error> refused(const char* happened, const QString& path, const char* remedy,
                                    const QString& detail = {}) {
    return core::fail(ErrorKind::kFile, tr(happened).arg(QDir::toNativeSeparators(path)), tr(remedy), detail);
}

/// Nobody may write, as the permissions say: kept for the administrator too.
bool isReadOnly(const QFileInfo& info) {
    const QFile::Permissions any = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
    return !info.isWritable() || !(info.permissions() & any);
}

core::Result<void> checkFolder(const QString& path) {
    const QFileInfo folder(QFileInfo(path).absolutePath());
    if (!folder.isDir()) {
        return refused("The folder of %1 does not exist.", path, "Choose a folder that exists.");
    }
    if (isReadOnly(folder)) {
        return refused("The folder of %1 is read-only.", path,
                       "Choose a folder that you may write to: the job keeps two more files beside it while "
                       "it is open.");
    }
    return {};
}

/// What can be said from the first 100 bytes, before any library touches the file.
core::Result<void> checkHeader(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return refused("%1 cannot be read.", path, "Check who may read the file.", file.errorString());
    }
    const QByteArray header = file.read(100);
    if (header.isEmpty()) {
        return tl::unexpected(damaged(path, QStringLiteral("empty file")));
    }
    const bool is_sqlite = header.startsWith(QByteArrayLiteral("SQLite format 3\0"));
    const bool is_geopackage = header.mid(68, 4) == "GPKG";
    if (is_sqlite && header.size() == 100 && is_geopackage) {
        return {};
    }
    // All zero is what a crashed file system leaves of a file, not somebody else's format.
    if (header.count('\0') == header.size() || (is_sqlite && header.size() < 100)) {
        return tl::unexpected(damaged(path, QStringLiteral("no SQLite header")));
    }
    return refused("%1 is not a PMTS job.", path, "Choose a job file made by PMTS (.gpkg).",
                   QString::fromLatin1(header.left(16).toHex(' ')));
}

core::Result<void> checkSchema(const QString& path, GDALDataset& dataset) {
    const auto version = schemaVersion(dataset);
    if (!version) {
        return refused("%1 is a GeoPackage, but not a PMTS job.", path,
                       "Choose a job file made by PMTS, or create a new job.");
    }
    if (*version > Job::kSchemaVersion) {
        return refused(
            "%1 was written by a newer PMTS.", path, "Update this program to open it.",
            QStringLiteral("schema %1, this program knows %2").arg(*version).arg(Job::kSchemaVersion));
    }
    if (const QString missing = missingColumn(dataset);
        *version == Job::kSchemaVersion && !missing.isEmpty()) {
        return tl::unexpected(damaged(path, QStringLiteral("%1 is missing").arg(missing)));
    }
    return {};
}

/// Looks read-only: a file that is refused stays as it was. Pages left in the write-ahead log are seen.
core::Result<void> checkContents(const QString& path) {
    const GdalTrap trap;
    const Dataset dataset = openGeoPackage(path, GDAL_OF_READONLY);
    if (!dataset) {
        return tl::unexpected(damaged(path, trap.said()));
    }
    const QString verdict = queryText(*dataset, QStringLiteral("PRAGMA quick_check(1)"));
    if (verdict != u"ok") {
        return tl::unexpected(damaged(path, verdict.isEmpty() ? trap.said() : verdict));
    }
    return checkSchema(path, *dataset);
}

core::Result<Dataset> openChecked(const QString& path) {
    const GdalTrap trap;
    Dataset dataset = openGeoPackage(path, GDAL_OF_UPDATE);
    if (!dataset) {
        return tl::unexpected(fileError(path, trap.said()));
    }
    const int version = schemaVersion(*dataset).value_or(Job::kSchemaVersion);
    if (version < Job::kSchemaVersion && !migrate(*dataset, version)) {
        return tl::unexpected(fileError(path, trap.said()));
    }
    if (!repairContents(*dataset)) {
        return tl::unexpected(fileError(path, trap.said()));
    }
    dataset.reset();  // the driver keeps counts and extent it read at opening
    dataset = openGeoPackage(path, GDAL_OF_UPDATE);
    if (!dataset || !missingColumn(*dataset).isEmpty()) {
        return tl::unexpected(fileError(path, trap.said()));
    }
    return dataset;
}

bool buildFile(const QString& path) {
    registerDrivers();
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    Dataset dataset(driver->Create(path.toUtf8().constData(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset || !createTables(*dataset)) {
        return false;
    }
    dataset.reset();  // the spatial index is written on closing
    dataset = openGeoPackage(path, GDAL_OF_UPDATE);
    return dataset && finishTables(*dataset);
}

void removeFileAndLogs(const QString& path) {
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
        QFile::remove(path + QLatin1String(ending));
    }
}

/// The new name survives a power cut only when the folder itself is on the disk.
void syncFolder(const QString& path) {
    const int folder =
        ::open(QFile::encodeName(QFileInfo(path).absolutePath()).constData(), O_RDONLY | O_CLOEXEC);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
}

}  // namespace

core::Result<JobFile> createJobFile(const QString& path) {
    PMTS_TRY(checkFolder(path));
    auto lock = JobLock::take(path);
    if (!lock) {
        return tl::unexpected(lock.error());
    }
    if (QFileInfo::exists(path)) {
        return refused("%1 exists already.", path, "Open it, or choose another name.");
    }
    const QString unfinished = path + QStringLiteral(".creating.gpkg");
    removeFileAndLogs(unfinished);
    const GdalTrap trap;
    if (!buildFile(unfinished) || !QFile::rename(unfinished, path)) {
        removeFileAndLogs(unfinished);
        return tl::unexpected(fileError(path, trap.said()));
    }
    syncFolder(path);
    auto dataset = openChecked(path);
    if (!dataset) {
        return tl::unexpected(dataset.error());
    }
    return JobFile{std::move(*lock), std::move(*dataset)};
}

core::Result<JobFile> openJobFile(const QString& path) {
    const QFileInfo info(path);
    if (!info.isFile()) {
        return refused("There is no job file %1.", path,
                       "Choose a job file made by PMTS, or create a new job.");
    }
    if (isReadOnly(info)) {
        return refused("%1 is read-only.", path, "Allow writing to the file, or copy it and open the copy.");
    }
    PMTS_TRY(checkFolder(path));
    auto lock = JobLock::take(path);
    if (!lock) {
        return tl::unexpected(lock.error());
    }
    PMTS_TRY(checkHeader(path));
    PMTS_TRY(checkContents(path));
    auto dataset = openChecked(path);
    if (!dataset) {
        return tl::unexpected(dataset.error());
    }
    return JobFile{std::move(*lock), std::move(*dataset)};
}

}  // namespace pmts::job
