#include "serial_keeping.hpp"

#include "settings/setting_values.hpp"

#include <limits>

namespace pmts::app {

namespace {

using UsbNumber = std::optional<std::uint16_t>;

UsbNumber usbNumber(const QSettings& file, const QString& key) {
    bool is_number = false;
    const uint number = file.value(key).toUInt(&is_number);
    const bool fits = is_number && number > 0 && number <= std::numeric_limits<std::uint16_t>::max();
    return fits ? UsbNumber(static_cast<std::uint16_t>(number)) : std::nullopt;
}

int wholeFrom(const QSettings& file, const QString& key, int fallback, int least, int most) {
    return static_cast<int>(numberFrom(file, key.toLatin1().constData(), fallback, least, most));
}

}  // namespace

SerialChoice serialFrom(const QSettings& file, const QString& prefix) {
    SerialChoice port;
    port.path = file.value(prefix + QStringLiteral("path")).toString();
    port.adapter.usb_serial_number = file.value(prefix + QStringLiteral("usb_serial_number")).toString();
    port.adapter.usb_vendor = usbNumber(file, prefix + QStringLiteral("usb_vendor"));
    port.adapter.usb_product = usbNumber(file, prefix + QStringLiteral("usb_product"));
    port.adapter.last_path = port.path;
    port.baud = wholeFrom(file, prefix + QStringLiteral("baud"), port.baud, 50, 115200);
    port.data_bits = wholeFrom(file, prefix + QStringLiteral("data_bits"), port.data_bits, 7, 8);
    port.parity = enumFrom(file, (prefix + QStringLiteral("parity")).toLatin1().constData(), port.parity,
                           static_cast<int>(Parity::kEven));
    port.stop_bits = wholeFrom(file, prefix + QStringLiteral("stop_bits"), port.stop_bits, 1, 2);
    port.dialect = enumFrom(file, (prefix + QStringLiteral("dialect")).toLatin1().constData(), port.dialect,
                            static_cast<int>(instrument::LineDialect::kBus));
    return port;
}

void saveSerial(QSettings& file, const QString& prefix, const SerialChoice& port) {
    file.setValue(prefix + QStringLiteral("path"), port.path);
    file.setValue(prefix + QStringLiteral("usb_serial_number"), port.adapter.usb_serial_number);
    file.setValue(prefix + QStringLiteral("usb_vendor"), port.adapter.usb_vendor.value_or(0));
    file.setValue(prefix + QStringLiteral("usb_product"), port.adapter.usb_product.value_or(0));
    file.setValue(prefix + QStringLiteral("baud"), port.baud);
    file.setValue(prefix + QStringLiteral("data_bits"), port.data_bits);
    file.setValue(prefix + QStringLiteral("parity"), static_cast<int>(port.parity));
    file.setValue(prefix + QStringLiteral("stop_bits"), port.stop_bits);
    file.setValue(prefix + QStringLiteral("dialect"), static_cast<int>(port.dialect));
}

}  // namespace pmts::app
