#pragma once

#include "pmts/geometry/two_faces.hpp"
#include "pmts/instrument/geodimeter_settings.hpp"

#include <QDateTime>
#include <QSettings>

#include <optional>
#include <vector>

namespace pmts::app {

/// A collimation and index test of one instrument, as it was accepted.
struct AxisTestRecord {
    QString serial_number;
    QDateTime utc;
    std::optional<double> temperature_degc;
    geometry::AxisErrors errors;
};

/// Faces, axes and target test: limits, and the newest test of each instrument.
struct InstrumentCareSettings {
    instrument::TargetTest target_test;
    core::Angle axis_limit = core::Angle::fromMgon(20);  ///< collimation and index beyond it: to be adjusted
    double expires_degc = 10.0;                          ///< a test holds within so much of its temperature
    int expires_days = 30;
    core::Angle face_limit = core::Angle::fromMgon(10);  ///< of the difference of both faces, less the tested errors
    double face_limit_m = 0.005;
    std::vector<AxisTestRecord> tests;

    /// What is missing or out of range keeps its default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
    [[nodiscard]] const AxisTestRecord* testOf(const QString& serial_number) const;  ///< null: none
    void keep(const AxisTestRecord& record);                                         ///< in place of an older one
};

}  // namespace pmts::app
