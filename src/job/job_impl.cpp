#include "job_impl.hpp"

#include "pmts/core/logging.hpp"
#include "rows.hpp"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <sys/stat.h>

namespace pmts::job {
namespace {

using core::ErrorKind;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

std::optional<FileIdentity> identityOf(const QString& path) {
    struct stat status {};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0) {
        return std::nullopt;
    }
    return FileIdentity{status.st_dev, status.st_ino};
}

/// Rolls back unless it was committed.
class Transaction {
public:
    explicit Transaction(GDALDataset& dataset)
        : dataset_(dataset), open_(dataset.StartTransaction() == OGRERR_NONE) {}
    ~Transaction() {
        if (open_) {
            dataset_.RollbackTransaction();
        }
    }
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    [[nodiscard]] bool isOpen() const { return open_; }
    /// On failure SQLite has rolled back by itself, and the driver with it.
    [[nodiscard]] bool commit() {
        return std::exchange(open_, false) && dataset_.CommitTransaction() == OGRERR_NONE;
    }

private:
    GDALDataset& dataset_;
    bool open_;
};

}  // namespace

tl::unexpected<core::Error> unknownRow(const char* what, qint64 row_id) {
    return core::fail(ErrorKind::kBadInput,
                      tr("There is no %1 number %2 in the job.").arg(QLatin1String(what)).arg(row_id));
}

Job::Impl::Impl(QString job_path, JobFile job_file)
    : path(std::move(job_path)), file(std::move(job_file)), identity(identityOf(path)) {
    const GdalTrap trap;
    if (layer(kPoints).GetExtent(&extent, TRUE) != OGRERR_NONE) {
        extent = OGREnvelope();  // no point yet
    }
    for (const auto& row : layer(kStations)) {
        station_rows[textOf(*row, "name")] = row->GetFID();
    }
    for (const auto& row : layer(kMeta)) {
        meta_rows[textOf(*row, "key")] = {row->GetFID(), textOf(*row, "value")};
    }
}

Job::Impl::~Impl() {
    const GdalTrap trap;
    file.dataset.reset();
    // The driver loses count of the rows when a transaction was taken back.
    if (const auto again = some_failed ? openGeoPackage(path, GDAL_OF_UPDATE) : Dataset(); again) {
        (void)repairContents(*again);
    }
}

core::Result<void> Job::Impl::durably(const std::function<bool()>& write) {
    const GdalTrap trap;
    if (identityOf(path) != identity) {
        return core::fail(ErrorKind::kFile,
                          tr("The job file %1 was moved or deleted while it was open.").arg(path),
                          tr("Put it back, or close the job and open it where it is now."));
    }
    grown_extent = extent;
    if (!isCommitted(write)) {
        some_failed = true;
        const QString said = trap.said();
        qCWarning(core::logJob).noquote() << path << said;
        openAfresh();
        return tl::unexpected(fileError(path, said));
    }
    extent = grown_extent;
    return {};
}

bool Job::Impl::isCommitted(const std::function<bool()>& write) {
    Transaction transaction(*file.dataset);
    return transaction.isOpen() && write() && transaction.commit();
}

/// After a refused commit the driver believes triggers gone that SQLite has put back: every later write would
/// fail.
void Job::Impl::openAfresh() {
    if (Dataset again = openGeoPackage(path, GDAL_OF_UPDATE)) {
        file.dataset = std::move(again);
    }
}

bool Job::Impl::removeRows(const char* table, const std::vector<qint64>& row_ids) {
    OGRLayer& rows = layer(table);
    return std::all_of(row_ids.begin(), row_ids.end(),
                       [&](qint64 row_id) { return rows.DeleteFeature(row_id) == OGRERR_NONE; });
}

bool Job::Impl::growExtent(const survey::Coordinates& at) {
    const OGREnvelope before = grown_extent;
    grown_extent.Merge(at.e_m, at.n_m);
    if (grown_extent == before) {
        return true;
    }
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    return runSql(*file.dataset,
                  QStringLiteral("UPDATE gpkg_contents SET min_x = %1, min_y = %2, max_x = %3, "
                                 "max_y = %4 WHERE table_name = 'points'")
                      .arg(number(grown_extent.MinX), number(grown_extent.MinY), number(grown_extent.MaxX),
                           number(grown_extent.MaxY)));
}

bool Job::Impl::writeCoordinates(const std::vector<survey::Point>& points) {
    OGRLayer& rows = layer(kPoints);
    return std::all_of(points.begin(), points.end(), [&](const survey::Point& point) {
        const OGRFeatureUniquePtr row(rows.GetFeature(point.row_id));
        if (!row) {
            return false;
        }
        fillCoordinates(*row, point);
        return rows.SetFeature(row.get()) == OGRERR_NONE &&
               (!point.hasCoordinates() || growExtent(point.coordinates));
    });
}

std::optional<qint64> Job::Impl::stationRow(const QString& name) const {
    const auto found = station_rows.find(name);
    return found == station_rows.end() ? std::nullopt : std::optional(found.value());
}

std::unordered_map<qint64, survey::Observation> Job::Impl::observations() const {
    std::unordered_map<qint64, survey::Observation> found;
    for (const auto& row : layer(kObservations)) {
        found.emplace(row->GetFID(), observationOf(*row));
    }
    return found;
}

}  // namespace pmts::job
