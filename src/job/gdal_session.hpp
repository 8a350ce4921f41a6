#pragma once

#include "pmts/core/result.hpp"

#include <QString>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <memory>

namespace pmts::job {

/// Collects what GDAL complains about on this thread while it lives, instead of letting it print.
class GdalTrap {
public:
    GdalTrap();
    ~GdalTrap();
    GdalTrap(const GdalTrap&) = delete;
    GdalTrap& operator=(const GdalTrap&) = delete;

    [[nodiscard]] const QString& said() const { return said_; }
    void collect(const char* message);

private:
    QString said_;
};

/// What GDAL said as sentences: disk full, file held by another program, read-only, damaged, other.
[[nodiscard]] core::Error fileError(const QString& path, const QString& said);

/// The sentence for a file whose pages or tables are not as they should be.
[[nodiscard]] core::Error damaged(const QString& path, const QString& detail);

struct CloseDataset {
    void operator()(GDALDataset* dataset) const;
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Registers the four drivers a job needs, once: a fraction of the time GDALAllRegister() takes.
void registerDrivers();

/// Opens a GeoPackage with WAL and synchronous FULL; null when GDAL cannot.
[[nodiscard]] Dataset openGeoPackage(const QString& path, unsigned access);

/// First column of the first row, for PRAGMAs and counts; null QString when there is none.
[[nodiscard]] QString queryText(GDALDataset& dataset, const QString& sql);

/// Runs SQL without a result; false when SQLite refused it.
[[nodiscard]] bool runSql(GDALDataset& dataset, const QString& sql);

}  // namespace pmts::job
