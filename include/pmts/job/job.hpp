#pragma once

#include "pmts/core/result.hpp"
#include "pmts/job/evidence.hpp"
#include "pmts/job/image_mark.hpp"
#include "pmts/survey/planned_point.hpp"
#include "pmts/survey/point.hpp"
#include "pmts/survey/station.hpp"

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace pmts::job {

/// A photo with its pose: image file bytes (PNG or JPEG) and the circle readings of its centre.
struct Photo {
    qint64 row_id = 0;
    QString name;
    QByteArray encoded_image;
    geometry::Pointing pointing;
    QString station_name;
    QDateTime utc;
    QString rig_json;  ///< lens and mount it was taken with
};

struct LogEntry {
    QDateTime utc;
    QString category;
    QString text;
};

/// One GeoPackage file (docs/job-format.md): layers `points` and `planned_points` with 3-D geometry, tables
/// for what belongs to them. WAL and synchronous FULL: a call that returned success survives kill -9, and
/// each call is one transaction, whole or not at all. Used on one thread, the job thread; another process may
/// read meanwhile, a second writer is refused.
class Job {
public:
    static constexpr int kSchemaVersion = 2;

    /// kFile when the file exists, the folder is read-only or the disk full.
    [[nodiscard]] static core::Result<std::unique_ptr<Job>> create(const QString& path);
    /// kFile when damaged, foreign (no PMTS table), from a newer PMTS, read-only, or open in another PMTS.
    [[nodiscard]] static core::Result<std::unique_ptr<Job>> open(const QString& path);
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    [[nodiscard]] QString path() const;
    [[nodiscard]] QString name() const;

    /// Observation, derived point and evidence together; returns the point with its row id. The evidence's
    /// own row numbers are given here.
    [[nodiscard]] core::Result<survey::Point> record(const survey::Point& point,
                                                     const std::optional<Evidence>& evidence = std::nullopt);
    /// Absent when the point was not aimed by image.
    [[nodiscard]] core::Result<std::optional<Evidence>> evidenceOf(qint64 point_row) const;
    /// Changes ID, code, remark or the struck-out mark. The observation is never touched.
    [[nodiscard]] core::Result<void> update(const survey::Point& point);
    [[nodiscard]] core::Result<void> update(const std::vector<survey::Point>& points);
    /// Recomputed coordinates (new orientation, new accuracy).
    [[nodiscard]] core::Result<void> updateCoordinates(const std::vector<survey::Point>& points);
    [[nodiscard]] core::Result<std::vector<survey::Point>> points()
        const;  ///< struck-out ones included, in order of recording

    /// Every change of a station is kept as a new row; the last one is current. Points that moved with it get
    /// their new coordinates in the same transaction.
    [[nodiscard]] core::Result<void> setStation(const survey::Station& station,
                                                const std::vector<survey::Point>& recomputed = {});
    [[nodiscard]] core::Result<survey::Station> station() const;
    [[nodiscard]] core::Result<std::vector<survey::Station>> stations() const;

    [[nodiscard]] core::Result<Photo> addPhoto(const Photo& photo);
    [[nodiscard]] core::Result<std::vector<Photo>> photos() const;  ///< without image bytes
    [[nodiscard]] core::Result<QByteArray> photoImage(qint64 row_id) const;

    /// Returns them with their row numbers. One that has a number gets it back: what was removed returns as
    /// it was.
    [[nodiscard]] core::Result<std::vector<survey::PlannedPoint>> addPlanned(
        const std::vector<survey::PlannedPoint>& points);
    [[nodiscard]] core::Result<void> removePlanned(const std::vector<qint64>& row_ids);
    [[nodiscard]] core::Result<std::vector<survey::PlannedPoint>> planned() const;

    [[nodiscard]] core::Result<ImageMark> addMark(const ImageMark& mark);
    [[nodiscard]] core::Result<void> updateMark(const ImageMark& mark);
    [[nodiscard]] core::Result<void> removeMark(qint64 row_id);
    [[nodiscard]] core::Result<std::vector<ImageMark>> marksOf(qint64 photo_row) const;

    [[nodiscard]] core::Result<void> log(const LogEntry& entry);
    [[nodiscard]] core::Result<std::vector<LogEntry>> logEntries(int newest) const;

    /// Small texts that belong to the job: next point ID, last code.
    [[nodiscard]] core::Result<void> setMeta(const QString& key, const QString& value);
    [[nodiscard]] core::Result<QString> meta(const QString& key) const;

private:
    class Impl;
    explicit Job(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::job
