#pragma once

#include <QtGlobal>

#include <optional>

class QSettings;

namespace pmts::app {

/// Which slope distances are drawn over a picture; an absent end has no limit.
struct DepthFilter {
    std::optional<double> near_m;
    std::optional<double> far_m;

    [[nodiscard]] bool passes(double slope_distance_m) const {
        return (!near_m || slope_distance_m >= *near_m) && (!far_m || slope_distance_m <= *far_m);
    }
    [[nodiscard]] bool operator==(const DepthFilter&) const = default;
};

/// What the tools of the pictures remember between two starts; a part of Settings.
struct ImageToolSettings {
    static constexpr double kLeastMagnification = 2.0;
    static constexpr double kMostMagnification = 16.0;
    static constexpr double kShortest_m = 0.5;  ///< of any range that may be typed
    static constexpr double kLongest_m = 5000.0;

    bool snap = false;  ///< a click takes the corner, crossing, circle or ellipse beside it
    double loupe_magnification = 8.0;
    double parallax_near_m = 2.0;  ///< ends of the curve on which the telescope's axis meets the view
    double parallax_far_m = 200.0;
    DepthFilter depth;

    /// Missing or unreadable entries keep their default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
