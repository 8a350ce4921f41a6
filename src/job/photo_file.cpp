#include "pmts/job/photo_file.hpp"

#include "photo_tags.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSaveFile>

namespace pmts::job {

namespace {

constexpr int kSidecarVersion = 1;

QString fileNameFrom(const QString& name) {
    static const QRegularExpression forbidden(QStringLiteral("[^\\p{L}\\p{N}._-]+"));
    QString safe = QString(name).replace(forbidden, QStringLiteral("_"));
    return safe.isEmpty() || safe.startsWith(u'.') ? QStringLiteral("photo") + safe : safe;
}

core::Result<void> write(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return core::fail(core::ErrorKind::kFile, QCoreApplication::translate("PhotoFile", "The photo cannot be written."),
                          QCoreApplication::translate("PhotoFile", "Choose a folder that can be written and has room."),
                          path + QStringLiteral(": ") + file.errorString());
    }
    return {};
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
    PMTS_TRY(write(picture, *tagged));
    const QJsonObject sidecar = photoSidecar(file, QFileInfo(picture).fileName());
    PMTS_TRY(write(base + QStringLiteral(".json"), QJsonDocument(sidecar).toJson()));
    return picture;
}

}  // namespace pmts::job
