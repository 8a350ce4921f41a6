#include "pmts/scheduler/arbiter.hpp"

#include "arbiter_impl.hpp"

#include <algorithm>

namespace pmts::scheduler {
namespace {

/// A block that pauses for longer, in quiet times, has been broken off.
constexpr int kLongestPauseInQuietTimes = 4;
/// Line ends alone say nothing.
constexpr std::size_t kEmptyBlock = 2;
constexpr std::string_view kPrompts = "*@!";

}  // namespace

ArbiterSettings ArbiterSettings::forBus() {
    ArbiterSettings settings;
    settings.command_ends = "\r\x04";
    settings.stream_head = "A,";
    return settings;
}

Arbiter::Impl::Impl(Arbiter& arbiter, transport::ByteLink& instrument, core::Clock& clock, ArbiterSettings settings)
    : owner_(arbiter),
      instrument_(instrument),
      clock_(clock),
      settings_(std::move(settings)),
      commands_(settings_.command_ends),
      watch_(settings_.stream_head) {
    instrument_.on_received = [this](std::string_view bytes) { fromInstrument(bytes); };
    instrument_.on_lost = [this](const core::Error& error) { lost(error); };
}

Arbiter::Impl::~Impl() {
    if (panel_ != nullptr) {
        panel_->on_received = nullptr;
    }
    instrument_.on_received = nullptr;
    instrument_.on_lost = nullptr;
}

void Arbiter::Impl::setPanel(transport::ByteLink* panel) {
    if (panel_ != nullptr) {
        panel_->on_received = nullptr;
        dropWaiting(Outcome::kCancelled);
        if (mode_ != ControlMode::kPanel && commands_.hasHalf()) {
            swallow(commands_.takeHalf());
        }
    }
    panel_ = panel;
    if (panel_ != nullptr) {
        panel_->on_received = [this](std::string_view bytes) { fromPanel(bytes); };
    }
}

void Arbiter::Impl::setMode(ControlMode mode) {
    next_mode_ = mode;
    next();
}

void Arbiter::Impl::reset() {
    if (turn_) {
        endTurn(Outcome::kFailed);
    }
    dropWaiting(Outcome::kFailed);
    computer_has_it_ = false;
    computer_waits_since_.reset();
    commands_ = PanelCommands(settings_.command_ends);
    half_timer_.cancel();
    watch_.breakOff();
    counts_ = {};
    next();
}

void Arbiter::Impl::fromInstrument(std::string_view bytes) {
    const auto pause = clock_.now() - heard_at_;
    if (pause > settings_.quiet_time * (watch_.endMark() ? kLongestPauseInQuietTimes : 1)) {
        watch_.breakOff();
    }
    heard_at_ = clock_.now();
    delivering_ = true;  // no turn begins between two pieces: the second would be taken for its answer
    for (const auto& piece : watch_.feed(bytes)) {
        deliver(piece);
    }
    delivering_ = false;
    if (turn_ && route_ == Route::kPanel) {
        noteDialogue();
        armTurn();
    }
    endTurnIfAnswered();
    next();
}

void Arbiter::Impl::deliver(const BlockWatch::Piece& piece) {
    if (piece.begins) {
        route_ = piece.streams ? Route::kNobody : routeNow();
    }
    if (route_ != Route::kComputer) {
        toPanel(piece.bytes);
    }
    if (route_ != Route::kPanel) {
        toComputer(piece.bytes);
    }
    if (route_ == Route::kPanel && turn_) {
        turn_->record.received += piece.bytes;
        if (piece.ends) {
            noteBlock(piece.block);
        }
    } else if (route_ == Route::kNobody && piece.ends && !piece.streams && piece.block.size() > kEmptyBlock) {
        ++counts_.unsolicited;
    }
}

Arbiter::Impl::Route Arbiter::Impl::routeNow() const {
    if (computer_has_it_) {
        return Route::kComputer;
    }
    return turn_ && !turn_->owed.empty() ? Route::kPanel : Route::kNobody;
}

void Arbiter::Impl::toPanel(std::string_view bytes) {
    if (panel_ != nullptr) {
        panel_->write(bytes);
    }
}

void Arbiter::Impl::toComputer(std::string_view bytes) {
    if (owner_.on_received) {
        owner_.on_received(bytes);
    }
}

/// What cannot be the answer is something nobody asked for; the panel has it already.
void Arbiter::Impl::noteBlock(const std::string& block) {
    if (!turn_->owed.empty() && canAnswer(turn_->owed.front(), block)) {
        turn_->owed.pop_front();
        turn_->in_dialogue = false;
    } else if (block.size() > kEmptyBlock) {
        ++counts_.unsolicited;
        toComputer(block + *watch_.endMark());
    }
}

void Arbiter::Impl::noteDialogue() {
    std::string bare = watch_.block();
    std::erase_if(bare, [](char c) { return c == '\r' || c == '\n'; });
    turn_->in_dialogue =
        turn_->in_dialogue || (bare.size() == 1 && kPrompts.find(bare) != std::string_view::npos);
}

void Arbiter::Impl::passOn(std::string_view block) {
    if (route_ == Route::kComputer) {
        ++counts_.unsolicited;
        toPanel(block);
        if (const auto mark = watch_.endMark()) {
            toPanel(std::string_view(&*mark, 1));
        }
    }
}

void Arbiter::Impl::lost(const core::Error& error) {
    reset();
    if (owner_.on_lost) {
        owner_.on_lost(error);
    }
}

bool Arbiter::Impl::isBusy() const {
    return computer_has_it_ || turn_ || (mode_ == ControlMode::kPanel && commands_.hasHalf());
}

bool Arbiter::Impl::take() {
    if (isBusy() || delivering_ || mode_ == ControlMode::kPanel) {
        computer_waits_since_ = computer_waits_since_.value_or(clock_.now());
        return false;
    }
    computer_has_it_ = true;
    ++counts_.computer_turns;
    showOwner();
    return true;
}

void Arbiter::Impl::give() {
    if (std::exchange(computer_has_it_, false)) {
        last_ = Master::kComputer;
        next();
    }
}

/// Whoever waits, in turn when both do.
void Arbiter::Impl::next() {
    if (delivering_) {
        return;
    }
    if (isBusy()) {
        showOwner();
        return;
    }
    applyMode();
    if (last_ == Master::kPanel || waiting_.empty()) {
        offerToComputer();
    }
    if (!isBusy() && !waiting_.empty()) {
        beginTurn(waiting_.front().since);
        sendNext();
    }
    showOwner();
}

void Arbiter::Impl::offerToComputer() {
    if (!computer_waits_since_ || mode_ == ControlMode::kPanel) {
        return;
    }
    const auto waited = clock_.now() - *std::exchange(computer_waits_since_, std::nullopt);
    counts_.longest_computer_wait = std::max(counts_.longest_computer_wait, waited);
    if (owner_.on_free) {
        owner_.on_free();
    }
}

void Arbiter::Impl::applyMode() {
    const auto wanted = std::exchange(next_mode_, std::nullopt);
    if (!wanted || *wanted == mode_) {
        return;
    }
    const auto before = std::exchange(mode_, *wanted);
    if (mode_ == ControlMode::kComputer) {
        dropWaiting(Outcome::kSwallowed);
    } else if (mode_ == ControlMode::kPanel) {
        becomeWire();
    }
    if (owner_.on_mode) {
        owner_.on_mode(before, mode_);
    }
}

void Arbiter::Impl::showOwner() {
    const auto working = computer_has_it_ ? LineOwner::kComputer : turn_ ? LineOwner::kPanel : LineOwner::kIdle;
    const auto now = mode_ == ControlMode::kPanel ? LineOwner::kPanel : working;
    if (std::exchange(shown_owner_, now) != now && owner_.on_owner) {
        owner_.on_owner(now, clock_.now());
    }
}

Arbiter::Arbiter(transport::ByteLink& instrument, core::Clock& clock, ArbiterSettings settings)
    : impl_(std::make_unique<Impl>(*this, instrument, clock, std::move(settings))) {}
Arbiter::~Arbiter() = default;

void Arbiter::setPanel(transport::ByteLink* panel) { impl_->setPanel(panel); }
void Arbiter::setMode(ControlMode mode) { impl_->setMode(mode); }
ControlMode Arbiter::mode() const { return impl_->mode(); }
LineOwner Arbiter::owner() const { return impl_->owner(); }
const ControlCounts& Arbiter::counts() const { return impl_->counts(); }
void Arbiter::reset() { impl_->reset(); }
core::Result<void> Arbiter::open() { return impl_->instrument().open(); }
void Arbiter::close() { impl_->instrument().close(); }
bool Arbiter::isOpen() const { return impl_->instrument().isOpen(); }
void Arbiter::write(std::string_view bytes) { impl_->instrument().write(bytes); }
QString Arbiter::description() const { return impl_->instrument().description(); }
bool Arbiter::take() { return impl_->take(); }
void Arbiter::give() { impl_->give(); }
void Arbiter::useEndMark(std::optional<char> end_mark) { impl_->setEndMark(end_mark); }
void Arbiter::passOn(std::string_view block) { impl_->passOn(block); }

}  // namespace pmts::scheduler
