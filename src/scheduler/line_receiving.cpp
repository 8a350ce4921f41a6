#include "line.hpp"

#include <QByteArray>

#include <algorithm>

namespace pmts::scheduler {
namespace {

using namespace std::chrono_literals;

/// A device that never falls silent (a GPS mouse on the port) must not hold the line for ever.
constexpr int kLongestDrainInQuietTimes = 4;
constexpr core::Duration kLateRepliesKept = 60s;
constexpr core::Duration kDoubledWithin = 2s;
/// Share of the wire time of a command before which no answer is possible; the rest is for the accuracy of
/// the baud rate.
constexpr double kCertainShare = 0.8;

}  // namespace

core::Error timedOut(const Turn& turn) {
    return {.kind = core::ErrorKind::kTimeOut,
            .happened = QStringLiteral("The instrument did not answer in time."),
            .remedy = QStringLiteral("Check cable and battery; the action can be repeated."),
            .info_code = std::nullopt,
            .detail = QString::fromLatin1(QByteArray::fromStdString(turn.record.received))};
}

void Scheduler::Impl::received(std::string_view bytes) {
    bool only_stream = !stream_head_.empty();
    for (const auto& block : reader_.feed(bytes)) {
        if (!takeStream(block)) {
            only_stream = false;
            handleBlock(block, true);
        }
    }
    checkPrompt();
    noteGrowth();
    pump();
    if (!only_stream || (reader_.hasPending() && !mayBecomeStream(reader_.pending()))) {
        armQuiet();
    }
}

bool Scheduler::Impl::isStream(std::string_view text) const {
    text.remove_prefix(std::min(text.find_first_not_of("\r\n"), text.size()));
    return !stream_head_.empty() && text.starts_with(stream_head_);
}

bool Scheduler::Impl::mayBecomeStream(std::string_view text) const {
    text.remove_prefix(std::min(text.find_first_not_of("\r\n"), text.size()));
    return !stream_head_.empty() && (text.starts_with(stream_head_) || stream_head_.starts_with(text));
}

bool Scheduler::Impl::takeStream(const std::string& block) {
    if (!isStream(block)) {
        return false;
    }
    if (owner_ != nullptr && owner_->on_stream) {
        owner_->on_stream(block);
    }
    return true;
}

void Scheduler::Impl::noteGrowth() {
    if (on_wire_.empty() || !on_wire_.front()->waiting || !reader_.hasPending()) {
        return;
    }
    const auto turn = on_wire_.front();
    if (turn->instruction.growing) {
        armTimeLimit(turn);
        turn->instruction.growing(reader_.pending());
    }
}

bool Scheduler::Impl::canAnswer(const Turn& turn, const protocol::Reply& reply) const {
    const auto on_the_wire = byte_time_ * static_cast<double>(turn.instruction.bytes.size()) * kCertainShare;
    const bool possible = std::chrono::duration<double>(clock_.now() - turn.record.sent_at) >= on_the_wire;
    return possible && (!turn.instruction.accepts || turn.instruction.accepts(reply));
}

void Scheduler::Impl::handleBlock(const std::string& text, bool ended) {
    for (std::size_t i = 0; i < on_wire_.size(); ++i) {
        auto reply = protocol::parseReply(text, on_wire_[i]->instruction.separate);
        reply.ended = ended;
        if (canAnswer(*on_wire_[i], reply)) {
            last_text_ = text;
            last_answer_at_ = clock_.now();
            answer(i, reply);
            return;
        }
    }
    handleStray(text);
}

/// Blocks answer in the order of writing: with this one, those written before are no longer owed.
void Scheduler::Impl::answer(std::size_t index, const protocol::Reply& reply) {
    const std::deque<TurnPtr> passed(on_wire_.begin(), on_wire_.begin() + static_cast<std::ptrdiff_t>(index));
    const auto turn = on_wire_[index];
    on_wire_.erase(on_wire_.begin(), on_wire_.begin() + static_cast<std::ptrdiff_t>(index) + 1);
    only_answer_.reset();
    for (const auto& unanswered : passed) {
        finish(unanswered, Outcome::kTimedOut, tl::unexpected(timedOut(*unanswered)));
    }
    if (turn->waiting) {
        turn->record.received = reply.raw;
        finish(turn, Outcome::kAnswered, reply);
        return;
    }
    countStray(StrayKind::kLate, reply.raw);
    if (anyoneWaits()) {
        only_answer_ = reply;
    }
}

void Scheduler::Impl::countStray(StrayKind kind, std::string bytes) {
    switch (kind) {
        case StrayKind::kLate: ++counts_.late; break;
        case StrayKind::kDoubled: ++counts_.doubled; break;
        case StrayKind::kUnsolicited: ++counts_.unsolicited; break;
        case StrayKind::kNoise: ++counts_.noise; break;
    }
    if (owner_ != nullptr && owner_->on_stray) {
        owner_->on_stray({.kind = kind, .bytes = std::move(bytes), .at = clock_.now()});
    }
}

void Scheduler::Impl::handleStray(const std::string& text) {
    const auto reply = protocol::parseReply(text);
    if (swallowLate(text)) {
        countStray(StrayKind::kLate, text);
    } else if (text == last_text_ && clock_.now() - last_answer_at_ <= kDoubledWithin) {
        countStray(StrayKind::kDoubled, text);
    } else if (!reply.status && reply.items.empty()) {
        countStray(StrayKind::kNoise, text);
    } else {
        countStray(StrayKind::kUnsolicited, text);
        if (keeper_ != nullptr) {
            keeper_->passOn(text);
        }
        if (owner_ != nullptr && owner_->on_unsolicited) {
            owner_->on_unsolicited(reply);
        }
    }
}

bool Scheduler::Impl::swallowLate(const std::string& text) {
    std::erase_if(late_, [now = clock_.now()](const Late& late) { return late.until < now; });
    const auto found = std::ranges::find_if(late_, [&](const Late& late) {
        const auto& instruction = late.turn->instruction;
        return instruction.accepts && instruction.accepts(protocol::parseReply(text, instruction.separate));
    });
    if (found == late_.end()) {
        return false;
    }
    late_.erase(found);
    return true;
}

void Scheduler::Impl::checkPrompt() {
    if (on_wire_.empty() || on_wire_.front()->instruction.prompts.empty()) {
        return;
    }
    std::string bare(reader_.pending());
    std::erase_if(bare, [](char c) { return c == '\r' || c == '\n'; });
    if (bare.size() == 1 && on_wire_.front()->instruction.prompts.find(bare) != std::string::npos) {
        reader_.clear();
        answer(0, protocol::Reply{.status = std::nullopt, .items = {}, .raw = bare, .ended = false});
    }
}

void Scheduler::Impl::lost(const core::Error& error) {
    reset(error);
    if (owner_ != nullptr && owner_->on_lost) {
        owner_->on_lost(error);
    }
}

bool Scheduler::Impl::anyoneWaits() const {
    return std::ranges::any_of(on_wire_, [](const TurnPtr& turn) { return turn->waiting; });
}

bool Scheduler::Impl::waitsForQuiet() const {
    if (on_wire_.empty()) {
        return reader_.hasPending();
    }
    const auto& front = *on_wire_.front();
    const bool silence_counts =
        !reader_.endMark() && (reader_.hasPending() || front.instruction.silence_is_success);
    return !front.waiting || only_answer_.has_value() || silence_counts;
}

core::Duration Scheduler::Impl::quietDelay() const {
    const bool file_flows = !on_wire_.empty() && on_wire_.front()->instruction.growing && reader_.hasPending();
    if (file_flows && !on_wire_.front()->waiting) {
        return quiet_time_;  // it ends by itself: what is sent before would meet its lines as answers
    }
    if (!on_wire_.empty() && !on_wire_.front()->waiting) {
        const auto left = owed_since_ + kLongestDrainInQuietTimes * quiet_time_ - clock_.now();
        return std::clamp(left, core::Duration::zero(), quiet_time_);
    }
    if (on_wire_.empty()) {
        return quiet_time_;
    }
    // In the middle of a line more is certain to come; a lone byte behind the last line is an end mark not
    // known yet.
    const auto text = reader_.pending();
    const auto tail = text.size() - std::min(text.find_last_of("\r\n") + 1, text.size());
    return tail > 1 ? kLongestDrainInQuietTimes * quiet_time_ : quiet_time_;
}

void Scheduler::Impl::armQuiet() {
    if (!waitsForQuiet()) {
        quiet_timer_.cancel();
        return;
    }
    quiet_timer_ = clock_.callAfter(quietDelay(), [weak = weak_from_this()] {
        if (const auto self = weak.lock()) {
            self->quiet();
        }
    });
}

void Scheduler::Impl::quiet() {
    const auto unended = reader_.endMark() ? std::nullopt : reader_.flush();
    if (unended) {
        handleBlock(*unended, false);
    } else if (only_answer_ && anyoneWaits()) {
        const auto reply = *only_answer_;
        const auto waiting =
            std::ranges::find_if(on_wire_, [](const TurnPtr& turn) { return turn->waiting; });
        answer(static_cast<std::size_t>(waiting - on_wire_.begin()), reply);
    } else if (!on_wire_.empty() && on_wire_.front()->waiting && !reader_.endMark()) {
        answer(0, protocol::Reply{.status = std::nullopt, .items = {}, .raw = {}, .ended = false});
    } else {
        forgetOwed();
    }
    pump();
    armQuiet();
}

/// While an interrupting transaction waits, the order is kept: the interrupted one may answer first.
void Scheduler::Impl::forgetOwed() {
    if (anyoneWaits()) {
        return;
    }
    for (const auto& turn : std::exchange(on_wire_, {})) {
        late_.push_back({.turn = turn, .until = clock_.now() + kLateRepliesKept});
    }
    if (!mayBecomeStream(reader_.pending())) {
        if (reader_.pending().find_first_not_of("\r\n") != std::string_view::npos) {
            countStray(StrayKind::kNoise, std::string(reader_.pending()));
        }
        reader_.clear();  // the rest of a block of the stream, without its head, would be taken for an answer
    }
}

}  // namespace pmts::scheduler
