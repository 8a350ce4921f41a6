#pragma once

#include "pmts/core/result.hpp"
#include "pmts/video/video_source.hpp"

#include <Eigen/Core>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonObject>
#include <QSize>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace pmts::app {

/// A camera as it stands: which one, in which mode, how it is focused. What is not known is left empty and fits everything.
struct CameraUse {
    video::SourceKind source = video::SourceKind::kSimulated;
    QString camera{};                ///< name as the camera list shows it
    QSize size{};                    ///< px
    QString pixel_format{};          ///< MJPG, YUYV ...
    std::optional<double> focus{};   ///< the camera's own number
    std::optional<double> zoom{};    ///< the camera's own number

    [[nodiscard]] bool operator==(const CameraUse&) const = default;
    [[nodiscard]] bool isSimulated() const { return source == video::SourceKind::kSimulated; }
};

/// `HD Pro Webcam, 1280x720 MJPG, focus 30`.
[[nodiscard]] QString useText(const CameraUse& use);

enum class CalibrationMethod {
    kOther,
    kSelfCalibration,    ///< sweep over one natural spot
    kSightings,          ///< targets of a photo sighted with the telescope
    kDistortionTable,    ///< thesis 5.5.1.7
    kBoard,              ///< chessboard or ChArUco views
    kMounting,           ///< twist and parallax boards
    kImported,
};
[[nodiscard]] QString methodText(CalibrationMethod method);

/// One residual of a calibration: modelled less observed, px.
struct RecordedResidual {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Eigen::Vector2d residual_px = Eigen::Vector2d::Zero();
    bool held_out = false;  ///< not used in the fit
};

/// How a rig came to be: everything that a report says about it.
struct CalibrationRecord {
    CalibrationMethod method = CalibrationMethod::kOther;
    QDateTime utc{};
    double rms_px = 0.0;                      ///< of the fit, over coordinates
    std::optional<double> held_out_px{};        ///< rms of what the fit did not see, over coordinates
    std::optional<double> temperature_c{};
    CameraUse camera{};
    QString instrument{};                       ///< type and serial number, empty when unknown
    QString remark{};
    /// By the parameter's name with its unit, as calibration::parameterName() gives it. Absent: not determined.
    std::map<QString, double> standard_deviations{};
    std::vector<RecordedResidual> residuals{};  ///< for the plots of the report; may be empty
};

[[nodiscard]] QJsonArray residualsToJson(const std::vector<RecordedResidual>& residuals);
[[nodiscard]] std::vector<RecordedResidual> residualsFromJson(const QJsonArray& rows);
[[nodiscard]] QJsonObject cameraUseToJson(const CameraUse& use);
[[nodiscard]] CameraUse cameraUseFromJson(const QJsonObject& json);
/// Every entry may be missing: an old file has fewer.
[[nodiscard]] QJsonObject calibrationRecordToJson(const CalibrationRecord& record);
[[nodiscard]] CalibrationRecord calibrationRecordFromJson(const QJsonObject& json);

}  // namespace pmts::app
