#pragma once

#include "pmts/geometry/pointing.hpp"

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <ogr_feature.h>

#include <optional>

namespace pmts::job {

/// One column of a row <-> a value. Absent values are NULL, times are UTC to the millisecond. A text's NUL
/// characters, which no GeoPackage text can hold, are written as U+2400.

void setText(OGRFeature& row, const char* column, const QString& text);
[[nodiscard]] QString textOf(const OGRFeature& row, const char* column);
void setNumber(OGRFeature& row, const char* column, std::optional<double> number);
[[nodiscard]] std::optional<double> numberOf(const OGRFeature& row, const char* column);
void setTime(OGRFeature& row, const char* column, const QDateTime& time);
[[nodiscard]] QDateTime timeOf(const OGRFeature& row, const char* column);
/// No bytes are NULL.
void setBytes(OGRFeature& row, const char* column, const QByteArray& bytes);
[[nodiscard]] QByteArray bytesOf(const OGRFeature& row, const char* column);
/// 0 when absent.
[[nodiscard]] core::Angle angleOf(const OGRFeature& row, const char* column);
/// Columns ha_gon and va_gon.
void setPointing(OGRFeature& row, const geometry::Pointing& pointing);
[[nodiscard]] geometry::Pointing pointingOf(const OGRFeature& row);

}  // namespace pmts::job
