#pragma once

#include "job_file.hpp"
#include "pmts/job/job.hpp"
#include "schema.hpp"

#include <QHash>
#include <ogrsf_frmts.h>

#include <functional>
#include <optional>
#include <unordered_map>

namespace pmts::job {

/// Device and inode: a path that leads elsewhere now is another file.
struct FileIdentity {
    quint64 device = 0;
    quint64 inode = 0;

    [[nodiscard]] bool operator==(const FileIdentity&) const = default;
};

/// The open file of a job and what is remembered of it between calls.
class Job::Impl {
public:
    Impl(QString job_path, JobFile job_file);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    [[nodiscard]] OGRLayer& layer(const char* name) const { return *file.dataset->GetLayerByName(name); }

    /// Everything `write` does becomes durable together, or not at all.
    core::Result<void> durably(const std::function<bool()>& write);

    /// Adds a row; its number, or nothing when the table did not take it.
    template <class Fill>
    std::optional<qint64> addRow(const char* table, Fill fill) {
        OGRLayer& rows = layer(table);
        OGRFeature row(rows.GetLayerDefn());
        fill(row);
        return rows.CreateFeature(&row) == OGRERR_NONE ? std::optional<qint64>(row.GetFID()) : std::nullopt;
    }

    /// All rows of a table as values; the file's error when GDAL complains.
    template <class Value>
    core::Result<std::vector<Value>> allRows(const char* table, Value (*value_of)(const OGRFeature&)) const {
        const GdalTrap trap;
        std::vector<Value> found;
        for (const auto& row : layer(table)) {
            found.push_back(value_of(*row));
        }
        if (!trap.said().isEmpty()) {
            return tl::unexpected(fileError(path, trap.said()));
        }
        return found;
    }

    /// Removes rows by number; true when all of them were there.
    bool removeRows(const char* table, const std::vector<qint64>& row_ids);

    /// Other programs read the extent from the contents table: it grows in the transaction that needs it.
    bool growExtent(const survey::Coordinates& at);
    bool writeCoordinates(const std::vector<survey::Point>& points);

    [[nodiscard]] std::optional<qint64> stationRow(const QString& name) const;
    [[nodiscard]] std::unordered_map<qint64, survey::Observation> observations() const;

    struct MetaRow {
        qint64 row_id = 0;
        QString value;
    };

    QString path;
    JobFile file;
    std::optional<FileIdentity> identity;
    OGREnvelope extent;                   ///< of the points, as the contents table has it
    OGREnvelope grown_extent;             ///< the same after the transaction under way
    QHash<QString, qint64> station_rows;  ///< the newest of each name
    QHash<QString, MetaRow> meta_rows;
    bool some_failed = false;

private:
    bool isCommitted(const std::function<bool()>& write);
    void openAfresh();
};

[[nodiscard]] tl::unexpected<core::Error> unknownRow(const char* what, qint64 row_id);

}  // namespace pmts::job
