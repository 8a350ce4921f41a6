#include "pmts/app/settings/camera_settings.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>

namespace pmts::app {

namespace {

constexpr int kKept = 20;  // webcams come and go
const QString kKey = QStringLiteral("camera/kept");

QJsonObject toJson(const CameraSetting& setting) {
    QJsonObject object{{"kind", static_cast<int>(setting.kind)}, {"name", setting.name}, {"full_stills", setting.full_stills}};
    if (setting.format) {
        object.insert(QStringLiteral("format"), QJsonObject{{"width_px", setting.format->size.width()},
                                                            {"height_px", setting.format->size.height()},
                                                            {"rate_hz", setting.format->rate_hz},
                                                            {"pixels", setting.format->pixel_format}});
    }
    QJsonArray controls;
    for (const video::ControlValue& value : setting.controls) {
        controls.append(QJsonObject{{"control", static_cast<int>(value.control)}, {"auto", value.automatic}, {"value", value.value}});
    }
    object.insert(QStringLiteral("controls"), controls);
    return object;
}

std::optional<video::VideoFormat> formatFromJson(const QJsonObject& object) {
    video::VideoFormat format;
    format.size = {object.value(QLatin1String("width_px")).toInt(), object.value(QLatin1String("height_px")).toInt()};
    format.rate_hz = object.value(QLatin1String("rate_hz")).toDouble(30.0);
    format.pixel_format = object.value(QLatin1String("pixels")).toString();
    return format.size.isEmpty() || !(format.rate_hz > 0.0) ? std::nullopt : std::optional(format);
}

std::optional<CameraSetting> fromJson(const QJsonObject& object) {
    CameraSetting setting;
    const int kind = object.value(QLatin1String("kind")).toInt(-1);
    setting.name = object.value(QLatin1String("name")).toString();
    if (kind < 0 || kind > static_cast<int>(video::SourceKind::kStream) || setting.name.isEmpty()) {
        return std::nullopt;
    }
    setting.kind = static_cast<video::SourceKind>(kind);
    setting.full_stills = object.value(QLatin1String("full_stills")).toBool();
    setting.format = formatFromJson(object.value(QLatin1String("format")).toObject());
    for (const QJsonValue item : object.value(QLatin1String("controls")).toArray()) {
        const int control = item[QLatin1String("control")].toInt(-1);
        if (control >= 0 && control <= static_cast<int>(video::CameraControl::kZoom)) {
            remember(setting.controls, {.control = static_cast<video::CameraControl>(control),
                                        .automatic = item[QLatin1String("auto")].toBool(),
                                        .value = item[QLatin1String("value")].toDouble()});
        }
    }
    return setting;
}

}  // namespace

CameraSetting CameraSettings::of(const video::SourceAddress& camera) const {
    const auto found = std::ranges::find_if(cameras, [&camera](const CameraSetting& known) {
        return known.kind == camera.kind && known.name == camera.name;
    });
    if (found != cameras.end()) {
        return *found;
    }
    CameraSetting fresh;
    fresh.kind = camera.kind;
    fresh.name = camera.name;
    return fresh;
}

void CameraSettings::keep(const CameraSetting& setting) {
    std::erase_if(cameras, [&setting](const CameraSetting& known) {
        return known.kind == setting.kind && known.name == setting.name;
    });
    cameras.insert(cameras.begin(), setting);
    if (cameras.size() > kKept) {
        cameras.resize(kKept);
    }
}

void CameraSettings::load(const QSettings& file) {
    cameras.clear();
    for (const QString& json : file.value(kKey).toStringList()) {
        if (const auto setting = fromJson(QJsonDocument::fromJson(json.toUtf8()).object())) {
            cameras.push_back(*setting);
        }
    }
}

void CameraSettings::save(QSettings& file) const {
    QStringList kept;
    for (const CameraSetting& setting : cameras) {
        kept.append(QString::fromUtf8(QJsonDocument(toJson(setting)).toJson(QJsonDocument::Compact)));
    }
    file.setValue(kKey, kept);
}

}  // namespace pmts::app
