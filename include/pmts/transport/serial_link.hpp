#pragma once

#include "pmts/transport/byte_link.hpp"

#include <memory>

namespace pmts::transport {

enum class Parity { kNone, kOdd, kEven };
enum class FlowControl { kNone, kHardware, kSoftware };

/// How a port is opened: a value, copied to the thread that owns the port.
struct SerialSettings {
    QString port_name;  ///< `/dev/ttyUSB0`, `ttyUSB0`, `COM3`, or the path of a pty or a link to one
    int baud = 9600;
    int data_bits = 8;
    Parity parity = Parity::kNone;
    int stop_bits = 1;
    FlowControl flow_control = FlowControl::kNone;

    /// `9600 8N1`
    [[nodiscard]] QString lineText() const;
    [[nodiscard]] bool operator==(const SerialSettings&) const = default;
};

/// A serial port. Belongs to the thread that opens it, which needs an event loop.
/// A vanished device closes the link and is reported once; a setting the device does not know is logged and
/// lived with.
class SerialLink final : public ByteLink {
public:
    explicit SerialLink(SerialSettings settings);
    ~SerialLink() override;

    /// Fails with kPortUnavailable: missing, used by another program, no permission, not a serial port.
    [[nodiscard]] core::Result<void> open() override;
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    void write(std::string_view bytes) override;
    [[nodiscard]] core::Result<void> setControlLines(const ControlLines& lines) override;
    [[nodiscard]] core::Result<void> setBreak(bool on) override;
    /// `/dev/ttyUSB0 at 9600 8N1`, with what the device could not be set to, if anything.
    [[nodiscard]] QString description() const override;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::transport
