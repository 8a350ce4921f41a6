#pragma once

#include "pmts/core/result.hpp"

#include <QString>

#include <functional>
#include <optional>
#include <string_view>

namespace pmts::transport {

/// The lines of a serial port that carry no data, true: asserted. Absent: left as it is.
struct ControlLines {
    std::optional<bool> dtr;
    std::optional<bool> rts;

    [[nodiscard]] bool operator==(const ControlLines&) const = default;
};

/// A pipe of bytes: serial port, in-memory pair, pty and replayed log look alike. Used on one thread only.
/// Callbacks run from the event loop, never inside write(). on_lost is called once for each loss; afterwards write() drops its bytes.
class ByteLink {
public:
    virtual ~ByteLink() = default;

    [[nodiscard]] virtual core::Result<void> open() = 0;
    virtual void close() = 0;
    [[nodiscard]] virtual bool isOpen() const = 0;
    virtual void write(std::string_view bytes) = 0;
    /// Fails with kUnsupported where there are no such lines (pty, memory) or the flow control drives them.
    [[nodiscard]] virtual core::Result<void> setControlLines(const ControlLines& lines);
    /// The BREAK condition: the line is held until it is taken off again. Fails with kUnsupported where there is none (pty,
    /// replay).
    [[nodiscard]] virtual core::Result<void> setBreak(bool on);
    /// What a person calls it: `/dev/ttyUSB0 at 9600 8N1`, `memory`, `replay of x.log`.
    [[nodiscard]] virtual QString description() const = 0;

    std::function<void(std::string_view)> on_received;
    std::function<void(const core::Error&)> on_lost;
};

}  // namespace pmts::transport
