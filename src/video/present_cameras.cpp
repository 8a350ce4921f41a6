#include "present_cameras.hpp"

#include "v4l2_capture.hpp"

#include <QCameraDevice>
#include <QMediaDevices>

#include <algorithm>

namespace pmts::video {

std::vector<SourceAddress> mergedCameras(std::vector<SourceAddress> v4l2,
                                         const QStringList& qt_descriptions) {
    std::vector<SourceAddress> all = std::move(v4l2);
    for (const QString& description : qt_descriptions) {
        const bool known = std::any_of(
            all.begin(), all.end(), [&](const SourceAddress& camera) { return camera.name == description; });
        if (!known && !description.isEmpty()) {
            all.push_back({SourceKind::kQtCamera, description, description});
        }
    }
    return all;
}

std::vector<SourceAddress> presentCameras() {
    QStringList descriptions;
    for (const QCameraDevice& device : QMediaDevices::videoInputs()) {
        descriptions.append(device.description());  // the ids are not stable
    }
    return mergedCameras(v4l2Cameras(QStringLiteral("/dev")), descriptions);
}

}  // namespace pmts::video
