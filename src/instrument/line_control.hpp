#pragma once

#include "panel_port.hpp"
#include "pmts/core/task.hpp"
#include "pmts/instrument/instrument_connection.hpp"

namespace pmts::instrument {

/// Who has control of a connection's line: the mode, the panel's port, the switch box, and what is told of it.
class LineControl {
public:
    /// All outlive it. `port`: the instrument's, whose DTR and RTS drive the switch box.
    LineControl(scheduler::Arbiter& arbiter, scheduler::Scheduler& line, transport::ByteLink& port, core::Clock& clock,
                const ConnectionSettings& settings);
    ~LineControl();

    /// To the panel: our requests fail from now on. The line changes hands when its transaction has ended.
    void setMode(scheduler::ControlMode mode);
    void setSwitch(const PathSwitch& path_switch);
    void setLines();  ///< the port was opened
    /// PMTS may send: the mode is not the panel's and shall not be.
    [[nodiscard]] bool mayAsk() const;
    /// Answered when PMTS may send again, or by endWaiting().
    [[nodiscard]] core::Completion<void> returned();
    void endWaiting(const core::Error& error);
    [[nodiscard]] ControlStatus status() const;
    [[nodiscard]] PanelPort& panel() { return panel_; }

    std::function<void(const ControlStatus&)> on_changed;
    std::function<void()> on_returned;  ///< PMTS may send again

private:
    void modeHolds(scheduler::ControlMode before, scheduler::ControlMode mode);
    void giveBack();
    void show();

    scheduler::Arbiter& arbiter_;
    scheduler::Scheduler& line_;
    transport::ByteLink& port_;
    PanelPort panel_;
    PathSwitch switch_;
    QString switch_sentence_;
    scheduler::ControlMode wanted_ = scheduler::ControlMode::kShared;
    core::Duration owner_since_{0};
    std::vector<core::Completion<void>> waiting_;
};

}  // namespace pmts::instrument
