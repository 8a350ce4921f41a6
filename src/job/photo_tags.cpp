#include "photo_tags.hpp"

#include <QCoreApplication>
#include <exiv2/exiv2.hpp>

#include <mutex>

namespace pmts::job {

namespace {

/// XMP names of PMTS; a name, not a page.
constexpr const char* kNamespace = "urn:pmts:photo:1/";

/// The library's XMP part asks to be set up once, before threads use it.
void prepareXmp() {
    static std::once_flag once;
    std::call_once(once, [] {
        Exiv2::LogMsg::setLevel(Exiv2::LogMsg::error);
        Exiv2::XmpParser::initialize();
        Exiv2::XmpProperties::registerNs(kNamespace, "pmts");
    });
}

std::string text(double value, int decimals) { return QString::number(value, 'f', decimals).toStdString(); }

void putExif(const PhotoFile& file, Exiv2::ExifData& exif) {
    const QDateTime utc = file.photo.utc.toUTC();
    const std::string taken = utc.toString(QStringLiteral("yyyy:MM:dd HH:mm:ss")).toStdString();
    exif["Exif.Image.Software"] = "PMTS";
    exif["Exif.Image.ImageDescription"] = file.photo.name.toStdString();
    if (!file.camera.isEmpty()) {
        exif["Exif.Image.Model"] = file.camera.toStdString();
    }
    exif["Exif.Image.DateTime"] = taken;
    exif["Exif.Photo.DateTimeOriginal"] = taken;
    exif["Exif.Photo.OffsetTimeOriginal"] = "+00:00";
    exif["Exif.Photo.SubSecTimeOriginal"] = utc.toString(QStringLiteral("zzz")).toStdString();
    if (file.slope_distance_m) {
        exif["Exif.Photo.SubjectDistance"] = Exiv2::floatToRationalCast(static_cast<float>(*file.slope_distance_m));
    }
}

void putXmp(const PhotoFile& file, Exiv2::XmpData& xmp) {
    const auto put = [&xmp](const char* name, const std::string& value) { xmp["Xmp.pmts." + std::string(name)] = value; };
    put("HorizontalAngleGon", text(file.photo.pointing.ha.gon(), 5));
    put("VerticalAngleGon", text(file.photo.pointing.va.gon(), 5));
    put("StationName", file.photo.station_name.toStdString());
    if (file.station) {
        put("StationEastM", text(file.station->e_m, 4));
        put("StationNorthM", text(file.station->n_m, 4));
        put("StationHeightM", text(file.station->h_m, 4));
        put("InstrumentHeightM", text(file.station->instrument_height_m, 4));
        put("OrientationGon", text(file.station->orientation.gon(), 5));
    }
    if (file.slope_distance_m) {
        put("SlopeDistanceM", text(*file.slope_distance_m, 4));
        put("RangeSource", file.range_source.toStdString());
    }
    if (file.focal_length_px) {
        put("FocalLengthPx", text(*file.focal_length_px, 4));
    }
    if (file.principal_x_px && file.principal_y_px) {
        put("PrincipalPointXPx", text(*file.principal_x_px, 4));
        put("PrincipalPointYPx", text(*file.principal_y_px, 4));
    }
}

}  // namespace

core::Result<QByteArray> withTags(const PhotoFile& file) {
    prepareXmp();
    try {
        const QByteArray& bytes = file.photo.encoded_image;
        const auto image = Exiv2::ImageFactory::open(reinterpret_cast<const Exiv2::byte*>(bytes.constData()),
                                                     static_cast<long>(bytes.size()));
        image->readMetadata();
        putExif(file, image->exifData());
        putXmp(file, image->xmpData());
        image->writeMetadata();
        Exiv2::BasicIo& io = image->io();
        const auto size = static_cast<qsizetype>(io.size());
        io.open();
        const Exiv2::DataBuf whole = io.read(static_cast<long>(size));
        return QByteArray(reinterpret_cast<const char*>(whole.pData_), size);
    } catch (const Exiv2::AnyError& error) {
        return core::fail(core::ErrorKind::kBadInput,
                          QCoreApplication::translate("PhotoFile", "The photo %1 is no picture that can be exported.").arg(file.photo.name),
                          QCoreApplication::translate("PhotoFile", "Take it again."), QString::fromLocal8Bit(error.what()));
    }
}

}  // namespace pmts::job
