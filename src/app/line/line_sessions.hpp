#pragma once

#include "pmts/app/line/line_recording.hpp"

namespace pmts::app {

/// Whether a file begins as a black box does.
[[nodiscard]] bool isBlackBox(std::string_view bytes);

/// The bytes of every port of a black box, one port behind the other in the order of their first byte, a second between
/// them; several ports and damaged places are told as doubts. Times are microseconds since the first byte of the port.
[[nodiscard]] core::Result<LineRecording> readBlackBox(const QString& path, const protocol::Progress& progress);

/// The sessions of a session log (transport/session_log.hpp), one behind the other, a second between them.
[[nodiscard]] core::Result<LineRecording> readSessions(const QString& path, const protocol::Progress& progress);

}  // namespace pmts::app
