#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/targeting/sun_position.hpp"

#include <QString>

#include <optional>
#include <vector>

namespace pmts::targeting {

/// Where the instrument may point at all.
struct MotionLimits {
    core::Angle highest = core::Angle::fromGon(0);  ///< zenith angle of the line of sight, either face
    core::Angle lowest = core::Angle::fromGon(200);
    bool face_two_allowed = true;  ///< false: a camera on the telescope would hit something
    /// Circle readings between which it may stand, clockwise from the first to the second.
    std::optional<std::pair<core::Angle, core::Angle>> ha_sector;
};

/// Keeps the telescope and the camera out of the Sun.
struct SunGuard {
    Place place;
    core::Angle azimuth_of_zero;                  ///< true azimuth of circle reading 0: the orientation
    core::Angle cone = core::Angle::fromGon(10);  ///< half angle
};

struct PointingGuardSettings {
    MotionLimits limits;
    std::optional<SunGuard> sun;            ///< absent: place or orientation unknown
    std::optional<core::Angle> most_wound;  ///< cable: turns to either side of where it hung free
};

/// Asked before every move: limits, Sun and cable. Each refusal is kLimit with a sentence that says why and
/// what to do. One thread.
class PointingGuard {
public:
    explicit PointingGuard(const core::Clock& clock, PointingGuardSettings settings = {});

    void setSettings(const PointingGuardSettings& settings) { settings_ = settings; }
    [[nodiscard]] const PointingGuardSettings& settings() const { return settings_; }

    /// May the instrument turn from here to there? Both motors run at one speed and HA goes the short way:
    /// the whole way is looked at, not only its end.
    [[nodiscard]] core::Result<void> check(const geometry::Pointing& from,
                                           const geometry::Pointing& to) const;
    /// Standing still, the Sun comes to the telescope: ask now and then.
    [[nodiscard]] core::Result<void> checkStanding(const geometry::Pointing& at) const;

    /// Every reading, so that the turns of the cable are known, whoever turned the instrument.
    void follow(const geometry::Pointing& at);
    /// How far the cable is wound, clockwise positive; absent before the first reading.
    [[nodiscard]] std::optional<core::Angle> wound() const { return wound_; }
    /// The cable hangs free now.
    void unwound() { wound_ = core::Angle(); }
    /// Readings to pass in order that reach the target the other way round, which unwinds the cable.
    [[nodiscard]] static std::vector<geometry::Pointing> longWay(const geometry::Pointing& from,
                                                                 const geometry::Pointing& to);

    /// Why the Sun is not watched; empty when it is. For the status bar: a guard that sleeps must say so.
    [[nodiscard]] QString sunSleeps() const;

private:
    [[nodiscard]] core::Result<void> checkLimits(const geometry::Pointing& to) const;
    [[nodiscard]] core::Result<void> checkCable(const geometry::Pointing& from,
                                                const geometry::Pointing& to) const;
    [[nodiscard]] core::Result<void> checkSun(const geometry::Pointing& from,
                                              const geometry::Pointing& to) const;

    const core::Clock& clock_;
    PointingGuardSettings settings_;
    std::optional<core::Angle> last_ha_;
    std::optional<core::Angle> wound_;
};

}  // namespace pmts::targeting
