#pragma once

#include "pmts/core/result.hpp"
#include "pmts/survey/point.hpp"

#include <QString>

#include <vector>

namespace pmts::job {

enum class ExportFormat { kCsv, kGeoJson, kDxf };

/// By file ending: .csv, .geojson or .json, .dxf. kBadInput for another one.
[[nodiscard]] core::Result<ExportFormat> exportFormatFromPath(const QString& path);

/// Writes the points that are not struck out, through GDAL. The file appears whole or not at all (temporary
/// name, then rename); kFile with the reason otherwise. CSV has all attributes with their units in the
/// header; DXF has the ID as text, one layer a code.
[[nodiscard]] core::Result<void> exportPoints(const std::vector<survey::Point>& points, const QString& path,
                                              ExportFormat format);

}  // namespace pmts::job
