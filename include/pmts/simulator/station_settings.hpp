#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/simulator/line_framing.hpp"

#include <QString>

#include <optional>
#include <vector>

namespace pmts::simulator {

/// Spread of a distance: constant part and part that grows with it, both one sigma.
struct EdmAccuracy {
    double constant_m = 0.003;
    double ppm = 3.0;
};

/// What the protocol page leaves open, and what a test wants otherwise. Every "sim default" of the page is a
/// field here. Times are the instrument's own; time_scale makes all of them shorter.
struct StationSettings {
    unsigned seed = 1;
    double time_scale = 1.0;  ///< 2: motors, EDM and the wire run twice as fast
    double baud = 9600.0;     ///< pace of both directions, ten bits a byte; 0: at once
    /// Label 78: who sets his port otherwise reads and sends garbage. Absent: every setting is understood.
    std::optional<LineFraming> line;

    // Motors and circles.
    double speed_gon_s = 50.0;
    double acceleration_gon_s2 = 100.0;
    core::Duration settle = std::chrono::seconds(1);
    core::Angle angle_sigma = core::Angle::fromCc(3);  ///< of each reading of a circle
    core::Angle collimation, index_error, trunnion_error;
    core::Angle tilt_north, tilt_east;                          ///< of the standing axis
    core::Angle compensator_range = core::Angle::fromGon(0.1);  ///< beyond it: status 1
    core::Angle usual_tolerance = core::Angle::fromCc(2);       ///< of a positioning with tolerance 00
    core::Angle blocked_va_from = core::Angle::fromGon(160.0);  ///< the telescope meets the foot
    core::Angle blocked_va_to = core::Angle::fromGon(240.0);
    int out_of_range_status = 160;          ///< or 153
    bool mode_command_stops_motion = true;  ///< the page knows no stop: PG,3 ends a motion with 190
    bool refuse_face_two = false;           ///< serial commands in face II get 24

    // Distance meter.
    core::Duration std_time = std::chrono::seconds(5);
    core::Duration fast_std_time = std::chrono::seconds(1);
    core::Duration trk_interval = std::chrono::milliseconds(400);
    core::Duration d_bar_first = std::chrono::seconds(5);
    core::Duration d_bar_interval = std::chrono::seconds(1);
    core::Duration long_range_extra = std::chrono::seconds(2);       ///< TG> in STD
    core::Duration retry_interval = std::chrono::milliseconds(500);  ///< between two tries without echo
    bool reflectorless = false;  ///< the DR unit: its own time instead of std_time
    core::Duration dr_time = std::chrono::seconds(2);
    core::Duration dr_time_per_m = std::chrono::milliseconds(20);
    double edm_sigma_m = 0.003, edm_sigma_ppm = 3.0;  ///< STD
    EdmAccuracy trk_accuracy{0.010, 5.0};
    EdmAccuracy fast_std_accuracy{0.005, 5.0};
    EdmAccuracy d_bar_accuracy{0.006, 2.0};  ///< of one reading: ten of them make 2 mm
    EdmAccuracy d_bar_high_resolution_accuracy{0.003, 2.0};
    double longest_range_m = 5000.0;    ///< beyond it no signal
    int no_signal_status = 0;           ///< 0: tries without end and says nothing; 166: gives up
    bool trigger_ends_late = false;     ///< EOT of TG at the end of the measurement instead of at once
    bool prism_constant_added = false;  ///< label 33 is added to the distance
    bool target_test = true;            ///< 30 cm / 50 mgon
    int target_test_status = 4;
    double air_temperature_degc = 20.0;  ///< the true air; the labels start with the same values
    double air_pressure_mbar = 1013.0;

    // What is answered.
    QString unit_status = QStringLiteral("1111");
    int mbar_digit = 1;  ///< first digit of label 23 that means mbar; mmHg is the other of 1 and 2
    QString serial_number = QStringLiteral("620123");
    int angle_decimals = 4;
    int length_decimals = 3;
    int end_mark = 62;
    bool end_mark_changes_at_once = true;  ///< the answer to WG,79 already ends with the new mark
    std::optional<int> status_suffix;      ///< 8: `35.8` instead of `35`; status 0 stays bare
    QString reading_while_measuring = QStringLiteral("angles");   ///< or "4", "7"
    QString reading_without_distance = QStringLiteral("angles");  ///< or "7"
    QString reading_of_old_distance = QStringLiteral("3");        ///< or "3+angles"
    int status_without_distance = 7;                              ///< RG,9 when there is none
    int read_only_status = 41;                                    ///< WG to a measured label
    bool sign_and_point_count = false;                            ///< as part of the nine digits
    int max_command_length = 80;
    int queue_limit = 10;
    core::Duration turn_around{0};  ///< from the CR to the first byte of the answer
    core::Duration unterminated_after = std::chrono::seconds(10);
    int unterminated_status = 217;  ///< 0: silence
    core::Duration load_time_out = std::chrono::seconds(10);

    // Modes of the whole instrument.
    bool bare_station = false;  ///< behaviour 13: TG without effect, writes answer 0.0
    bool starts_switched_off = false;
    bool ask_to_continue = true;  ///< `!` after switching on within two hours
    core::Duration values_kept = std::chrono::hours(2);
    core::Duration switch_off_when_idle{0};  ///< 0: never; the 400 does it after 60 s
    core::Duration calibration_per_face = std::chrono::seconds(7);
    bool calibration_asks = false;  ///< `!` after PV,20, before it turns: Y or N
    QString output = QStringLiteral("request");  ///< or reg_key, slave
    std::vector<int> output_table;               ///< labels of a block; empty: table 0, the mode's own
    bool unsolicited_status = false;             ///< blocks without request begin with a status line
    bool slave_block_counts_as_reading = false;
    int memory_bytes = 60000;
};

/// Fails with kBadInput naming the setting that no instrument can have. A station made with it would throw.
[[nodiscard]] core::Result<void> checkSettings(const StationSettings& settings);

}  // namespace pmts::simulator
