#pragma once

#include "command_line.hpp"

namespace pmts::line {

/// The busiest line of a capture that carries data; kUndefined when none does.
[[nodiscard]] core::Result<int> busiestLine(const protocol::LineCapture& capture);
/// What was asked for, or found by score. kUndefined when the line says nothing that has a framing.
[[nodiscard]] core::Result<protocol::FramingScore> framingFor(const protocol::LineCapture& capture, const Request& request);

/// Texts for the terminal.
[[nodiscard]] QString pinReport(const protocol::LineCapture& capture);
[[nodiscard]] core::Result<QString> decodeReport(const protocol::LineCapture& capture, const Request& request);
[[nodiscard]] core::Result<QString> correlationReport(const protocol::LineCapture& capture, const Request& request);

}  // namespace pmts::line
