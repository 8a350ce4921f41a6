#pragma once

#include <QString>

#include <optional>
#include <string>
#include <string_view>

namespace pmts::simulator {

enum class WireParity { kNone, kOdd, kEven };

/// How one end of a serial line talks (protocol page 1.1, label 78).
struct LineFraming {
    int baud = 9600;
    int data_bits = 8;  ///< 7 or 8
    WireParity parity = WireParity::kNone;
    int stop_bits = 1;

    [[nodiscard]] bool operator==(const LineFraming&) const = default;
    [[nodiscard]] QString text() const;  ///< `4800-8N1`
    /// `4800-8N1`, `9600-7e1`; absent when it is none.
    [[nodiscard]] static std::optional<LineFraming> fromText(const QString& text);
};

/// The bytes that a receiver reads off a wire, bit by bit in the middle of its own bits, when the sender writes them
/// without pause: the same ones where both ends agree, else garbage as on a real line. Bytes with a wrong parity or stop
/// bit are dropped, as serial drivers are usually told to.
[[nodiscard]] std::string heardAs(std::string_view bytes, const LineFraming& sent, const LineFraming& heard);

}  // namespace pmts::simulator
