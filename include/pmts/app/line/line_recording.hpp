#pragma once

#include "pmts/protocol/line_decoding.hpp"

#include <QString>

#include <optional>
#include <vector>

namespace pmts::app {

/// What a file of the lab holds: levels of lines, or bytes that went over one.
struct LineRecording {
    QString path;
    protocol::CaptureFormat format = protocol::CaptureFormat::kSamples;
    protocol::LineCapture capture;                 ///< without lines: bytes only
    std::vector<protocol::DecodedCharacter> said;  ///< of a log of PMTS (samples are microseconds) or of stored bytes
    std::optional<double> samples_per_s;           ///< of either

    [[nodiscard]] bool hasLevels() const { return capture.lines > 0; }
};

/// `1 MHz`, `500 kHz`, `1,5 MS/s`, `115200`; absent when it says nothing of the kind.
[[nodiscard]] std::optional<double> sampleRateFrom(const QString& text);

/// Reads what the protocol room knows, sigrok's session files (a zip archive with `metadata` and `logic-1-N`), PMTS's black
/// boxes and session logs, and stored bytes. `format` absent: told from the first bytes; `samples_per_s` goes before what the
/// file says. kFile when it cannot be read, kBadInput when it holds nothing, kCancelled.
[[nodiscard]] core::Result<LineRecording> readLineRecording(const QString& path,
                                                            std::optional<protocol::CaptureFormat> format,
                                                            std::optional<double> samples_per_s,
                                                            const protocol::Progress& progress = {});

}  // namespace pmts::app
