#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <QDateTime>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::transport {

// A session log is a text file: one line an event, sessions one after the other. Times in ms since the
// session began.
//
//     # PMTS session log 1
//     @ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1
//           0.000 > RG\r                   to the instrument
//          52.083 < 0\r\n7=10.2345\r\n     from the instrument
//       60000.000 ! The port has gone.     the link was lost
//
// \r \n \t \\ and \xHH stand for bytes that would not show; a blank at the end of a line is \x20.

enum class Direction { kSent, kReceived, kLost };

struct SessionEvent {
    core::Duration at{0};
    Direction direction = Direction::kSent;
    std::string bytes;  ///< kLost: the sentence, UTF-8

    [[nodiscard]] bool operator==(const SessionEvent&) const = default;
};

struct Session {
    QDateTime began_utc;
    QString link;
    std::vector<SessionEvent> events;
};

[[nodiscard]] std::string escapedBytes(std::string_view bytes);
/// Absent when a `\` is followed by something else.
[[nodiscard]] std::optional<std::string> bytesFromEscaped(std::string_view text);
[[nodiscard]] std::string sessionLine(const SessionEvent& event);

/// All sessions of a log. Half-written lines (the program was killed) and remarks are passed over.
/// Fails with kFile when it cannot be read or holds no session, with kCancelled when `wanted`, asked once in 65 536 lines,
/// says false.
[[nodiscard]] core::Result<std::vector<Session>> readSessionLog(const QString& path, const std::function<bool()>& wanted = {});

}  // namespace pmts::transport
