#include "pmts/app/settings/control_settings.hpp"

#include "desk/serial_keeping.hpp"
#include "setting_values.hpp"

namespace pmts::app {

using instrument::LineInModes;
using scheduler::ControlMode;

namespace {

const QString kPanel = QStringLiteral("control/panel_");

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

}  // namespace

void ControlSettings::load(const QSettings& file) {
    const SerialChoice kept = serialFrom(file, kPanel);
    panel = kept.path.isEmpty() ? std::nullopt : std::optional(kept);
    mode = enumFrom(file, "control/mode", mode, static_cast<int>(ControlMode::kPanel));
    path_switch.dtr = lineFrom(file, "dtr");
    path_switch.rts = lineFrom(file, "rts");
    path_switch.inverted = file.value(key("inverted"), path_switch.inverted).toBool();
}

void ControlSettings::save(QSettings& file) const {
    file.remove(QStringLiteral("control"));  // a panel or a line that was taken away must not come back
    if (panel) {
        saveSerial(file, kPanel, *panel);
    }
    file.setValue(key("mode"), static_cast<int>(mode));
    saveLine(file, "dtr", path_switch.dtr);
    saveLine(file, "rts", path_switch.rts);
    file.setValue(key("inverted"), path_switch.inverted);
}

}  // namespace pmts::app
