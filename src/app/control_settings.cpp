#include "pmts/app/control_settings.hpp"

#include "setting_values.hpp"

namespace pmts::app {

using instrument::LineInModes;
using scheduler::ControlMode;

namespace {

QString key(const char* name) { return QStringLiteral("control/") + QLatin1String(name); }

/// `shared, panel`: the modes in which a line is asserted; absent: the line is left alone.
std::optional<LineInModes> lineFrom(const QSettings& file, const char* name) {
    if (!file.contains(key(name))) {
        return std::nullopt;
    }
    const QStringList modes = file.value(key(name)).toStringList();
    return LineInModes{.shared = modes.contains(QStringLiteral("shared")),
                       .computer = modes.contains(QStringLiteral("computer")),
                       .panel = modes.contains(QStringLiteral("panel"))};
}

void saveLine(QSettings& file, const char* name, const std::optional<LineInModes>& line) {
    if (!line) {
        return;
    }
    QStringList modes;
    for (const auto& [asserted, mode] : {std::pair(line->shared, "shared"), std::pair(line->computer, "computer"),
                                         std::pair(line->panel, "panel")}) {
        if (asserted) {
            modes << QLatin1String(mode);
        }
    }
    file.setValue(key(name), modes);
}

std::optional<std::uint16_t> usbNumber(const QSettings& file, const char* name) {
    bool is_number = false;
    const uint number = file.value(key(name)).toUInt(&is_number);
    return is_number && number > 0 && number <= 0xFFFF ? std::optional(static_cast<std::uint16_t>(number)) : std::nullopt;
}

std::optional<SerialChoice> panelFrom(const QSettings& file) {
    SerialChoice panel;
    panel.path = file.value(key("panel_path")).toString();
    if (panel.path.isEmpty()) {
        return std::nullopt;
    }
    panel.adapter.usb_serial_number = file.value(key("panel_usb_serial_number")).toString();
    panel.adapter.usb_vendor = usbNumber(file, "panel_usb_vendor");
    panel.adapter.usb_product = usbNumber(file, "panel_usb_product");
    panel.adapter.last_path = panel.path;
    panel.baud = static_cast<int>(numberFrom(file, "control/panel_baud", panel.baud, 50, 115200));
    panel.data_bits = static_cast<int>(numberFrom(file, "control/panel_data_bits", panel.data_bits, 7, 8));
    panel.parity = enumFrom(file, "control/panel_parity", panel.parity, static_cast<int>(Parity::kEven));
    panel.stop_bits = static_cast<int>(numberFrom(file, "control/panel_stop_bits", panel.stop_bits, 1, 2));
    return panel;
}

void savePanel(QSettings& file, const SerialChoice& panel) {
    file.setValue(key("panel_path"), panel.path);
    file.setValue(key("panel_usb_serial_number"), panel.adapter.usb_serial_number);
    file.setValue(key("panel_usb_vendor"), panel.adapter.usb_vendor.value_or(0));
    file.setValue(key("panel_usb_product"), panel.adapter.usb_product.value_or(0));
    file.setValue(key("panel_baud"), panel.baud);
    file.setValue(key("panel_data_bits"), panel.data_bits);
    file.setValue(key("panel_parity"), static_cast<int>(panel.parity));
    file.setValue(key("panel_stop_bits"), panel.stop_bits);
}

}  // namespace

void ControlSettings::load(const QSettings& file) {
    panel = panelFrom(file);
    mode = enumFrom(file, "control/mode", mode, static_cast<int>(ControlMode::kPanel));
    path_switch.dtr = lineFrom(file, "dtr");
    path_switch.rts = lineFrom(file, "rts");
    path_switch.inverted = file.value(key("inverted"), path_switch.inverted).toBool();
}

void ControlSettings::save(QSettings& file) const {
    file.remove(QStringLiteral("control"));  // a panel or a line that was taken away must not come back
    if (panel) {
        savePanel(file, *panel);
    }
    file.setValue(key("mode"), static_cast<int>(mode));
    saveLine(file, "dtr", path_switch.dtr);
    saveLine(file, "rts", path_switch.rts);
    file.setValue(key("inverted"), path_switch.inverted);
}

}  // namespace pmts::app
