#pragma once

#include "pmts/app/lab/calibration_record.hpp"
#include "pmts/app/settings/unit_format.hpp"
#include "pmts/calibration/self_calibration.hpp"

#include <QPointF>
#include <QSize>
#include <QStringList>

#include <vector>

namespace pmts::app {

/// One parameter of a calibration as a person reads it.
struct CalibratedParameter {
    QString name;       ///< `focal length`
    QString value;      ///< `1400.12 px`
    QString deviation;  ///< `± 0.07 px`; `kept` when the pictures cannot tell it
    QString change;     ///< against the rig it is compared with: `+12.4 px`
    bool held = false;
};

/// What a picture leaves over: where the spot was seen, and modelled less seen pixel.
struct PlottedResidual {
    QPointF px;
    QPointF residual_px;
    int spot = 0;
    bool outlier = false;
};

/// A calibration ready to be shown.
struct SelfCalibrationView {
    QStringList verdict;  ///< the first sentence says how good
    std::vector<CalibratedParameter> parameters;
    std::vector<PlottedResidual> residuals;
    QSize frame_px;
    QPointF centre_px;
    QStringList correlated;                        ///< names of the free parameters
    QStringList symbols;                           ///< of the same: `f`, `cx`, `yaw`
    std::vector<std::vector<double>> correlation;  ///< in their order
    QString quality;  ///< `0.012 px in the fit, 0.014 px in pictures left out of it`
};

[[nodiscard]] SelfCalibrationView viewOf(const calibration::SelfCalibration& found,
                                         const std::vector<calibration::SweptSpot>& spots,
                                         const camera::Rig& compared_with, const UnitFormat& units);

/// The proof that goes with the rig when it is accepted; camera and instrument are the caller's.
[[nodiscard]] CalibrationRecord recordOf(const calibration::SelfCalibration& found,
                                         const std::vector<calibration::SweptSpot>& spots);

}  // namespace pmts::app
