#include "pmts/job/export.hpp"

#include "gdal_session.hpp"
#include "rows.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>
#include <cpl_vsi.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>

namespace pmts::job {
namespace {

using core::ErrorKind;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

/// A file in GDAL's memory: its drivers do not tell whether the disk took all bytes, QSaveFile does.
class MemoryFile {
public:
    explicit MemoryFile(const char* ending)
        : path_(QStringLiteral("/vsimem/pmts-export-%1.%2")
                    .arg(reinterpret_cast<quintptr>(this))
                    .arg(QLatin1String(ending))) {}
    ~MemoryFile() { VSIUnlink(path_.toUtf8().constData()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] QByteArray path() const { return path_.toUtf8(); }
    [[nodiscard]] QByteArray bytes() const {
        vsi_l_offset size = 0;
        const GByte* const begin = VSIGetMemFileBuffer(path().constData(), &size, FALSE);
        return begin == nullptr
                   ? QByteArray()
                   : QByteArray(reinterpret_cast<const char*>(begin), static_cast<qsizetype>(size));
    }

private:
    QString path_;
};

struct Column {
    const char* name;
    OGRFieldType type;
    int decimals = 0;
};

/// Names carry the units. 0.1 mm for coordinates, 0.01 cc for angles: nothing measured is lost.
constexpr std::array kPlaceColumns{Column{"e_m", OFTReal, 4}, Column{"n_m", OFTReal, 4},
                                   Column{"h_m", OFTReal, 4}};
constexpr std::array kColumns{
    Column{"id", OFTString},
    Column{"code", OFTString},
    Column{"sigma_e_m", OFTReal, 4},
    Column{"sigma_n_m", OFTReal, 4},
    Column{"sigma_h_m", OFTReal, 4},
    Column{"station", OFTString},
    Column{"ha_gon", OFTReal, 6},
    Column{"va_gon", OFTReal, 6},
    Column{"sd_m", OFTReal, 4},
    Column{"target_height_m", OFTReal, 4},
    Column{"mode", OFTString},
    Column{"time_utc", OFTString},
    Column{"absurd_reason", OFTString},
    Column{"source", OFTString},
    Column{"remark", OFTString},
};

bool addColumn(OGRLayer& layer, const Column& column) {
    OGRFieldDefn field(column.name, column.type);
    if (column.decimals > 0) {
        field.SetWidth(24);
        field.SetPrecision(column.decimals);
    }
    return layer.CreateField(&field) == OGRERR_NONE;
}

template <class Columns>
bool addColumns(OGRLayer& layer, const Columns& columns) {
    return std::all_of(columns.begin(), columns.end(),
                       [&](const Column& column) { return addColumn(layer, column); });
}

void fillAttributes(OGRFeature& row, const survey::Point& point) {
    const auto& shot = point.observation;
    setText(row, "id", point.id);
    setText(row, "code", point.code);
    setText(row, "remark", point.remark);
    setText(row, "station", point.station_name);
    setText(row, "mode", shot.edm_mode);
    setText(row, "source", shot.source);
    setText(row, "absurd_reason", shot.absurd_reason);
    setText(row, "time_utc", shot.utc.isValid() ? shot.utc.toUTC().toString(Qt::ISODateWithMs) : QString());
    row.SetField("ha_gon", shot.pointing.ha.gon());
    row.SetField("va_gon", shot.pointing.va.gon());
    row.SetField("target_height_m", shot.target_height_m);
    if (point.hasCoordinates()) {
        row.SetField("sd_m", *shot.slope_distance_m);
        row.SetField("sigma_e_m", point.coordinates.sigma_e_m);
        row.SetField("sigma_n_m", point.coordinates.sigma_n_m);
        row.SetField("sigma_h_m", point.coordinates.sigma_h_m);
    }
}

OGRPoint placeOf(const survey::Point& point) {
    return {point.coordinates.e_m, point.coordinates.n_m, point.coordinates.h_m};
}

using Points = std::vector<survey::Point>;

bool writeCsv(GDALDataset& file, const Points& points) {
    OGRLayer* const layer = file.CreateLayer("points", nullptr, wkbNone, nullptr);
    if (layer == nullptr || !addColumns(*layer, kPlaceColumns) || !addColumns(*layer, kColumns)) {
        return false;
    }
    return std::all_of(points.begin(), points.end(), [&](const survey::Point& point) {
        OGRFeature row(layer->GetLayerDefn());
        fillAttributes(row, point);
        if (point.hasCoordinates()) {
            row.SetField("e_m", point.coordinates.e_m);
            row.SetField("n_m", point.coordinates.n_m);
            row.SetField("h_m", point.coordinates.h_m);
        }
        return layer->CreateFeature(&row) == OGRERR_NONE;
    });
}

bool writeGeoJson(GDALDataset& file, const Points& points) {
    // No reference system: E, N, H stay as they are, as in the job.
    const char* const options[] = {"COORDINATE_PRECISION=4", nullptr};
    OGRLayer* const layer = file.CreateLayer("points", nullptr, wkbPoint25D, const_cast<char**>(options));
    if (layer == nullptr || !addColumns(*layer, kColumns)) {
        return false;
    }
    return std::all_of(points.begin(), points.end(), [&](const survey::Point& point) {
        OGRFeature row(layer->GetLayerDefn());
        fillAttributes(row, point);
        if (point.hasCoordinates()) {
            const OGRPoint place = placeOf(point);
            row.SetGeometry(&place);
        }
        return layer->CreateFeature(&row) == OGRERR_NONE;
    });
}

/// A code as the name of a DXF layer, which knows fewer characters.
QString dxfLayer(const QString& code) {
    QString name = code.trimmed();
    for (QChar& c : name) {
        if (QStringLiteral("<>/\\\":;?*|=`,").contains(c) || c < u' ') {
            c = u'_';
        }
    }
    return name.isEmpty() ? QStringLiteral("POINTS") : name;
}

/// Ground size of the point numbers: a 150th of the drawing, between 2 cm and 2 m.
double textHeightM(const Points& points) {
    OGREnvelope extent;
    for (const auto& point : points) {
        extent.Merge(point.coordinates.e_m, point.coordinates.n_m);
    }
    const double size_m =
        extent.IsInit() ? std::max(extent.MaxX - extent.MinX, extent.MaxY - extent.MinY) : 0.0;
    return std::clamp(size_m / 150.0, 0.02, 2.0);
}

bool addToDrawing(OGRLayer& layer, const survey::Point& point, const QByteArray& style) {
    OGRFeature row(layer.GetLayerDefn());
    row.SetField("Layer", dxfLayer(point.code).toUtf8().constData());
    const OGRPoint place = placeOf(point);
    row.SetGeometry(&place);
    if (!style.isEmpty()) {
        row.SetStyleString(style.constData());
    }
    return layer.CreateFeature(&row) == OGRERR_NONE;
}

bool writeDxf(GDALDataset& file, const Points& points) {
    OGRLayer* const layer = file.CreateLayer("entities", nullptr, wkbUnknown, nullptr);
    if (layer == nullptr) {
        return false;
    }
    Points drawn;
    std::copy_if(points.begin(), points.end(), std::back_inserter(drawn),
                 [](const auto& p) { return p.hasCoordinates(); });
    const double height_m = textHeightM(drawn);
    return std::all_of(drawn.begin(), drawn.end(), [&](const survey::Point& point) {
        QString id = point.id;
        id.replace(u'\\', QStringLiteral("\\\\")).replace(u'"', QStringLiteral("\\\""));
        const QString style = QStringLiteral("LABEL(f:\"Arial\",t:\"%1\",s:%2g,p:1)").arg(id).arg(height_m);
        return addToDrawing(*layer, point, {}) &&
               (id.isEmpty() || addToDrawing(*layer, point, style.toUtf8()));
    });
}

struct Format {
    const char* driver;
    const char* ending;
    bool (*write)(GDALDataset& file, const Points& points);
};

Format formatOf(ExportFormat format) {
    switch (format) {
        case ExportFormat::kCsv:
            return {"CSV", "csv", writeCsv};
        case ExportFormat::kGeoJson:
            return {"GeoJSON", "geojson", writeGeoJson};
        case ExportFormat::kDxf:
            return {"DXF", "dxf", writeDxf};
    }
    throw std::logic_error("unknown export format");
}

core::Result<QByteArray> encoded(const Points& points, ExportFormat format, const QString& path) {
    registerDrivers();
    const GdalTrap trap;
    const Format chosen = formatOf(format);
    const MemoryFile memory(chosen.ending);
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(chosen.driver);
    Dataset file(driver->Create(memory.path().constData(), 0, 0, 0, GDT_Unknown, nullptr));
    const bool written = file && chosen.write(*file, points);
    file.reset();
    QByteArray bytes = memory.bytes();
    if (!written || bytes.isEmpty()) {
        return core::fail(ErrorKind::kFile, tr("The points could not be written as %1.").arg(path),
                          tr("Choose another format."), trap.said());
    }
    return bytes;
}

tl::unexpected<core::Error> unwritten(const QSaveFile& file) {
    return core::fail(
        ErrorKind::kFile, tr("%1 cannot be written: %2.").arg(file.fileName(), file.errorString()),
        tr("Choose another folder or make room on the disk; an earlier file of that name is unchanged."));
}

}  // namespace

core::Result<ExportFormat> exportFormatFromPath(const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == u"csv") {
        return ExportFormat::kCsv;
    }
    if (ending == u"geojson" || ending == u"json") {
        return ExportFormat::kGeoJson;
    }
    if (ending == u"dxf") {
        return ExportFormat::kDxf;
    }
    return core::fail(ErrorKind::kBadInput, tr("%1 has no ending that names an export format.").arg(path),
                      tr("End the name with .csv, .geojson or .dxf."));
}

core::Result<void> exportPoints(const std::vector<survey::Point>& points, const QString& path,
                                ExportFormat format) {
    Points kept;
    std::copy_if(points.begin(), points.end(), std::back_inserter(kept),
                 [](const auto& point) { return !point.struck_out; });
    const auto bytes = encoded(kept, format, path);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(*bytes) != bytes->size() || !file.commit()) {
        return unwritten(file);
    }
    return {};
}

}  // namespace pmts::job
