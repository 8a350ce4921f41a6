#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/core/clock.hpp"

#include <QObject>

#include <optional>
#include <vector>

namespace pmts::app {

/// A line of the counters: `Commands of the panel`, `1 204`.
struct ControlCounter {
    QString name;
    QString value;

    [[nodiscard]] bool operator==(const ControlCounter&) const = default;
};

/// Who has control: the switch with its three modes, the lamp of the owner, the panel's port and the counters. What is
/// chosen is remembered and holds for the next start.
class ControlPresenter : public QObject {
    Q_OBJECT
public:
    /// The clock outlives the presenter; it is the GUI thread's.
    ControlPresenter(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages, core::Clock& clock,
                     QObject* parent = nullptr);

    [[nodiscard]] static std::vector<scheduler::ControlMode> modes();
    [[nodiscard]] static QString modeName(scheduler::ControlMode mode);
    [[nodiscard]] static QString modeHelp(scheduler::ControlMode mode);  ///< one sentence for the tool tip
    [[nodiscard]] scheduler::ControlMode mode() const { return status_.mode; }
    [[nodiscard]] scheduler::ControlMode wantedMode() const { return preferences_.settings().control.mode; }
    /// The transaction that runs is finished first.
    [[nodiscard]] bool isChanging() const { return mode() != wantedMode(); }
    [[nodiscard]] scheduler::LineOwner owner() const { return status_.owner; }
    /// On the clock of the instrument thread, as every `core::Duration` of a moment.
    [[nodiscard]] core::Duration ownerSince() const { return status_.owner_since; }
    /// As owner(), for people: a panel's transaction shows for half a second at least, and PMTS's polls do not flicker.
    [[nodiscard]] scheduler::LineOwner shownOwner() const { return shown_owner_; }
    /// Idle, computer or panel as shownOwner(), in the mode that holds, and for how long.
    [[nodiscard]] StatusItem ownerLamp() const;
    /// Top bar: `PC in control`, `Panel in control`, `Shared: PC`.
    [[nodiscard]] StatusItem barItem() const;
    /// Why the switch is busy; empty while it is not.
    [[nodiscard]] QString changeReason() const;
    [[nodiscard]] StatusItem panelPort() const;
    [[nodiscard]] std::vector<ControlCounter> counters() const;
    /// What holds now: as kept, or with the panel of usePanelForNow().
    [[nodiscard]] ControlSettings settings() const;

public Q_SLOTS:
    void setMode(pmts::scheduler::ControlMode mode);
    /// From the panel, to the mode that was before.
    void takeControl();
    /// A panel for this run only, which nothing remembers: the simulator's.
    void usePanelForNow(const pmts::app::SerialChoice& port);
    void removePanelForNow();
    /// Refused with a message where it is the instrument's own port.
    void usePanel(const pmts::app::SerialChoice& port);
    void removePanel();
    void setPathSwitch(const pmts::instrument::PathSwitch& path_switch);

Q_SIGNALS:
    void modeChanged();   ///< the one that holds, or the one that is wanted
    void ownerChanged();  ///< up to twice a transaction
    void shownOwnerChanged();
    void countersChanged();
    void panelPortChanged();

private:
    void keep(const ControlSettings& control);
    void apply();
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] bool isTakenPort(const SerialChoice& port);
    void showStatus(const instrument::ControlStatus& status);
    void showTroubles(const instrument::ControlStatus& before);
    void followOwner(const instrument::ControlStatus& before);
    void holdOwner(scheduler::LineOwner owner);
    void onConnection(ConnectionState state);

    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    core::Clock& clock_;
    instrument::ControlStatus status_;
    std::optional<SerialChoice> panel_for_now_;
    scheduler::ControlMode mode_before_panel_ = scheduler::ControlMode::kShared;
    scheduler::LineOwner shown_owner_ = scheduler::LineOwner::kIdle;
    core::Duration shown_since_{0};
    core::Timer panel_hold_;
};

}  // namespace pmts::app
