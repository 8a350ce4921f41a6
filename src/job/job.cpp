#include "pmts/job/job.hpp"

#include "job_file.hpp"
#include "pmts/core/logging.hpp"
#include "rows.hpp"
#include "schema.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <sys/stat.h>
#include <unordered_map>

namespace pmts::job {
namespace {

using core::ErrorKind;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;

    [[nodiscard]] bool operator==(const FileIdentity&) const = default;
};

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

bool isFinite(const survey::Point& point) {
    const auto& c = point.coordinates;
    const auto& o = point.observation;
    const double coordinates = c.e_m + c.n_m + c.h_m + c.sigma_e_m + c.sigma_n_m + c.sigma_h_m;
    return std::isfinite(o.pointing.ha.gon() + o.pointing.va.gon() + o.slope_distance_m.value_or(0.0) +
                         o.target_height_m) &&
           (!point.hasCoordinates() || std::isfinite(coordinates));
}

tl::unexpected<core::Error> notANumber(const QString& id) {
    return core::fail(ErrorKind::kUndefined,
                      tr("Point %1 was not recorded: its values are not numbers.").arg(id),
                      tr("Measure it again."));
}

tl::unexpected<core::Error> unknownRow(const char* what, qint64 row_id) {
    return core::fail(ErrorKind::kBadInput,
                      tr("There is no %1 number %2 in the job.").arg(QLatin1String(what)).arg(row_id));
}

}  // namespace

class Job::Impl {
public:
    Impl(QString job_path, JobFile job_file)
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

    ~Impl() {
        const GdalTrap trap;
        file.dataset.reset();
        // The driver loses count of the rows when a transaction was taken back.
        if (const auto again = some_failed ? openGeoPackage(path, GDAL_OF_UPDATE) : Dataset(); again) {
            (void)repairContents(*again);
        }
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    [[nodiscard]] OGRLayer& layer(const char* name) const { return *file.dataset->GetLayerByName(name); }

    /// Everything `write` does becomes durable together, or not at all.
    template <class Write>
    core::Result<void> durably(Write write) {
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

    template <class Write>
    bool isCommitted(Write& write) {
        Transaction transaction(*file.dataset);
        return transaction.isOpen() && write() && transaction.commit();
    }

    /// After a refused commit the driver believes triggers gone that SQLite has put back: every later write would fail.
    void openAfresh() {
        if (Dataset again = openGeoPackage(path, GDAL_OF_UPDATE)) {
            file.dataset = std::move(again);
        }
    }

    /// Adds a row; its number, or nothing when the table did not take it.
    template <class Fill>
    std::optional<qint64> addRow(const char* table, Fill fill) {
        OGRLayer& rows = layer(table);
        OGRFeature row(rows.GetLayerDefn());
        fill(row);
        return rows.CreateFeature(&row) == OGRERR_NONE ? std::optional<qint64>(row.GetFID()) : std::nullopt;
    }

    /// Other programs read the extent from the contents table: it grows in the transaction that needs it.
    bool growExtent(const survey::Coordinates& at) {
        const OGREnvelope before = grown_extent;
        grown_extent.Merge(at.e_m, at.n_m);
        if (grown_extent == before) {
            return true;
        }
        const auto number = [](double value) { return QString::number(value, 'g', 17); };
        return runSql(*file.dataset,
                      QStringLiteral("UPDATE gpkg_contents SET min_x = %1, min_y = %2, max_x = %3, "
                                     "max_y = %4 WHERE table_name = 'points'")
                          .arg(number(grown_extent.MinX), number(grown_extent.MinY),
                               number(grown_extent.MaxX), number(grown_extent.MaxY)));
    }

    [[nodiscard]] std::optional<qint64> stationRow(const QString& name) const {
        const auto found = station_rows.find(name);
        return found == station_rows.end() ? std::nullopt : std::optional(found.value());
    }

    [[nodiscard]] std::unordered_map<qint64, survey::Observation> observations() const {
        std::unordered_map<qint64, survey::Observation> found;
        for (const auto& row : layer(kObservations)) {
            found.emplace(row->GetFID(), observationOf(*row));
        }
        return found;
    }

    struct MetaRow {
        qint64 row_id = 0;
        QString value;
    };

    QString path;
    JobFile file;
    std::optional<FileIdentity> identity;
    OGREnvelope extent;                   ///< as the contents table has it
    OGREnvelope grown_extent;             ///< the same after the transaction under way
    QHash<QString, qint64> station_rows;  ///< the newest of each name
    QHash<QString, MetaRow> meta_rows;
    bool some_failed = false;
};

Job::Job(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Job::~Job() = default;

core::Result<std::unique_ptr<Job>> Job::create(const QString& path) {
    auto file = createJobFile(path);
    if (!file) {
        return tl::unexpected(file.error());
    }
    return std::unique_ptr<Job>(new Job(std::make_unique<Impl>(path, std::move(*file))));
}

core::Result<std::unique_ptr<Job>> Job::open(const QString& path) {
    auto file = openJobFile(path);
    if (!file) {
        return tl::unexpected(file.error());
    }
    return std::unique_ptr<Job>(new Job(std::make_unique<Impl>(path, std::move(*file))));
}

QString Job::path() const { return impl_->path; }

QString Job::name() const { return QFileInfo(impl_->path).completeBaseName(); }

core::Result<survey::Point> Job::record(const survey::Point& point) {
    if (!isFinite(point)) {
        return notANumber(point.id);
    }
    survey::Point recorded = point;
    PMTS_TRY(impl_->durably([&] {
        const auto observation = impl_->addRow(kObservations, [&](OGRFeature& row) {
            fillObservation(row, point.observation, impl_->stationRow(point.station_name));
        });
        if (!observation || (point.hasCoordinates() && !impl_->growExtent(point.coordinates))) {
            return false;
        }
        const auto row_id = impl_->addRow(kPoints, [&](OGRFeature& row) {
            fillPoint(row, point);
            row.SetField("observation", static_cast<GIntBig>(*observation));
        });
        recorded.row_id = row_id.value_or(0);
        return row_id.has_value();
    }));
    return recorded;
}

core::Result<void> Job::update(const survey::Point& point) {
    OGRLayer& rows = impl_->layer(kPoints);
    const OGRFeatureUniquePtr row(rows.GetFeature(point.row_id));
    if (!row) {
        return unknownRow("point", point.row_id);
    }
    fillNames(*row, point);
    return impl_->durably([&] { return rows.SetFeature(row.get()) == OGRERR_NONE; });
}

core::Result<void> Job::updateCoordinates(const std::vector<survey::Point>& points) {
    OGRLayer& rows = impl_->layer(kPoints);
    std::vector<OGRFeatureUniquePtr> changed;
    for (const auto& point : points) {
        changed.emplace_back(rows.GetFeature(point.row_id));
        if (!changed.back()) {
            return unknownRow("point", point.row_id);
        }
        if (!isFinite(point)) {
            return notANumber(point.id);
        }
        fillCoordinates(*changed.back(), point);
    }
    return impl_->durably([&] {
        const bool written = std::all_of(changed.begin(), changed.end(), [&](const auto& row) {
            return rows.SetFeature(row.get()) == OGRERR_NONE;
        });
        return written && std::all_of(points.begin(), points.end(), [&](const survey::Point& point) {
                   return !point.hasCoordinates() || impl_->growExtent(point.coordinates);
               });
    });
}

core::Result<std::vector<survey::Point>> Job::points() const {
    const GdalTrap trap;
    const auto observations = impl_->observations();
    std::vector<survey::Point> found;
    found.reserve(observations.size());
    for (const auto& row : impl_->layer(kPoints)) {
        const auto observation = observations.find(row->GetFieldAsInteger64("observation"));
        if (observation == observations.end()) {
            qCWarning(core::logJob) << "a point drawn by another program is left out, row" << row->GetFID();
            continue;
        }
        found.push_back(pointOf(*row, observation->second));
    }
    if (!trap.said().isEmpty()) {
        return tl::unexpected(fileError(impl_->path, trap.said()));
    }
    return found;
}

core::Result<void> Job::setStation(const survey::Station& station) {
    std::optional<qint64> row_id;
    PMTS_TRY(impl_->durably([&] {
        row_id = impl_->addRow(kStations, [&](OGRFeature& row) { fillStation(row, station); });
        return row_id.has_value();
    }));
    impl_->station_rows[station.name] = *row_id;
    return {};
}

core::Result<survey::Station> Job::station() const {
    return stations().map(
        [](const std::vector<survey::Station>& all) { return all.empty() ? survey::Station() : all.back(); });
}

core::Result<std::vector<survey::Station>> Job::stations() const {
    const GdalTrap trap;
    std::vector<survey::Station> found;
    for (const auto& row : impl_->layer(kStations)) {
        found.push_back(stationOf(*row));
    }
    if (!trap.said().isEmpty()) {
        return tl::unexpected(fileError(impl_->path, trap.said()));
    }
    return found;
}

core::Result<Photo> Job::addPhoto(const Photo& photo) {
    Photo added = photo;
    PMTS_TRY(impl_->durably([&] {
        const auto row_id = impl_->addRow(kPhotos, [&](OGRFeature& row) { fillPhoto(row, photo); });
        added.row_id = row_id.value_or(0);
        return row_id.has_value();
    }));
    return added;
}

core::Result<std::vector<Photo>> Job::photos() const {
    const GdalTrap trap;
    OGRLayer& rows = impl_->layer(kPhotos);
    const char* without_image[] = {"image", nullptr};
    rows.SetIgnoredFields(without_image);
    std::vector<Photo> found;
    for (const auto& row : rows) {
        found.push_back(photoOf(*row));
    }
    rows.SetIgnoredFields(nullptr);
    if (!trap.said().isEmpty()) {
        return tl::unexpected(fileError(impl_->path, trap.said()));
    }
    return found;
}

core::Result<QByteArray> Job::photoImage(qint64 row_id) const {
    const GdalTrap trap;
    const OGRFeatureUniquePtr row(impl_->layer(kPhotos).GetFeature(row_id));
    if (!row) {
        return unknownRow("photo", row_id);
    }
    int size = 0;
    const GByte* const bytes = row->GetFieldAsBinary(row->GetFieldIndex("image"), &size);
    return QByteArray(reinterpret_cast<const char*>(bytes), size);
}

core::Result<void> Job::log(const LogEntry& entry) {
    return impl_->durably(
        [&] { return impl_->addRow(kLog, [&](OGRFeature& row) { fillLogEntry(row, entry); }).has_value(); });
}

core::Result<std::vector<LogEntry>> Job::logEntries(int newest) const {
    const GdalTrap trap;
    OGRLayer& rows = impl_->layer(kLog);
    const GIntBig count = rows.GetFeatureCount();
    rows.SetNextByIndex(std::max<GIntBig>(0, count - newest));
    std::vector<LogEntry> found;
    for (OGRFeatureUniquePtr row(rows.GetNextFeature()); row; row.reset(rows.GetNextFeature())) {
        found.push_back(logEntryOf(*row));
    }
    if (!trap.said().isEmpty()) {
        return tl::unexpected(fileError(impl_->path, trap.said()));
    }
    return found;
}

core::Result<void> Job::setMeta(const QString& key, const QString& value) {
    if (key == QLatin1String(kApplicationKey) || key == QLatin1String(kSchemaKey)) {
        throw std::logic_error("this row of meta belongs to the file");
    }
    const auto known = impl_->meta_rows.find(key);
    Impl::MetaRow written{known == impl_->meta_rows.end() ? OGRNullFID : known->row_id, value};
    PMTS_TRY(impl_->durably([&] {
        OGRLayer& rows = impl_->layer(kMeta);
        OGRFeature row(rows.GetLayerDefn());
        row.SetFID(written.row_id);
        setText(row, "key", key);
        setText(row, "value", value);
        const bool is_new = written.row_id == OGRNullFID;
        const OGRErr outcome = is_new ? rows.CreateFeature(&row) : rows.SetFeature(&row);
        written.row_id = row.GetFID();
        return outcome == OGRERR_NONE;
    }));
    impl_->meta_rows[key] = written;
    return {};
}

core::Result<QString> Job::meta(const QString& key) const { return impl_->meta_rows.value(key).value; }

}  // namespace pmts::job
