#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/protocol/command.hpp"
#include "pmts/protocol/units.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pmts::instrument {

/// Waiting for a distance in one EDM mode, before anything is learned.
struct EdmTiming {
    core::Duration initial_limit;  ///< L until enough good times are known
    core::Duration cap;            ///< L never grows past it
};

/// Target data test (protocol page 4.5): a pointing that moved further than this since the distance was measured is
/// taken for another point. No label of the instrument's own test is documented; this is the driver's.
struct TargetTest {
    bool on = true;
    core::Angle angle = core::Angle::fromMgon(50);
    double offset_m = 0.30;  ///< within 400 m; grows in proportion beyond

    [[nodiscard]] bool operator==(const TargetTest&) const = default;
};

/// The profile of one instrument: everything the protocol page leaves open. Defaults suit a 5600; values, no
/// behaviour.
struct GeodimeterSettings {
    // Connecting.
    core::Duration probe_limit = std::chrono::milliseconds(1200);  ///< for each of the first questions
    int probe_attempts = 3;
    std::optional<protocol::WireUnits> unit_override;  ///< instead of label 23
    std::optional<protocol::EdmMode> mode_at_connect;  ///< absent: selected with the first distance

    // Motion.
    core::Angle va_min = core::Angle::fromGon(3);    ///< lowest reading the telescope may be sent to
    core::Angle va_max = core::Angle::fromGon(397);  ///< face II included
    std::optional<core::Angle> ha_min;  ///< both or none: the sector clockwise from min to max is allowed
    std::optional<core::Angle> ha_max;
    double speed_gon_s = 50.0;  ///< mechanical; for the progress and the first time limit
    double acceleration_gon_s2 = 100.0;
    core::Duration settle = std::chrono::seconds(1);
    core::Duration motion_limit = std::chrono::seconds(30);  ///< beyond the time the way needs
    core::Angle reading_noise = core::Angle::fromCc(15);     ///< two readings of one pointing differ by less
    int soft_retries = 1;                                    ///< info 155-157, with twice the tolerance
    bool read_back_targets =
        true;  ///< labels 26 and 27 are compared before the motors start (a byte may be lost)

    // Distances.
    std::array<EdmTiming, 5> edm{{
        {std::chrono::seconds(9), std::chrono::seconds(25)},   // STD: 5 s, 7 s at long range
        {std::chrono::seconds(4), std::chrono::seconds(10)},   // TRK
        {std::chrono::seconds(20), std::chrono::seconds(40)},  // D-bar: settles after 10-15 s
        {std::chrono::seconds(5), std::chrono::seconds(15)},   // FSTD
        {std::chrono::seconds(20), std::chrono::seconds(40)},  // D-bar high resolution
    }};
    core::Duration extra_time = std::chrono::seconds(2);       ///< ET: WT = L + ET
    core::Duration averaging_time = std::chrono::seconds(10);  ///< D-bar: how long the mean is let settle
    core::Duration shortest_measurement =
        std::chrono::milliseconds(80);  ///< an answer sooner after TG is an older distance
    core::Duration poll_pause =
        std::chrono::milliseconds(150);  ///< between RG while the end is far; none near it
    int max_polls = 2000;
    int shot_attempts = 2;  ///< triggers for one distance: remeasure class and lost answers, once more
    TargetTest target_test;

    // The line.
    core::Duration read_limit = std::chrono::seconds(3);  ///< for a single label; learned downwards
    core::Duration least_read_limit = std::chrono::milliseconds(400);
    core::Duration write_limit = std::chrono::seconds(3);
    core::Duration file_silence = std::chrono::seconds(5);  ///< ends the wait for the next byte of a file
    core::Duration file_byte_time = std::chrono::microseconds(1042);  ///< pace of a file on its way in: 9600 baud, or ConnectionSettings::byte_time
    core::Duration file_prompt_pause = std::chrono::milliseconds(100);  ///< between `*` and the first line
    core::Duration calibration_limit = std::chrono::seconds(90);  ///< PV,20: silence after which it is asked again
    int retries = 3;        ///< comm and retry class, lost answers of harmless commands
    std::string stop_text;  ///< the page knows no stop command; empty: re-select the mode, `PG,3=n`
    /// Commands around which the video pauses, by their beginning (instruction table, column time critical).
    std::vector<std::string> time_critical{"PV,20"};
    int angle_decimals = 4;  ///< of written targets; 4 shows 1 cc in gon and 1" in DMS
};

}  // namespace pmts::instrument
