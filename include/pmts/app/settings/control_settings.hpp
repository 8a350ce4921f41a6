#pragma once

#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/instrument/control_settings.hpp"

#include <QSettings>

#include <optional>

namespace pmts::app {

/// Who may command the instrument, and the second port through which a panel does.
struct ControlSettings {
    std::optional<SerialChoice> panel;  ///< absent: one port
    scheduler::ControlMode mode = scheduler::ControlMode::kShared;
    instrument::PathSwitch path_switch;

    [[nodiscard]] bool operator==(const ControlSettings&) const = default;

    /// What is missing or out of range keeps its default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
