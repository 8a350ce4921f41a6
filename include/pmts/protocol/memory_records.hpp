#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/protocol/memory_file.hpp"
#include "pmts/protocol/units.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pmts::protocol {

/// N, E, elevation of labels 37, 38, 39, metres; absent what the file does not say.
struct FileCoordinates {
    std::optional<double> n_m, e_m, h_m;
};

/// Begins at `2=`. The instrument height may come as late as after the backsight.
struct FileStation {
    int line = 0;
    std::string name;
    FileCoordinates coordinates;
    std::optional<double> instrument_height_m;
};

/// Begins at `5=` (a target, or a point of an area) or at `62=` (a backsight).
struct FilePoint {
    int line = 0;
    std::string name;
    std::string code;
    bool is_backsight = false;
    std::optional<std::size_t> station;             ///< index into MemoryRecords::stations
    std::optional<core::Angle> ha, va;              ///< labels 7, 8: face I, or the mean where 24, 25 are there too
    std::optional<core::Angle> ha_one, va_one;      ///< face I of a mean: labels 24, 25
    std::optional<core::Angle> ha_two, va_two;      ///< face II: labels 17, 18
    std::optional<double> slope_distance_m;         ///< label 9
    std::optional<double> horizontal_distance_m;    ///< label 11: some jobs have it instead
    std::optional<double> target_height_m;          ///< label 6
    FileCoordinates coordinates;
};

/// A direction in face I.
struct FileDirection {
    core::Angle ha, va;
};
/// Face I alone: 24, 25, or else 7, 8. Absent when either is missing.
[[nodiscard]] std::optional<FileDirection> faceOneOf(const FilePoint& point);
/// The mean of both faces: 7, 8 of a block that has 24, 25 beside them, else computed, HA - 200 gon and 400 gon - VA of
/// face II (protocol page 4.4, 4.5). Absent when the point was observed in one face.
[[nodiscard]] std::optional<FileDirection> meanOfFaces(const FilePoint& point);

/// A value that is no number of its label's kind.
struct BadValue {
    int line = 0;
    int label = 0;
    std::string data;
};

/// What a file says about stations and points.
struct MemoryRecords {
    std::vector<FileStation> stations;
    std::vector<FilePoint> points;
    std::vector<BadValue> bad;
};

/// Label 23 of the file. Absent or unreadable: the units must be asked for, gon and DMS look alike.
[[nodiscard]] std::optional<WireUnits> unitsIn(const MemoryFile& file);

/// Order within a block does not count; labels without a place here are passed over.
[[nodiscard]] MemoryRecords recordsOf(const MemoryFile& file, const WireUnits& units);

/// One point computed again: what the formula gives minus what the file says, metres.
struct PointCheck {
    std::size_t point = 0;  ///< index into MemoryRecords::points
    double dn_m = 0.0, de_m = 0.0, dh_m = 0.0;
    double worst_m = 0.0;   ///< of the three, without its sign
    bool within = false;    ///< all three within kCheckLimit_m
    bool two_faces = false; ///< a mean of faces was there to be tried
};
inline constexpr double kCheckLimit_m = 0.001;

/// HA, VA, SD, IH and SH of each point that has them all must give its 37, 38, 39:
/// Where both faces are there, from their mean or from face I, whichever comes nearer: which one the instrument took in STD
/// is not printed.
///     N = N0 + SD sin VA cos HA   E = E0 + SD sin VA sin HA   ELE = ELE0 + IH + SD cos VA - SH
/// Source: protocol page 4.3. Points without all of it are not in the answer.
[[nodiscard]] std::vector<PointCheck> checkPoints(const MemoryRecords& records);

}  // namespace pmts::protocol
