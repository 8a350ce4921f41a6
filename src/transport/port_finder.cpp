#include "pmts/transport/port_finder.hpp"

#include <QSerialPortInfo>
#include <QStringList>

#include <algorithm>

namespace pmts::transport {
namespace {

PortInfo portInfo(const QSerialPortInfo& info) {
    PortInfo port{.path = info.systemLocation(),
                  .description = info.description(),
                  .manufacturer = info.manufacturer(),
                  .serial_number = info.serialNumber(),
                  .usb_vendor = std::nullopt,
                  .usb_product = std::nullopt};
    if (info.hasVendorIdentifier() && info.hasProductIdentifier()) {
        port.usb_vendor = info.vendorIdentifier();
        port.usb_product = info.productIdentifier();
    }
    return port;
}

bool isSameAdapter(const PortIdentity& wanted, const PortInfo& port) {
    return port.usb_vendor == wanted.usb_vendor && port.usb_product == wanted.usb_product &&
           port.serial_number == wanted.usb_serial_number;
}

}  // namespace

PortIdentity PortInfo::identity() const {
    return {.usb_vendor = usb_vendor,
            .usb_product = usb_product,
            .usb_serial_number = usb_vendor ? serial_number : QString(),
            .last_path = path};
}

QString PortInfo::friendlyName() const {
    QStringList words{description, manufacturer, serial_number};
    words.removeAll(QString());
    words.removeDuplicates();
    return words.isEmpty() ? path : QStringLiteral("%1 (%2)").arg(words.join(QStringLiteral(", ")), path);
}

std::vector<PortInfo> listPorts() {
    std::vector<PortInfo> ports;
    for (const auto& info : QSerialPortInfo::availablePorts()) {
        ports.push_back(portInfo(info));
    }
    std::ranges::sort(
        ports, {}, [](const PortInfo& port) { return std::pair(!port.usb_vendor.has_value(), port.path); });
    return ports;
}

std::optional<PortInfo> findAgain(const PortIdentity& wanted, const std::vector<PortInfo>& present) {
    std::vector<PortInfo> same;
    std::ranges::copy_if(present, std::back_inserter(same), [&wanted](const PortInfo& port) {
        return wanted.usb_vendor ? isSameAdapter(wanted, port)
                                 : port.path == wanted.last_path && !port.usb_vendor;
    });
    if (same.size() > 1) {  // twins: only the place tells them apart
        std::erase_if(same, [&wanted](const PortInfo& port) { return port.path != wanted.last_path; });
    }
    return same.size() == 1 ? std::optional(same.front()) : std::nullopt;
}

std::optional<PortInfo> findAgain(const PortIdentity& wanted) { return findAgain(wanted, listPorts()); }

}  // namespace pmts::transport
