#include "line_control.hpp"

#include "pmts/core/logging.hpp"

namespace pmts::instrument {

using scheduler::ControlMode;

LineControl::LineControl(scheduler::Arbiter& arbiter, scheduler::Scheduler& line, transport::ByteLink& port,
                         core::Clock& clock, const ConnectionSettings& settings)
    : arbiter_(arbiter),
      line_(line),
      port_(port),
      panel_(arbiter, clock, settings.first_retry, settings.longest_retry),
      switch_(settings.path_switch) {
    line_.setKeeper(&arbiter_);
    arbiter_.on_mode = [this](ControlMode before, ControlMode mode) { modeHolds(before, mode); };
    arbiter_.on_owner = [this](scheduler::LineOwner, core::Duration at) {
        owner_since_ = at;
        show();
    };
    panel_.on_changed = [this] { show(); };
    setMode(settings.control_mode);
}

LineControl::~LineControl() {
    on_changed = nullptr;
    on_returned = nullptr;
    arbiter_.on_mode = nullptr;
    arbiter_.on_owner = nullptr;
    line_.setKeeper(nullptr);
}

void LineControl::setMode(ControlMode mode) {
    const auto before = std::exchange(wanted_, mode);
    if (mode == ControlMode::kPanel) {
        line_.bar(panelHasControl());
    } else if (before == ControlMode::kPanel && mayAsk()) {
        giveBack();  // before the panel had it
    }
    arbiter_.setMode(mode);
    show();
}

void LineControl::giveBack() {
    line_.bar(std::nullopt);
    for (const auto& waiting : std::exchange(waiting_, {})) {
        waiting.complete({});
    }
    if (on_returned) {
        on_returned();
    }
}

void LineControl::setSwitch(const PathSwitch& path_switch) {
    switch_ = path_switch;
    setLines();
}

void LineControl::setLines() {
    const auto set = port_.isOpen() ? port_.setControlLines(switch_.linesIn(arbiter_.mode())) : core::Result<void>();
    switch_sentence_ = set ? QString() : set.error().sentence();
    if (!set) {
        qCWarning(core::logInstrument) << "the switch box is not driven:" << set.error().happened << set.error().detail;
    }
    show();
}

bool LineControl::mayAsk() const { return arbiter_.mode() != ControlMode::kPanel && wanted_ != ControlMode::kPanel; }

core::Completion<void> LineControl::returned() {
    waiting_.emplace_back();
    return waiting_.back();
}

void LineControl::endWaiting(const core::Error& error) {
    for (const auto& waiting : std::exchange(waiting_, {})) {
        waiting.complete(tl::unexpected(error));
    }
}

void LineControl::modeHolds(ControlMode before, ControlMode mode) {
    setLines();
    if (before == ControlMode::kPanel && mode != ControlMode::kPanel && mayAsk()) {
        giveBack();
    }
}

ControlStatus LineControl::status() const {
    return {.mode = arbiter_.mode(),
            .wanted = wanted_,
            .owner = arbiter_.owner(),
            .owner_since = owner_since_,
            .counts = arbiter_.counts(),
            .panel = panel_.state(),
            .panel_sentence = panel_.sentence(),
            .switch_sentence = switch_sentence_};
}

void LineControl::show() {
    if (on_changed) {
        on_changed(status());
    }
}

}  // namespace pmts::instrument
