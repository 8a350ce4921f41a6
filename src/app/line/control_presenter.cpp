#include "pmts/app/line/control_presenter.hpp"

#include <QLocale>

namespace pmts::app {

using instrument::PanelPortState;
using scheduler::ControlMode;
using scheduler::LineOwner;

namespace {

using namespace std::chrono_literals;

constexpr core::Duration kLampHold = 500ms;

const QString kPanelTopic = QStringLiteral("panel port");
const QString kSwitchTopic = QStringLiteral("path switch");

QString number(std::uint64_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

QString seconds(core::Duration span) {
    return ControlPresenter::tr("%1 s").arg(std::chrono::duration<double>(span).count(), 0, 'f', 1);
}

/// `12 s`, `3:05 min`
QString spanText(core::Duration span) {
    constexpr std::int64_t kMinute = 60;
    const auto whole_s = std::chrono::duration_cast<std::chrono::seconds>(span).count();
    return whole_s < kMinute ? ControlPresenter::tr("%1 s").arg(whole_s)
                             : ControlPresenter::tr("%1:%2 min").arg(whole_s / kMinute).arg(whole_s % kMinute, 2, 10, QLatin1Char('0'));
}

}  // namespace

ControlPresenter::ControlPresenter(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                                   core::Clock& clock, QObject* parent)
    : QObject(parent), instrument_(instrument), preferences_(preferences), messages_(messages), clock_(clock),
      shown_since_(clock.now()) {
    connect(&instrument_, &InstrumentDesk::controlChanged, this, &ControlPresenter::showStatus);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &ControlPresenter::onConnection);
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

QString ControlPresenter::changeReason() const {
    return isChanging() && isLive() ? tr("Changes to \"%1\" when the running transaction has ended.").arg(modeName(wantedMode()))
                                    : QString();
}

StatusItem ControlPresenter::ownerLamp() const {
    const QString reason = changeReason();
    const QString help = reason.isEmpty() ? modeHelp(mode()) : reason;
    const auto lamp = [this, &help](DeviceState state, const QString& text) {
        const QString span = spanText(clock_.now() - shown_since_);
        const bool in_turn = mode() == ControlMode::kShared && shownOwner() != LineOwner::kIdle;  // many times a second
        return StatusItem{.state = state, .text = in_turn ? text : tr("%1, for %2").arg(text, span), .details = help};
    };
    switch (shownOwner()) {
        case LineOwner::kComputer: return lamp(DeviceState::kGood, tr("PMTS has the line"));
        case LineOwner::kPanel: return lamp(DeviceState::kBusy, tr("The panel has the line"));
        case LineOwner::kIdle: break;
    }
    return lamp(DeviceState::kIdle, tr("The line is idle"));
}

StatusItem ControlPresenter::barItem() const {
    if (const QString reason = changeReason(); !reason.isEmpty()) {
        return {.state = DeviceState::kBusy, .text = tr("To \"%1\"…").arg(modeName(wantedMode())), .details = reason};
    }
    if (wantedMode() == ControlMode::kPanel) {
        return {.state = DeviceState::kWarning, .text = tr("Panel in control"), .details = modeHelp(ControlMode::kPanel)};
    }
    if (!isLive()) {
        return {.state = DeviceState::kIdle, .text = tr("Nobody in control"), .details = tr("No instrument is connected.")};
    }
    if (mode() == ControlMode::kComputer || !settings().panel) {
        return {.state = DeviceState::kGood, .text = tr("PC in control"), .details = modeHelp(mode())};
    }
    const bool panel = shownOwner() == LineOwner::kPanel;
    return {.state = panel ? DeviceState::kBusy : DeviceState::kGood, .text = panel ? tr("Shared: panel") : tr("Shared: PC"),
            .details = modeHelp(mode())};
}

StatusItem ControlPresenter::panelPort() const {
    const auto panel = settings().panel;
    const QString port = panel ? panel->text() : QString();
    if (!panel) {
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

ControlSettings ControlPresenter::settings() const {
    ControlSettings control = preferences_.settings().control;
    if (panel_for_now_) {
        control.panel = panel_for_now_;
    }
    return control;
}

void ControlPresenter::setMode(ControlMode mode) {
    if (mode == ControlMode::kPanel && wantedMode() != ControlMode::kPanel) {
        mode_before_panel_ = wantedMode();
    }
    auto control = preferences_.settings().control;
    control.mode = mode;
    keep(control);
    if (mode != ControlMode::kPanel) {
        messages_.solve(kControlTopic);
    }
}

void ControlPresenter::takeControl() {
    if (wantedMode() == ControlMode::kPanel) {
        setMode(mode_before_panel_);
    }
}

/// Taken by the instrument, or no port at all: said, and nothing is changed.
bool ControlPresenter::isTakenPort(const SerialChoice& port) {
    const auto& chosen = preferences_.settings();
    const bool kept = chosen.last_device == LastDevice::kSerial && port.path == chosen.serial.path;
    const bool open = isLive() && port.path == instrument_.choice().path;
    if (!port.path.isEmpty() && !kept && !open) {
        messages_.solve(kPanelTopic);
        return false;
    }
    messages_.warn(port.path.isEmpty() ? tr("No port was chosen for the panel.")
                                       : tr("%1 is the instrument's port.").arg(port.path),
                   tr("Choose the port that the panel is plugged into."), MessageAction::kNone, kPanelTopic);
    return true;
}

void ControlPresenter::usePanel(const SerialChoice& port) {
    if (isTakenPort(port)) {
        return;
    }
    panel_for_now_.reset();
    auto control = preferences_.settings().control;
    control.panel = port;
    keep(control);
}

void ControlPresenter::usePanelForNow(const SerialChoice& port) {
    panel_for_now_ = port;
    apply();
}

void ControlPresenter::removePanelForNow() {
    if (std::exchange(panel_for_now_, std::nullopt)) {
        apply();
    }
}

void ControlPresenter::removePanel() {
    if (panel_for_now_) {
        removePanelForNow();
        return;
    }
    auto control = preferences_.settings().control;
    control.panel.reset();
    keep(control);
}

void ControlPresenter::setPathSwitch(const instrument::PathSwitch& path_switch) {
    auto control = preferences_.settings().control;
    control.path_switch = path_switch;
    keep(control);
}

void ControlPresenter::keep(const ControlSettings& control) {
    Settings next = preferences_.settings();
    next.control = control;
    preferences_.set(next);
    apply();
}

void ControlPresenter::apply() {
    instrument_.setControl(settings());
    Q_EMIT modeChanged();
    Q_EMIT panelPortChanged();
}

bool ControlPresenter::isLive() const {
    return instrument_.connectionState() == ConnectionState::kConnected ||
           instrument_.connectionState() == ConnectionState::kReconnecting;
}

/// While the panel has control nothing is asked, so that connecting waits: said with the way out of it.
void ControlPresenter::onConnection(ConnectionState state) {
    if (state == ConnectionState::kConnecting && wantedMode() == ControlMode::kPanel) {
        const core::Error error = instrument::panelHasControl();
        messages_.warn(error.happened, error.remedy, MessageAction::kTakeControl, kControlTopic);
    }
    if (state == ConnectionState::kDisconnected) {
        panel_hold_.cancel();
        holdOwner(LineOwner::kIdle);
    }
    Q_EMIT modeChanged();
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
    followOwner(before);
    showTroubles(before);
}

/// A panel's turn holds the lamp for a while, as do the pauses between PMTS's polls.
void ControlPresenter::followOwner(const instrument::ControlStatus& before) {
    const bool panel_was_there = status_.owner == LineOwner::kPanel || before.owner == LineOwner::kPanel ||
                                 status_.counts.panel_turns > before.counts.panel_turns;
    if (panel_was_there) {
        holdOwner(LineOwner::kPanel);
        panel_hold_ = clock_.callAfter(kLampHold, [this] {
            if (status_.owner != LineOwner::kPanel) {
                holdOwner(mode() == ControlMode::kPanel ? LineOwner::kIdle : LineOwner::kComputer);
            }
        });
    } else if (status_.owner == LineOwner::kComputer && shown_owner_ == LineOwner::kIdle) {
        holdOwner(LineOwner::kComputer);
    }
}

void ControlPresenter::holdOwner(LineOwner owner) {
    if (std::exchange(shown_owner_, owner) != owner) {
        shown_since_ = clock_.now();
        Q_EMIT shownOwnerChanged();
    }
}

void ControlPresenter::showTroubles(const instrument::ControlStatus& before) {
    if (before.panel != status_.panel || before.panel_sentence != status_.panel_sentence) {
        if (status_.panel == PanelPortState::kMissing) {
            messages_.warn(tr("The panel's port is missing."), status_.panel_sentence, MessageAction::kOpenControlPage,
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
            messages_.warn(tr("The path switch is not driven."), status_.switch_sentence, MessageAction::kOpenControlPage,
                           kSwitchTopic);
        }
    }
}

}  // namespace pmts::app
