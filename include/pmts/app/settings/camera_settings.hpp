#pragma once

#include "pmts/video/video_source.hpp"

#include <QSettings>

#include <optional>
#include <vector>

namespace pmts::app {

/// What was chosen for one camera; kept by its kind and name, so that it is there again after a replug or restart.
struct CameraSetting {
    video::SourceKind kind = video::SourceKind::kSimulated;
    QString name;
    std::optional<video::VideoFormat> format;  ///< absent: the size of the rig
    std::vector<video::ControlValue> controls;
    bool full_stills = false;  ///< photos in the largest mode

    [[nodiscard]] bool operator==(const CameraSetting&) const = default;
};

/// Of every camera that was ever set.
struct CameraSettings {
    std::vector<CameraSetting> cameras;

    /// Its own, or an empty one with its name.
    [[nodiscard]] CameraSetting of(const video::SourceAddress& camera) const;
    void keep(const CameraSetting& setting);

    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
