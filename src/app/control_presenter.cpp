#include "pmts/app/control_presenter.hpp"

#include <QLocale>

namespace pmts::app {

using instrument::PanelPortState;
using scheduler::ControlMode;
using scheduler::LineOwner;

namespace {

const QString kPanelTopic = QStringLiteral("panel port");
const QString kSwitchTopic = QStringLiteral("path switch");

QString number(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

QString seconds(core::Duration span) {
    return ControlPresenter::tr("%1 s").arg(std::chrono::duration<double>(span).count(), 0, 'f', 1);
}

}  // namespace

ControlPresenter::ControlPresenter(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                                   QObject* parent)
    : QObject(parent), instrument_(instrument), preferences_(preferences), messages_(messages) {
    connect(&instrument_, &InstrumentDesk::controlChanged, this, &ControlPresenter::showStatus);
    instrument_.setControl(settings());
}

std::vector<ControlMode> ControlPresenter::modes() {
    return {ControlMode::kShared, ControlMode::kComputer, ControlMode::kPanel};
}

QString ControlPresenter::modeName(ControlMode mode) {
    switch (mode) {
        case ControlMode::kShared: return tr("Shared");
        case ControlMode::kComputer: return tr("Computer");
        case ControlMode::kPanel: return tr("Panel");
    }
    return {};
}

QString ControlPresenter::modeHelp(ControlMode mode) {
    switch (mode) {
        case ControlMode::kShared:
            return tr("Panel and PMTS command the instrument in turn, one transaction at a time.");
        case ControlMode::kComputer:
            return tr("Only PMTS commands the instrument. What the panel sends is swallowed and logged.");
        case ControlMode::kPanel:
            return tr("Only the panel commands the instrument. PMTS sends nothing, it listens and logs.");
    }
    return {};
}

StatusItem ControlPresenter::ownerLamp() const {
    const QString help = isChanging() ? tr("Changes to \"%1\" when the running transaction has ended.").arg(modeName(wantedMode()))
                                      : modeHelp(mode());
    switch (owner()) {
        case LineOwner::kComputer:
            return {.state = DeviceState::kGood, .text = tr("PMTS has the line"), .details = help};
        case LineOwner::kPanel:
            return {.state = DeviceState::kBusy, .text = tr("The panel has the line"), .details = help};
        case LineOwner::kIdle:
            break;
    }
    return {.state = DeviceState::kIdle, .text = tr("The line is idle"), .details = help};
}

StatusItem ControlPresenter::panelPort() const {
    const QString port = settings().panel ? settings().panel->text() : QString();
    if (!settings().panel) {
        return {.state = DeviceState::kIdle, .text = tr("No panel"), .details = tr("The panel is not connected through PMTS.")};
    }
    switch (status_.panel) {
        case PanelPortState::kOpen:
            return {.state = DeviceState::kGood, .text = tr("Panel port open"), .details = port};
        case PanelPortState::kMissing:
            return {.state = DeviceState::kFailed, .text = tr("Panel port missing"), .details = status_.panel_sentence};
        case PanelPortState::kNone:
            break;
    }
    return {.state = DeviceState::kIdle, .text = tr("Panel port closed"),
            .details = tr("%1 is opened together with the instrument.").arg(port)};
}

std::vector<ControlCounter> ControlPresenter::counters() const {
    const auto& counts = status_.counts;
    return {{tr("Transactions of PMTS"), number(counts.computer_turns)},
            {tr("Transactions of the panel"), number(counts.panel_turns)},
            {tr("Not answered to the panel"), number(counts.panel_timed_out)},
            {tr("Swallowed from the panel"), number(counts.swallowed)},
            {tr("Nobody asked for"), number(counts.unsolicited)},
            {tr("Longest wait of PMTS"), seconds(counts.longest_computer_wait)},
            {tr("Longest wait of the panel"), seconds(counts.longest_panel_wait)}};
}

void ControlPresenter::setMode(ControlMode mode) {
    auto control = settings();
    control.mode = mode;
    keep(control);
}

void ControlPresenter::usePanel(const SerialChoice& port) {
    const auto& chosen = preferences_.settings();
    const bool serial = chosen.last_device == LastDevice::kSerial;
    if (port.path.isEmpty() || (serial && port.path == chosen.serial.path)) {
        messages_.warn(port.path.isEmpty() ? tr("No port was chosen for the panel.")
                                           : tr("%1 is the instrument's port.").arg(port.path),
                       tr("Choose the port that the panel is plugged into."), MessageAction::kNone, kPanelTopic);
        return;
    }
    messages_.solve(kPanelTopic);
    auto control = settings();
    control.panel = port;
    keep(control);
}

void ControlPresenter::removePanel() {
    auto control = settings();
    control.panel.reset();
    keep(control);
}

void ControlPresenter::setPathSwitch(const instrument::PathSwitch& path_switch) {
    auto control = settings();
    control.path_switch = path_switch;
    keep(control);
}

void ControlPresenter::keep(const ControlSettings& control) {
    Settings next = preferences_.settings();
    next.control = control;
    preferences_.set(next);
    instrument_.setControl(control);
    Q_EMIT modeChanged();
    Q_EMIT panelPortChanged();
}

void ControlPresenter::showStatus(const instrument::ControlStatus& status) {
    const auto before = std::exchange(status_, status);
    if (before.mode != status.mode || before.wanted != status.wanted) {
        Q_EMIT modeChanged();
    }
    if (before.owner != status.owner) {
        Q_EMIT ownerChanged();
    }
    if (before.counts != status.counts) {
        Q_EMIT countersChanged();
    }
    showTroubles(before);
}

void ControlPresenter::showTroubles(const instrument::ControlStatus& before) {
    if (before.panel != status_.panel || before.panel_sentence != status_.panel_sentence) {
        if (status_.panel == PanelPortState::kMissing) {
            messages_.warn(tr("The panel's port is missing."), status_.panel_sentence, MessageAction::kOpenConnectionPage,
                           kPanelTopic);
        } else {
            messages_.solve(kPanelTopic);
        }
        Q_EMIT panelPortChanged();
    }
    if (before.switch_sentence != status_.switch_sentence) {
        if (status_.switch_sentence.isEmpty()) {
            messages_.solve(kSwitchTopic);
        } else {
            messages_.warn(tr("The path switch is not driven."), status_.switch_sentence, MessageAction::kNone, kSwitchTopic);
        }
    }
}

}  // namespace pmts::app
