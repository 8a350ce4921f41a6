#include "arbiter_impl.hpp"

#include <algorithm>

namespace pmts::scheduler {
namespace {

/// What the instrument itself queues before it answers 207 (protocol page 7).
constexpr std::size_t kMostWaiting = 10;

}  // namespace

void Arbiter::Impl::fromPanel(std::string_view bytes) {
    if (!instrument_.isOpen()) {
        swallow(std::string(bytes), Outcome::kFailed);
    } else if (mode_ == ControlMode::kPanel) {
        passThrough(bytes);
    } else if (turn_ && turn_->in_dialogue) {
        instrument_.write(bytes);
        turn_->record.sent += bytes;
        armTurn();
    } else {
        queue(commands_.feed(bytes));
        armHalf();
        extendTurn();
        next();
    }
}

/// A wire; what passes is followed only to know whether a transaction runs.
void Arbiter::Impl::passThrough(std::string_view bytes) {
    instrument_.write(bytes);
    if (turn_ && turn_->in_dialogue) {
        turn_->record.sent += bytes;
        armTurn();
        return;
    }
    for (const auto& command : commands_.feed(bytes).commands) {
        if (!turn_) {
            beginTurn(clock_.now());
        }
        noteCommand(command);
    }
    armHalf();
    next();
}

void Arbiter::Impl::queue(PanelCommands::Taken taken) {
    if (!taken.junk.empty()) {
        swallow(std::move(taken.junk));
    }
    if (!taken.tail.empty() && !waiting_.empty()) {
        waiting_.back().command += taken.tail;
    } else if (!taken.tail.empty() && turn_) {
        instrument_.write(taken.tail);
        turn_->record.sent += taken.tail;
    } else {
        commands_.putBack(taken.tail);
    }
    for (auto& command : taken.commands) {
        if (mode_ == ControlMode::kComputer || waiting_.size() == kMostWaiting) {
            swallow(std::move(command));
        } else {
            waiting_.push_back({.command = std::move(command), .since = clock_.now()});
        }
    }
}

void Arbiter::Impl::swallow(std::string bytes, Outcome outcome) {
    ++counts_.swallowed;
    if (owner_.on_panel_turn) {
        TransactionRecord record;
        record.sent = std::move(bytes);
        record.queued_at = record.sent_at = record.finished_at = clock_.now();
        record.outcome = outcome;
        record.master = Master::kPanel;
        owner_.on_panel_turn(record);
    }
}

void Arbiter::Impl::dropWaiting(Outcome outcome) {
    for (auto& waiting : std::exchange(waiting_, {})) {
        swallow(std::move(waiting.command), outcome);
    }
}

void Arbiter::Impl::armHalf() {
    if (!commands_.hasHalf()) {
        half_timer_.cancel();
        return;
    }
    half_timer_ = clock_.callAfter(settings_.half_command_limit, [this] {
        auto half = commands_.takeHalf();
        if (mode_ != ControlMode::kPanel) {
            swallow(std::move(half));
        }
        next();
    });
}

void Arbiter::Impl::beginTurn(core::Duration waiting_since) {
    turn_.emplace();
    turn_->record.queued_at = waiting_since;
    turn_->record.sent_at = clock_.now();
    turn_->record.master = Master::kPanel;
    ++counts_.panel_turns;
    counts_.longest_panel_wait = std::max(counts_.longest_panel_wait, clock_.now() - waiting_since);
}

void Arbiter::Impl::sendNext() {
    const std::string command = std::move(waiting_.front().command);
    waiting_.pop_front();
    instrument_.write(command);
    noteCommand(command);
}

/// What waits and what has come of the next command go first.
void Arbiter::Impl::becomeWire() {
    while (!waiting_.empty()) {
        if (!turn_) {
            beginTurn(waiting_.front().since);
        }
        sendNext();
    }
    if (commands_.hasHalf()) {
        instrument_.write(commands_.half());
    }
}

void Arbiter::Impl::noteCommand(const std::string& command) {
    turn_->record.sent += command;
    turn_->owed.push_back(command);
    ++turn_->commands;
    ++counts_.panel_commands;
    armTurn();
    if (owner_.on_panel_command) {
        owner_.on_panel_command(command);
    }
}

/// The panel asks again before its answer: it has given up, or it wants to stop what it began. So would it on a cable
/// of its own; only while PMTS waits is it held to a few.
void Arbiter::Impl::extendTurn() {
    const auto may_go_on = [this] {
        return turn_ && !next_mode_ && (!computer_waits_since_ || turn_->commands < settings_.commands_in_turn);
    };
    if (!waiting_.empty() && may_go_on()) {
        sendNext();
    }
}

void Arbiter::Impl::armTurn() {
    if (turn_->owed.empty()) {
        return;
    }
    const bool silence_ends = !watch_.endMark() && (!watch_.block().empty() || !isQuestion(turn_->owed.front()));
    const bool is_long =
        turn_->in_dialogue || std::ranges::any_of(turn_->owed, [](const auto& owed) { return takesLong(owed); });
    const auto limit = is_long ? settings_.long_limit : settings_.short_limit;
    turn_timer_ = clock_.callAfter(silence_ends ? settings_.quiet_time : limit, [this] { turnTimer(); });
}

void Arbiter::Impl::turnTimer() {
    const bool silence_ends = !watch_.endMark() && (!watch_.block().empty() || !isQuestion(turn_->owed.front()));
    if (!silence_ends) {
        ++counts_.panel_timed_out;
        turn_->record.timed_out = true;
        endTurn(Outcome::kTimedOut);
        return;
    }
    turn_->owed.pop_front();
    watch_.breakOff();
    armTurn();
    endTurnIfAnswered();
}

void Arbiter::Impl::endTurnIfAnswered() {
    if (turn_ && turn_->owed.empty()) {
        endTurn(Outcome::kAnswered);
    }
}

void Arbiter::Impl::endTurn(Outcome outcome) {
    turn_timer_.cancel();
    auto record = std::move(turn_->record);
    turn_.reset();
    last_ = Master::kPanel;
    record.finished_at = clock_.now();
    record.outcome = outcome;
    if (owner_.on_panel_turn) {
        owner_.on_panel_turn(record);
    }
    next();
}

}  // namespace pmts::scheduler
