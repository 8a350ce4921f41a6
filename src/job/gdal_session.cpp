#include "gdal_session.hpp"

#include <QCoreApplication>
#include <QDir>
#include <cpl_conv.h>
#include <ogrsf_frmts.h>

#include <mutex>

namespace pmts::job {
namespace {

/// How long one statement waits for another program's transaction; the driver may try four of them in turn.
constexpr int kPatienceMs = 400;

void collectInto(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
    if (severity >= CE_Warning) {
        static_cast<GdalTrap*>(CPLGetErrorHandlerUserData())->collect(message);
    }
}

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

/// Both settings are read by the driver when it opens the database; they hold for this thread only.
class DurableSettings {
public:
    DurableSettings()
        : synchronous_("OGR_SQLITE_SYNCHRONOUS", "FULL", false),
          journal_("OGR_SQLITE_JOURNAL", "WAL", false) {}

private:
    CPLConfigOptionSetter synchronous_;
    CPLConfigOptionSetter journal_;
};

core::Error fileTrouble(const QString& happened, const QString& remedy, const QString& path,
                        const QString& said) {
    return {core::ErrorKind::kFile, happened.arg(QDir::toNativeSeparators(path)), remedy, std::nullopt,
            path + QStringLiteral(": ") + said};
}

}  // namespace

GdalTrap::GdalTrap() { CPLPushErrorHandlerEx(collectInto, this); }

GdalTrap::~GdalTrap() { CPLPopErrorHandler(); }

void GdalTrap::collect(const char* message) {
    if (!said_.isEmpty()) {
        said_ += QStringLiteral("; ");
    }
    said_ += QString::fromUtf8(message);
}

core::Error damaged(const QString& path, const QString& detail) {
    return fileTrouble(
        tr("The job file %1 is damaged."),
        tr("Leave it as it is and open the last copy of it; the file may still be rescued with the "
           "recovery command of sqlite3."),
        path, detail);
}

core::Error fileError(const QString& path, const QString& said) {
    const auto holds = [&](const char* words) {
        return said.contains(QLatin1String(words), Qt::CaseInsensitive);
    };
    if (holds("disk is full")) {
        return fileTrouble(tr("The disk is full: %1 was not changed."),
                           tr("Make room on the disk and repeat; everything recorded before is safe."), path,
                           said);
    }
    if (holds("disk i/o error")) {
        return fileTrouble(
            tr("%1 cannot be written: the disk is full, or the drive is gone."),
            tr("Make room or plug the drive in again and repeat; everything recorded before is safe."), path,
            said);
    }
    if (holds("locked") || holds("busy")) {
        return fileTrouble(tr("Another program is writing into %1."),
                           tr("Save or end its edit session (in QGIS: toggle editing) and repeat."), path,
                           said);
    }
    if (holds("readonly") || holds("read-only")) {
        return fileTrouble(tr("%1 is read-only."),
                           tr("Allow writing to the file and its folder, or copy it."), path, said);
    }
    if (holds("malformed") || holds("not a database")) {
        return damaged(path, said);
    }
    return fileTrouble(tr("%1 could not be changed."),
                       tr("Repeat; if it stays so, close the job and open it again."), path, said);
}

void CloseDataset::operator()(GDALDataset* dataset) const { GDALClose(dataset); }

void registerDrivers() {
    static std::once_flag once;
    std::call_once(once, [] {
        RegisterOGRGeoPackage();
        RegisterOGRCSV();
        RegisterOGRGeoJSON();
        RegisterOGRDXF();
    });
}

Dataset openGeoPackage(const QString& path, unsigned access) {
    registerDrivers();
    const DurableSettings settings;
    const char* const drivers[] = {"GPKG", nullptr};
    Dataset dataset(static_cast<GDALDataset*>(
        GDALOpenEx(path.toUtf8().constData(), GDAL_OF_VECTOR | access, drivers, nullptr, nullptr)));
    if (dataset) {
        (void)queryText(*dataset, QStringLiteral("PRAGMA busy_timeout = %1").arg(kPatienceMs));
    }
    return dataset;
}

QString queryText(GDALDataset& dataset, const QString& sql) {
    OGRLayer* const rows = dataset.ExecuteSQL(sql.toUtf8().constData(), nullptr, nullptr);
    if (rows == nullptr) {
        return {};
    }
    const OGRFeatureUniquePtr first(rows->GetNextFeature());
    const bool found = first && first->GetFieldCount() > 0 && first->IsFieldSetAndNotNull(0);
    QString text = found ? QString::fromUtf8(first->GetFieldAsString(0)) : QString();
    dataset.ReleaseResultSet(rows);
    return text;
}

bool runSql(GDALDataset& dataset, const QString& sql) {
    CPLErrorReset();
    OGRLayer* const rows = dataset.ExecuteSQL(sql.toUtf8().constData(), nullptr, nullptr);
    if (rows != nullptr) {
        dataset.ReleaseResultSet(rows);
    }
    return CPLGetLastErrorType() < CE_Failure;
}

}  // namespace pmts::job
