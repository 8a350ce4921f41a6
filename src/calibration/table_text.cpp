// The distortion table for people: why it is none, and as CSV.
#include "pmts/calibration/distortion_table.hpp"

#include <QCoreApplication>
#include <QList>

#include <cmath>

namespace pmts::calibration {
namespace {

using core::Angle;
using core::ErrorKind;

constexpr double kLargestAngle_gon = 199.0;

QString text(const char* sentence) { return QCoreApplication::translate("DistortionTable", sentence); }

core::Error badLine(int line, const QString& why) {
    return {.kind = ErrorKind::kBadInput,
            .happened = text("Line %1 of the table cannot be read: %2.").arg(line).arg(why),
            .remedy = text("Correct the file and load it again."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// `# centre_px,643.5,357.5`
bool takeCentre(const QByteArray& line, camera::RadialTableLens& table) {
    const QList<QByteArray> cells = line.split(',');
    bool is_x = false, is_y = false;
    if (cells.size() == 3 && cells[0].startsWith("# centre_px")) {
        table.cx_px = cells[1].toDouble(&is_x);
        table.cy_px = cells[2].toDouble(&is_y);
    }
    return is_x && is_y;
}

}  // namespace

QString whyNoTable(const std::vector<camera::RadialTableLens::Row>& rows) {
    if (rows.size() < 2) {
        return text("A table needs at least two rows.");
    }
    if (rows.front().radius_px != 0.0 || rows.front().angle_rad != 0.0) {
        return text("The first row is the centre: radius 0, angle 0.");
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto row = static_cast<int>(i) + 1;
        if (!std::isfinite(rows[i].radius_px) || !std::isfinite(rows[i].angle_rad)) {
            return text("Row %1 is not a number.").arg(row);
        }
        if (rows[i].radius_px <= rows[i - 1].radius_px) {
            return text("Row %1: the radius must be larger than in the row before.").arg(row);
        }
        if (rows[i].angle_rad <= rows[i - 1].angle_rad) {
            return text("Row %1: the angle must be larger than in the row before.").arg(row);
        }
    }
    if (Angle::fromRad(rows.back().angle_rad).gon() > kLargestAngle_gon) {
        return text("The last angle is too large for a camera.");
    }
    return {};
}

QByteArray tableToCsv(const camera::RadialTableLens& table) {
    const double width_rad = centralPixelWidth_rad(table.rows);
    QByteArray csv = "# centre_px," + QByteArray::number(table.cx_px, 'g', 17) + ',' + QByteArray::number(table.cy_px, 'g', 17) + '\n';
    csv += "radius_px,angle_gon,deviation_gon\n";
    for (const auto& row : table.rows) {
        const double off_rad = row.angle_rad - idealLensAngle_rad(width_rad, row.radius_px);
        csv += QByteArray::number(row.radius_px, 'g', 17) + ',' + QByteArray::number(Angle::fromRad(row.angle_rad).gon(), 'g', 17) +
               ',' + QByteArray::number(Angle::fromRad(off_rad).gon(), 'f', 6) + '\n';
    }
    return csv;
}

core::Result<camera::RadialTableLens> tableFromCsv(const QByteArray& csv) {
    camera::RadialTableLens table;
    bool has_centre = false;
    int number = 0;
    for (const QByteArray& raw : csv.split('\n')) {
        ++number;
        const QByteArray line = raw.trimmed();
        if (line.startsWith('#')) {
            has_centre = takeCentre(line, table) || has_centre;
            continue;
        }
        if (line.isEmpty() || line.startsWith("radius_px")) {
            continue;
        }
        const QList<QByteArray> cells = line.split(',');
        bool is_radius = false, is_angle = false;
        const double radius_px = cells.value(0).toDouble(&is_radius);
        const double angle_gon = cells.value(1).toDouble(&is_angle);
        if (!is_radius || !is_angle) {
            return tl::unexpected(badLine(number, text("a radius in px and an angle in gon were expected")));
        }
        table.rows.push_back({radius_px, Angle::fromGon(angle_gon).rad()});
    }
    if (!has_centre) {
        return tl::unexpected(badLine(1, text("“# centre_px,x,y” was expected")));
    }
    if (const QString why = whyNoTable(table.rows); !why.isEmpty()) {
        return core::fail(ErrorKind::kBadInput, why, text("Correct the file and load it again."));
    }
    return table;
}

}  // namespace pmts::calibration
