#include "pmts/job/photo_file.hpp"

#include "photo_tags.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSaveFile>

#include <cerrno>
#include <utility>

namespace pmts::job {

namespace {

constexpr int kSidecarVersion = 1;

QString fileNameFrom(const QString& name) {
    static const QRegularExpression forbidden(QStringLiteral("[^\\p{L}\\p{N}._-]+"));
    QString safe = QString(name).replace(forbidden, QStringLiteral("_"));
    return safe.isEmpty() || safe.startsWith(u'.') ? QStringLiteral("photo") + safe : safe;
}

QString say(const char* text) { return QCoreApplication::translate("PhotoFile", text); }

/// The system's number for what went wrong; 0 when everything is written. QSaveFile keeps no words for a disk that fills
/// up in the middle of a write.
int writeError(QSaveFile& file, const QByteArray& bytes) {
    errno = 0;
    const bool is_written = file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush();
    return is_written ? 0 : errno != 0 ? errno : EIO;
}

tl::unexpected<core::Error> refusal(const QString& folder, const QString& path, int system_error) {
    const QString detail = path + QStringLiteral(": ") + qt_error_string(system_error);
    if (!QFileInfo(folder).isDir()) {
        return core::fail(core::ErrorKind::kFile, say("The folder “%1” is not there.").arg(folder),
                          say("Plug its drive in again, or choose another folder."), detail);
    }
    if (system_error == ENOSPC || system_error == EDQUOT || system_error == EFBIG) {
        return core::fail(core::ErrorKind::kFile, say("There is no room left in “%1” for the photo.").arg(folder),
                          say("Make room, or choose a folder on another disk."), detail);
    }
    return core::fail(core::ErrorKind::kFile, say("The photo cannot be written."),
                      say("Choose a folder that can be written and has room."), detail);
}

}  // namespace

QJsonObject photoSidecar(const PhotoFile& file, const QString& picture_name) {
    QJsonObject json{{"format", "pmts-photo"},
                     {"version", kSidecarVersion},
                     {"picture", picture_name},
                     {"name", file.photo.name},
                     {"time_utc", file.photo.utc.toUTC().toString(Qt::ISODateWithMs)},
                     {"ha_gon", file.photo.pointing.ha.gon()},
                     {"va_gon", file.photo.pointing.va.gon()}};
    QJsonObject station{{"name", file.photo.station_name}};
    if (file.station) {
        station.insert(QStringLiteral("e_m"), file.station->e_m);
        station.insert(QStringLiteral("n_m"), file.station->n_m);
        station.insert(QStringLiteral("h_m"), file.station->h_m);
        station.insert(QStringLiteral("instrument_height_m"), file.station->instrument_height_m);
        station.insert(QStringLiteral("orientation_gon"), file.station->orientation.gon());
    }
    json.insert(QStringLiteral("station"), station);
    if (!file.camera.isEmpty()) {
        json.insert(QStringLiteral("camera"), file.camera);
    }
    if (file.slope_distance_m) {
        json.insert(QStringLiteral("slope_distance_m"), *file.slope_distance_m);
        json.insert(QStringLiteral("range_source"), file.range_source);
    }
    if (!file.rig.isEmpty()) {
        json.insert(QStringLiteral("rig"), file.rig);
    }
    return json;
}

core::Result<QString> writePhotoFile(const PhotoFile& file, const QString& folder) {
    const auto tagged = withTags(file);
    PMTS_TRY(tagged);
    const QString base = QDir(folder).filePath(fileNameFrom(file.photo.name));
    const bool is_png = file.photo.encoded_image.startsWith("\x89PNG");
    const QString picture = base + (is_png ? QStringLiteral(".png") : QStringLiteral(".jpg"));
    const QByteArray sidecar = QJsonDocument(photoSidecar(file, QFileInfo(picture).fileName())).toJson();
    QSaveFile picture_file(picture), sidecar_file(base + QStringLiteral(".json"));
    // Both are on the disk under other names before either takes its place.
    const std::pair<QSaveFile*, QByteArray> parts[] = {{&picture_file, *tagged}, {&sidecar_file, sidecar}};
    for (const auto& [part, bytes] : parts) {
        if (const int system_error = writeError(*part, bytes)) {
            return refusal(folder, part->fileName(), system_error);
        }
    }
    if (!picture_file.commit() || !sidecar_file.commit()) {
        return refusal(folder, picture, errno);
    }
    return picture;
}

}  // namespace pmts::job
