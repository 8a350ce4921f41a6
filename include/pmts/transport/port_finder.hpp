#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace pmts::transport {

/// What stays the same when a USB adapter is pulled and comes back under another name. Kept in the settings.
struct PortIdentity {
    std::optional<std::uint16_t> usb_vendor;
    std::optional<std::uint16_t> usb_product;
    QString usb_serial_number;
    QString last_path;  ///< decides between twins without a serial number, and for ports that are not USB

    [[nodiscard]] bool operator==(const PortIdentity&) const = default;
};

/// A serial port of this computer, for the port list.
struct PortInfo {
    QString path;  ///< `/dev/ttyUSB0`, what SerialSettings::port_name takes
    QString description;
    QString manufacturer;
    QString serial_number;
    std::optional<std::uint16_t> usb_vendor;
    std::optional<std::uint16_t> usb_product;

    [[nodiscard]] PortIdentity identity() const;
    /// `FT232R USB UART, FTDI, A50285BI (/dev/ttyUSB0)`
    [[nodiscard]] QString friendlyName() const;
    [[nodiscard]] bool operator==(const PortInfo&) const = default;
};

/// USB adapters first, then the rest, each by path. A pty is never listed: port choosers need an editable
/// path.
[[nodiscard]] std::vector<PortInfo> listPorts();

/// The same adapter among the ports present now, whatever its name; absent when it is not plugged in or
/// cannot be told from another one.
[[nodiscard]] std::optional<PortInfo> findAgain(const PortIdentity& wanted,
                                                const std::vector<PortInfo>& present);
[[nodiscard]] std::optional<PortInfo> findAgain(const PortIdentity& wanted);

}  // namespace pmts::transport
