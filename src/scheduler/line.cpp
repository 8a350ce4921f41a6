#include "line.hpp"

#include "pmts/core/logging.hpp"

#include <QByteArray>

#include <algorithm>
#include <memory>
#include <utility>

namespace pmts::scheduler {
namespace {

core::Error notConnectedError() {
    return {.kind = core::ErrorKind::kNotConnected,
            .happened = QStringLiteral("No instrument is connected."),
            .remedy = QStringLiteral("Connect one first."),
            .info_code = std::nullopt,
            .detail = {}};
}

}  // namespace

core::Task<core::Result<protocol::Reply>> Scheduler::Impl::run(std::shared_ptr<Impl> line,
                                                               MicroInstruction instruction,
                                                               std::stop_token stop) {
    if (stop.stop_requested()) {
        co_return core::cancelled();
    }
    const auto turn = std::make_shared<Turn>(std::move(instruction));
    line->submit(turn);
    const std::stop_callback on_stop(stop, [line, turn] { line->withdraw(turn); });
    auto answer = turn->completion.answer();
    co_return co_await answer;
}

void Scheduler::Impl::attach(Scheduler& owner) {
    owner_ = &owner;
    link_.on_received = [weak = weak_from_this()](std::string_view bytes) {
        if (const auto self = weak.lock()) {
            self->received(bytes);
        }
    };
    link_.on_lost = [weak = weak_from_this()](const core::Error& error) {
        if (const auto self = weak.lock()) {
            self->lost(error);
        }
    };
}

void Scheduler::Impl::detach() {
    reset(core::cancelled().value());
    setKeeper(nullptr);
    owner_ = nullptr;
    link_.on_received = nullptr;
    link_.on_lost = nullptr;
}

void Scheduler::Impl::submit(const TurnPtr& turn) {
    turn->record.sent = turn->instruction.bytes;
    turn->record.priority = turn->instruction.priority;
    turn->record.may_stay_silent = turn->instruction.may_stay_silent;
    turn->record.queued_at = clock_.now();
    if (const auto hold = std::exchange(turn->instruction.hold, nullptr)) {
        turn->holder = *hold;
    }
    if (owner_ == nullptr) {
        finish(turn, Outcome::kCancelled, core::cancelled());
    } else if (!link_.isOpen()) {
        finish(turn, Outcome::kFailed, tl::unexpected(notConnectedError()));
    } else if (turn->instruction.interrupts && (keeper_ == nullptr || has_line_)) {
        write(turn);
    } else if (barred_ && (turn->holder == 0 || turn->holder != holder_)) {
        finish(turn, Outcome::kFailed, tl::unexpected(*barred_));
    } else {
        queues_.at(static_cast<std::size_t>(turn->instruction.priority)).push_back(turn);
        pump();
    }
}

void Scheduler::Impl::withdraw(const TurnPtr& turn) {
    if (!turn->waiting) {
        return;
    }
    auto& queue = queues_.at(static_cast<std::size_t>(turn->instruction.priority));
    if (std::erase(queue, turn) > 0) {
        finish(turn, Outcome::kCancelled, core::cancelled());
    } else {
        leaveOwed(turn, Outcome::kCancelled, core::cancelled());
    }
}

void Scheduler::Impl::failAll(const core::Error& error) {
    failQueued(error);
    for (const auto& turn : std::deque(on_wire_)) {
        leaveOwed(turn, Outcome::kFailed, tl::unexpected(error));
    }
}

void Scheduler::Impl::failQueued(const core::Error& error) {
    for (auto& queue : queues_) {
        for (const auto& turn : std::exchange(queue, {})) {
            finish(turn, Outcome::kFailed, tl::unexpected(error));
        }
    }
}

void Scheduler::Impl::reset(const core::Error& error) {
    failAll(error);
    on_wire_.clear();
    late_.clear();
    only_answer_.reset();
    holder_ = 0;
    last_text_.clear();
    reader_.clear();
    quiet_timer_.cancel();
    letGo();
}

void Scheduler::Impl::setKeeper(LineKeeper* keeper) {
    letGo();
    if (keeper_ != nullptr) {
        keeper_->on_free = nullptr;
    }
    keeper_ = keeper;
    if (keeper_ != nullptr) {
        keeper_->useEndMark(reader_.endMark());
        keeper_->on_free = [weak = weak_from_this()] {
            if (const auto self = weak.lock()) {
                self->pump();
            }
        };
    }
}

void Scheduler::Impl::bar(std::optional<core::Error> reason) {
    barred_ = std::move(reason);
    if (barred_) {
        failQueued(*barred_);
    }
}

void Scheduler::Impl::setEndMark(std::optional<char> end_mark) {
    reader_.setEndMark(end_mark);
    if (keeper_ != nullptr) {
        keeper_->useEndMark(end_mark);
    }
}

bool Scheduler::Impl::isQueueEmpty() const {
    return std::ranges::all_of(queues_, [](const auto& queue) { return queue.empty(); });
}

bool Scheduler::Impl::hasNext() const {
    return std::ranges::any_of(queues_, [this](const auto& queue) {
        return std::ranges::any_of(queue, [this](const TurnPtr& turn) { return maySend(*turn); });
    });
}

bool Scheduler::Impl::isIdle() const { return on_wire_.empty() && isQueueEmpty(); }

void Scheduler::Impl::pump() {
    while (on_wire_.empty()) {
        if (holder_ == 0) {
            letGo();
        }
        if (!hasNext() || !takeLine()) {
            return;
        }
        write(nextQueued());
    }
}

bool Scheduler::Impl::takeLine() {
    has_line_ = has_line_ || keeper_ == nullptr || keeper_->take();
    return has_line_;
}

void Scheduler::Impl::letGo() {
    if (std::exchange(has_line_, false) && keeper_ != nullptr) {
        keeper_->give();
    }
}

Hold Scheduler::Impl::makeHold() {
    return {new int(++last_holder_), [weak = weak_from_this()](const int* holder) {
                const std::unique_ptr<const int> owned(holder);
                if (const auto self = weak.lock()) {
                    self->endHold(*owned);
                }
            }};
}

void Scheduler::Impl::endHold(int holder) {
    if (holder_ == holder) {
        holder_ = 0;
        pump();
    }
}

TurnPtr Scheduler::Impl::nextQueued() {
    for (auto& queue : queues_) {
        const auto next = std::ranges::find_if(queue, [this](const TurnPtr& turn) { return maySend(*turn); });
        if (next != queue.end()) {
            auto turn = *next;
            queue.erase(next);
            return turn;
        }
    }
    return nullptr;
}

void Scheduler::Impl::write(const TurnPtr& turn) {
    if (turn->instruction.time_critical) {
        turn->pause.emplace(gate_, clock_);
        turn->record.video_paused = true;
    }
    turn->record.sent_at = clock_.now();
    if (turn->instruction.on_sent) {
        turn->instruction.on_sent(turn->record.sent_at);
    }
    holder_ = turn->holder != 0 ? turn->holder : holder_;
    link_.write(turn->instruction.bytes);
    if (!turn->instruction.expects_reply) {
        finish(turn, Outcome::kAnswered, protocol::Reply{});
        return;
    }
    on_wire_.push_back(turn);
    armTimeLimit(turn);
    armQuiet();
}

void Scheduler::Impl::armTimeLimit(const TurnPtr& turn) {
    turn->time_limit =
        clock_.callAfter(turn->instruction.time_limit, [self = weak_from_this(), weak = std::weak_ptr(turn)] {
            const auto line = self.lock();
            const auto late = weak.lock();
            if (line && late) {
                line->timeOut(late);
            }
        });
}

void Scheduler::Impl::timeOut(const TurnPtr& turn) {
    if (!turn->waiting) {
        return;
    }
    counts_.timed_out += turn->instruction.may_stay_silent ? 0U : 1U;
    turn->record.timed_out = true;
    turn->record.received = reader_.pending();
    qCDebug(core::logScheduler) << "no answer to" << turn->record.sent.c_str();
    leaveOwed(turn, Outcome::kTimedOut, tl::unexpected(timedOut(*turn)));
}

void Scheduler::Impl::finish(const TurnPtr& turn, Outcome outcome, core::Result<protocol::Reply> result) {
    if (!turn->waiting) {
        return;
    }
    turn->waiting = false;
    turn->time_limit.cancel();
    turn->pause.reset();
    turn->record.finished_at = clock_.now();
    turn->record.outcome = outcome;
    turn->completion.complete(std::move(result));
    if (owner_ != nullptr && owner_->on_finished) {
        owner_->on_finished(turn->record);
    }
}

void Scheduler::Impl::leaveOwed(const TurnPtr& turn, Outcome outcome, core::Result<protocol::Reply> result) {
    finish(turn, outcome, std::move(result));
    owed_since_ = clock_.now();
    armQuiet();
}

}  // namespace pmts::scheduler
