#pragma once

#include "pmts/core/result.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace pmts::protocol {

// Commands of the external dialect (A), protocol page section 2. Values here, bytes by encode(); no I/O.

enum class Device { kStation, kControlUnit };                    ///< second letter G or R
enum class ReadForm { kStandard, kNames, kDataOnly, kSeparate };  ///< S, N, D, V
enum class EdmMode { kStd = 0, kTrk = 1, kDBar = 2, kFstd = 3, kDBarHighResolution = 4 };
enum class TriggerRange { kNormal, kShort, kLong };              ///< TG, TG<, TG>
enum class Directory { kJob, kArea, kUserSequence, kGeodatProtocol, kAll };  ///< M I U D *

struct ReadMeasurement { ReadForm form = ReadForm::kStandard; Device device = Device::kStation; };
struct ReadLabel { int label = 0; ReadForm form = ReadForm::kStandard; Device device = Device::kStation; };
struct SignalTest {};
struct WriteLabel { int label = 0; std::string data; Device device = Device::kStation; };
struct Trigger { TriggerRange range = TriggerRange::kNormal; };
/// At least one axis; tolerance in cc 0..99, 0 lets the instrument choose (about 2 cc).
struct Position { std::optional<int> ha_tolerance_cc; std::optional<int> va_tolerance_cc; };
struct SetMode { EdmMode mode = EdmMode::kStd; };
struct ListFiles { Directory directory = Directory::kJob; };
struct OutputFile { Directory directory = Directory::kJob; std::string name; std::optional<int> via_protocol; };
struct LoadFile { Directory directory = Directory::kJob; std::string name; std::optional<int> via_protocol; };
struct FreeMemory { Device device = Device::kStation; };
struct EraseFile { Directory directory = Directory::kJob; std::string name; };  ///< destructive: on the deny list
struct CalibrateCompensator {};  ///< PV,20
struct SwitchOff {};             ///< PV,21

using Command = std::variant<ReadMeasurement, ReadLabel, SignalTest, WriteLabel, Trigger, Position, SetMode, ListFiles,
                             OutputFile, LoadFile, FreeMemory, EraseFile, CalibrateCompensator, SwitchOff>;

/// Bytes of a command, CR at the end. Throws std::logic_error for values no instrument has (label 1000, tolerance 100).
[[nodiscard]] std::string encode(const Command& command);

/// Refuses what must never be sent without an explicit "unsafe": K..., LV..., OV*, label 127 and writes to labels >= 100.
/// `line` is raw text, as a console would send it.
[[nodiscard]] core::Result<void> checkDenyList(std::string_view line);

}  // namespace pmts::protocol
