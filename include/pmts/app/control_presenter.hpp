#pragma once

#include "pmts/app/device_state.hpp"
#include "pmts/app/instrument_desk.hpp"
#include "pmts/app/message_centre.hpp"
#include "pmts/app/preferences.hpp"

#include <QObject>

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
    ControlPresenter(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
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
    /// Idle, computer or panel, in the mode that holds.
    [[nodiscard]] StatusItem ownerLamp() const;
    [[nodiscard]] StatusItem panelPort() const;
    [[nodiscard]] std::vector<ControlCounter> counters() const;
    [[nodiscard]] const ControlSettings& settings() const { return preferences_.settings().control; }

public Q_SLOTS:
    void setMode(pmts::scheduler::ControlMode mode);
    /// Refused with a message where it is the instrument's own port.
    void usePanel(const pmts::app::SerialChoice& port);
    void removePanel();
    void setPathSwitch(const pmts::instrument::PathSwitch& path_switch);

Q_SIGNALS:
    void modeChanged();   ///< the one that holds, or the one that is wanted
    void ownerChanged();  ///< up to twice a transaction
    void countersChanged();
    void panelPortChanged();

private:
    void keep(const ControlSettings& control);
    void showStatus(const instrument::ControlStatus& status);
    void showTroubles(const instrument::ControlStatus& before);

    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    instrument::ControlStatus status_;
};

}  // namespace pmts::app
