#pragma once

#include "pmts/protocol/line_capture.hpp"

namespace pmts::line {

/// Reads a capture in any format that the protocol room knows, and sigrok's session files (a zip archive with `metadata`
/// and `logic-1-N`). kFile when it cannot be read, kBadInput when it holds no capture.
[[nodiscard]] core::Result<protocol::LineCapture> readCapture(const QString& path,
                                                              std::optional<protocol::CaptureFormat> format,
                                                              std::optional<double> samples_per_s);

}  // namespace pmts::line
