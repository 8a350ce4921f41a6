#include "row_fields.hpp"

#include <cmath>

namespace pmts::job {
namespace {

constexpr int kUtcFlag = 100;  ///< OGR's time zone flag of UTC

}  // namespace

void setText(OGRFeature& row, const char* column, const QString& text) {
    QString plain = text;
    plain.replace(QChar(0), QChar(0x2400));
    row.SetField(column, plain.toUtf8().constData());
}

QString textOf(const OGRFeature& row, const char* column) {
    return QString::fromUtf8(row.GetFieldAsString(column));
}

void setTime(OGRFeature& row, const char* column, const QDateTime& time) {
    if (!time.isValid()) {
        row.SetFieldNull(row.GetFieldIndex(column));
        return;
    }
    const QDateTime utc = time.toUTC();
    const QDate day = utc.date();
    const QTime clock = utc.time();
    row.SetField(column, day.year(), day.month(), day.day(), clock.hour(), clock.minute(),
                 static_cast<float>(clock.second() + clock.msec() / 1000.0), kUtcFlag);
}

QDateTime timeOf(const OGRFeature& row, const char* column) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
    float second = 0.0F;
    if (!row.GetFieldAsDateTime(row.GetFieldIndex(column), &year, &month, &day, &hour, &minute, &second,
                                &zone)) {
        return {};
    }
    const QDateTime whole_minute(QDate(year, month, day), QTime(hour, minute), Qt::UTC);
    return whole_minute.addMSecs(std::lround(second * 1000.0));
}

void setNumber(OGRFeature& row, const char* column, std::optional<double> number) {
    if (number) {
        row.SetField(column, *number);
    } else {
        row.SetFieldNull(row.GetFieldIndex(column));
    }
}

std::optional<double> numberOf(const OGRFeature& row, const char* column) {
    const int index = row.GetFieldIndex(column);
    return index >= 0 && row.IsFieldSetAndNotNull(index) ? std::optional(row.GetFieldAsDouble(index))
                                                         : std::nullopt;
}

core::Angle angleOf(const OGRFeature& row, const char* column) {
    return core::Angle::fromGon(numberOf(row, column).value_or(0.0));
}

geometry::Pointing pointingOf(const OGRFeature& row) {
    return {.ha = angleOf(row, "ha_gon"), .va = angleOf(row, "va_gon")};
}

void setPointing(OGRFeature& row, const geometry::Pointing& pointing) {
    row.SetField("ha_gon", pointing.ha.gon());
    row.SetField("va_gon", pointing.va.gon());
}

void setBytes(OGRFeature& row, const char* column, const QByteArray& bytes) {
    const int index = row.GetFieldIndex(column);
    if (bytes.isEmpty()) {
        row.SetFieldNull(index);
    } else {
        row.SetField(index, static_cast<int>(bytes.size()), static_cast<const void*>(bytes.constData()));
    }
}

QByteArray bytesOf(const OGRFeature& row, const char* column) {
    int size = 0;
    const GByte* const bytes = row.GetFieldAsBinary(row.GetFieldIndex(column), &size);
    return bytes == nullptr ? QByteArray() : QByteArray(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace pmts::job
