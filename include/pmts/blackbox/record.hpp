#pragma once

#include "pmts/core/clock.hpp"

#include <QByteArray>
#include <QCborMap>

#include <cstdint>
#include <optional>
#include <string_view>

namespace pmts::blackbox {

/// What a record tells. The numbers stand in files: never give one a new meaning (docs/black-box.md).
enum class Kind : std::uint16_t {
    kSession = 1,      ///< first of each file: program, version, time of day
    kBytes = 2,        ///< bytes of a port, one direction
    kTransaction = 3,  ///< one micro-instruction and its answer
    kFrame = 4,        ///< a picture of the live view
    kAction = 5,       ///< a click, or something that was done
    kAir = 6,          ///< temperature, pressure
    kLog = 7,          ///< a line of the log
    kControl = 8,      ///< who has control
    kMessage = 9,      ///< what the surveyor was told
    kReading = 10,     ///< circle readings
    kConnection = 11,  ///< instrument connected, lost, who it is
    kTick = 12,        ///< a picture came: its time and number only
    kLost = 13,        ///< so many records could not be kept
    kEnd = 14,         ///< the recording was ended on purpose
};

/// One record: what, when (ns on core::Clock's scale), and a CBOR map.
struct Record {
    Kind kind = Kind::kLog;
    core::Duration at{0};
    QByteArray body;

    [[nodiscard]] bool operator==(const Record&) const = default;
};

inline constexpr std::string_view kFileHead = "PMTS black box 1\n";
inline constexpr std::uint32_t kLargestBody = std::uint32_t{1} << 24;
inline constexpr std::size_t kHeadSize = 24;      ///< before the body
inline constexpr std::size_t kRecordFrame = 28;   ///< head and check sum of the body

/// CRC-32 of IEEE 802.3: of `123456789` it is CBF43926.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

/// The record as it stands in the file. Throws std::logic_error for a body larger than kLargestBody.
[[nodiscard]] QByteArray encoded(const Record& record);

/// A record whose head is whole.
struct RecordHead {
    Kind kind = Kind::kLog;
    core::Duration at{0};
    std::uint32_t body_size = 0;
};
/// Absent when there is no record here, or one whose head is damaged.
[[nodiscard]] std::optional<RecordHead> headAt(std::string_view bytes);
/// Whether all of it is here and its body is what was written.
[[nodiscard]] bool isWhole(std::string_view bytes, const RecordHead& head);

/// The body of a record made from a map, and back; an empty map for what is none.
[[nodiscard]] QByteArray bodyOf(const QCborMap& map);
[[nodiscard]] QCborMap mapOf(const QByteArray& body);

}  // namespace pmts::blackbox
