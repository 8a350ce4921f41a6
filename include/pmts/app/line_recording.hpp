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
    std::vector<protocol::DecodedCharacter> said;  ///< of a session log (samples are microseconds) or of stored bytes
    std::optional<double> samples_per_s;           ///< of either

    [[nodiscard]] bool hasLevels() const { return capture.lines > 0; }
};

/// Reads what the protocol room knows, sigrok's session files (a zip archive with `metadata` and `logic-1-N`), logs of
/// PMTS's own recorder and stored bytes. `format` absent: told from the first bytes; `samples_per_s` goes before what the
/// file says. kFile when it cannot be read, kBadInput when it holds nothing, kCancelled.
[[nodiscard]] core::Result<LineRecording> readLineRecording(const QString& path,
                                                            std::optional<protocol::CaptureFormat> format,
                                                            std::optional<double> samples_per_s,
                                                            const protocol::Progress& progress = {});

}  // namespace pmts::app
