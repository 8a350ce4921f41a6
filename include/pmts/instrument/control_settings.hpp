#pragma once

#include "pmts/scheduler/control.hpp"
#include "pmts/transport/byte_link.hpp"

#include <QString>

#include <optional>

namespace pmts::instrument {

/// In which modes of control a line of the instrument's port is asserted.
struct LineInModes {
    bool shared = false;
    bool computer = false;
    bool panel = true;

    [[nodiscard]] bool operator==(const LineInModes&) const = default;
};

/// A switch box that the DTR and RTS lines drive: it connects the panel to the instrument directly, or both through
/// the computer (thesis ch. 3, interface unit). Absent lines are left alone.
struct PathSwitch {
    std::optional<LineInModes> dtr;
    std::optional<LineInModes> rts;
    bool inverted = false;  ///< the box takes an asserted line for off

    [[nodiscard]] transport::ControlLines linesIn(scheduler::ControlMode mode) const;
    [[nodiscard]] bool operator==(const PathSwitch&) const = default;
};

enum class PanelPortState {
    kNone,     ///< one port: no panel is connected through us
    kOpen,
    kMissing,  ///< tried again until it is back
};

/// Who has control, for the switch, the lamp and the counters.
struct ControlStatus {
    scheduler::ControlMode mode = scheduler::ControlMode::kShared;
    scheduler::ControlMode wanted = scheduler::ControlMode::kShared;  ///< not `mode` while a transaction is finished first
    scheduler::LineOwner owner = scheduler::LineOwner::kIdle;
    core::Duration owner_since{0};
    scheduler::ControlCounts counts;
    PanelPortState panel = PanelPortState::kNone;
    QString panel_sentence;  ///< why it is missing
    QString switch_sentence;  ///< why the switch box cannot be driven; empty when it can or there is none

    [[nodiscard]] bool operator==(const ControlStatus&) const = default;
};

/// What a request is told while the panel has control.
[[nodiscard]] core::Error panelHasControl();
[[nodiscard]] bool isPanelControl(const core::Error& error);

}  // namespace pmts::instrument
