#pragma once

#include "pmts/job/job.hpp"
#include "pmts/survey/station.hpp"

#include <QJsonObject>

#include <optional>

namespace pmts::job {

/// A photo and what belongs to its pose, as far as it is known.
struct PhotoFile {
    Photo photo;                             ///< with its image bytes, JPEG or PNG
    QString camera;                          ///< empty: not known
    std::optional<survey::Station> station;  ///< where it stood when the photo was taken
    std::optional<double> slope_distance_m;  ///< along the telescope's axis
    QString range_source;                    ///< `measured`, `assumed` ...
    std::optional<double> focal_length_px;   ///< pixels per radian at the axis
    std::optional<double> principal_x_px, principal_y_px;
    QJsonObject rig;                         ///< docs/photo-files.md; empty: not known
};

/// Writes `<name>.jpg` (or .png) with EXIF and XMP and `<name>.json` into the folder; docs/photo-files.md says what is in
/// them. Characters that no file name may have are replaced. Returns the path of the picture. kFile when it cannot be
/// written, kBadInput when the image is no JPEG or PNG.
[[nodiscard]] core::Result<QString> writePhotoFile(const PhotoFile& file, const QString& folder);

/// The sidecar alone.
[[nodiscard]] QJsonObject photoSidecar(const PhotoFile& file, const QString& picture_name);

}  // namespace pmts::job
