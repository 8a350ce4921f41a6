#include "pmts/job/job.hpp"

#include "job_impl.hpp"
#include "pmts/core/logging.hpp"
#include "rows.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmts::job {
namespace {

using core::ErrorKind;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

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

/// All of them are rows of the table, with numbers for coordinates.
core::Result<void> checkPlaced(OGRLayer& rows, const std::vector<survey::Point>& points) {
    for (const survey::Point& point : points) {
        if (!OGRFeatureUniquePtr(rows.GetFeature(point.row_id))) {
            return unknownRow("point", point.row_id);
        }
        if (!isFinite(point)) {
            return notANumber(point.id);
        }
    }
    return {};
}

}  // namespace

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

core::Result<survey::Point> Job::record(const survey::Point& point, const std::optional<Evidence>& evidence) {
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
        return row_id && (!evidence || impl_->addRow(kEvidence, [&](OGRFeature& row) {
                   fillEvidence(row, *evidence, *row_id);
               }));
    }));
    return recorded;
}

core::Result<std::optional<Evidence>> Job::evidenceOf(qint64 point_row) const {
    const GdalTrap trap;
    OGRLayer& rows = impl_->layer(kEvidence);
    rows.SetAttributeFilter(QStringLiteral("point_row = %1").arg(point_row).toUtf8().constData());
    rows.ResetReading();
    const OGRFeatureUniquePtr row(rows.GetNextFeature());
    rows.SetAttributeFilter(nullptr);
    if (!trap.said().isEmpty()) {
        return tl::unexpected(fileError(impl_->path, trap.said()));
    }
    return row ? std::optional(evidenceOfRow(*row)) : std::nullopt;
}

core::Result<void> Job::update(const survey::Point& point) { return update(std::vector{point}); }

core::Result<void> Job::update(const std::vector<survey::Point>& points) {
    OGRLayer& rows = impl_->layer(kPoints);
    std::vector<OGRFeatureUniquePtr> changed;
    for (const survey::Point& point : points) {
        changed.emplace_back(rows.GetFeature(point.row_id));
        if (!changed.back()) {
            return unknownRow("point", point.row_id);
        }
        fillNames(*changed.back(), point);
    }
    return impl_->durably([&] {
        return std::all_of(changed.begin(), changed.end(),
                           [&](const auto& row) { return rows.SetFeature(row.get()) == OGRERR_NONE; });
    });
}

core::Result<void> Job::updateCoordinates(const std::vector<survey::Point>& points) {
    PMTS_TRY(checkPlaced(impl_->layer(kPoints), points));
    return impl_->durably([&] { return impl_->writeCoordinates(points); });
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

core::Result<void> Job::setStation(const survey::Station& station,
                                   const std::vector<survey::Point>& recomputed) {
    PMTS_TRY(checkPlaced(impl_->layer(kPoints), recomputed));
    std::optional<qint64> row_id;
    PMTS_TRY(impl_->durably([&] {
        row_id = impl_->addRow(kStations, [&](OGRFeature& row) { fillStation(row, station); });
        return row_id && impl_->writeCoordinates(recomputed);
    }));
    impl_->station_rows[station.name] = *row_id;
    return {};
}

core::Result<survey::Station> Job::station() const {
    return stations().map(
        [](const std::vector<survey::Station>& all) { return all.empty() ? survey::Station() : all.back(); });
}

core::Result<std::vector<survey::Station>> Job::stations() const {
    return impl_->allRows(kStations, stationOf);
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
