#include "support/two_masters.hpp"

#include "pmts/core/task.hpp"

#include <algorithm>

namespace pmts::test {
namespace {

using namespace std::chrono_literals;
using scheduler::Master;

constexpr core::Duration kPanelPatience = 60s;
constexpr std::string_view kUnasked = "99=1.0\r\n>";

/// `RG,12=`, the number of a command as both sides write it.
std::optional<std::uint64_t> numberIn(std::string_view text) {
    const auto digits = text.find_first_of("0123456789", text.find('#'));
    if (text.find('#') == std::string_view::npos || digits == std::string_view::npos) {
        return std::nullopt;
    }
    return std::stoull(std::string(text.substr(digits)));
}

}  // namespace

/// A cable's end that a test writes at and listens to.
class TwoMasters::End final : public transport::ByteLink {
public:
    explicit End(std::function<void(std::string_view)> hear) : hear_(std::move(hear)) {}
    core::Result<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] bool isOpen() const override { return true; }
    void write(std::string_view bytes) override { hear_(bytes); }
    [[nodiscard]] QString description() const override { return QStringLiteral("virtual"); }
    void say(std::string_view bytes) const {
        if (on_received) {
            on_received(bytes);
        }
    }

private:
    std::function<void(std::string_view)> hear_;
};

TwoMasters::TwoMasters(unsigned seed, Troubles troubles)
    : random_(seed),
      troubles_(troubles),
      instrument_(std::make_unique<End>([this](std::string_view bytes) { instrumentHears(bytes); })),
      panel_(std::make_unique<End>([this](std::string_view bytes) { panelHears(bytes); })),
      arbiter_(*instrument_, clock_),
      line_(arbiter_, clock_, gate_) {
    line_.setKeeper(&arbiter_);
    arbiter_.setPanel(panel_.get());
}

TwoMasters::~TwoMasters() {
    stops_ = true;
    line_.setKeeper(nullptr);
    line_.reset(core::cancelled().value());
    clock_.advance(1s);
}

bool TwoMasters::run(std::uint64_t transactions) {
    const auto wanted = ended_ + transactions;
    stops_ = false;
    const auto running = computer();
    later(0ms, [this] { panelAsks(); });
    core::Duration progress_at = clock_.now();
    for (auto before = ended_; ended_ < wanted; core::deliverQueuedEvents()) {
        if (!clock_.advanceToNextTimer(core::Duration::max()) || clock_.now() - progress_at > 10min) {
            return false;
        }
        progress_at = std::exchange(before, ended_) == ended_ ? progress_at : clock_.now();
    }
    stops_ = true;
    clock_.advance(2min);
    return true;
}

bool TwoMasters::happens(double probability) {
    return probability > 0 && std::uniform_real_distribution<double>(0, 1)(random_) < probability;
}

/// Often nothing at all: then both sides begin at the same moment.
core::Duration TwoMasters::upTo(core::Duration most) {
    return happens(0.3) ? core::Duration{0} : core::Duration(std::uniform_int_distribution<std::int64_t>(0, most.count())(random_));
}

void TwoMasters::later(core::Duration after, std::function<void()> action) {
    const auto id = ++timer_;
    timers_[id] = clock_.callAfter(after, [this, id, action = std::move(action)] {
        const auto done = timers_.extract(id);
        action();
    });
}

std::string TwoMasters::newCommand(Master master) {
    static constexpr std::array kWords{"RG,5", "WG,5", "WS=PH02V02", "TG", "RGT", "RG"};
    // A block that nobody asked for looks like the answer to a bare RG: no arbiter can tell them apart.
    const std::size_t choices = kWords.size() - (troubles_.unsolicited > 0 ? 1 : 0);
    const std::string word = kWords.at(std::uniform_int_distribution<std::size_t>(0, choices - 1)(random_));
    asked_[++number_] = {.master = master, .wished_at = clock_.now(), .answer = {}};
    ++(master == Master::kComputer ? counts_.computer : counts_.panel);
    return word + '#' + std::to_string(number_) + '\r';
}

// ---- PMTS

core::Task<void> TwoMasters::computer() {
    while (!stops_) {
        scheduler::MicroInstruction instruction;
        instruction.bytes = newCommand(Master::kComputer);
        instruction.time_limit = 10s;
        const auto number = number_;
        instruction.accepts = [number](const protocol::Reply& reply) { return numberIn(reply.raw) == number; };
        auto asking = line_.execute(instruction);
        const auto reply = co_await asking;
        const auto& answer = asked_[number].answer;
        if (reply) {
            counts_.misdirected += reply->raw + '>' != answer ? 1 : 0;
        } else {
            counts_.lost += answer.empty() ? 0 : 1;
        }
        asked_.erase(number);
        ++ended_;
        auto pausing = core::sleepFor(clock_, upTo(60ms));
        [[maybe_unused]] const auto paused = co_await pausing;
    }
}

// ---- the panel

void TwoMasters::panelAsks() {
    if (stops_) {
        return;
    }
    const std::string command = newCommand(Master::kPanel);
    panel_waits_for_ = number_;
    core::Duration at{0};
    for (std::size_t sent = 0; sent < command.size();) {
        const auto size = std::uniform_int_distribution<std::size_t>(1, command.size() - sent)(random_);
        later(at, [this, part = command.substr(sent, size)] { panel_->say(part); });
        sent += size;
        at += upTo(5ms);
    }
    if (happens(troubles_.unplugged)) {
        later(upTo(100ms), [this] { unplugPanel(); });
    }
    later(at + kPanelPatience, [this, turn = ++panel_turn_] {
        if (turn == panel_turn_) {
            panelEnds();
        }
    });
}

void TwoMasters::panelHears(std::string_view bytes) {
    panel_heard_ += bytes;
    for (auto end = panel_heard_.find('>'); end != std::string::npos; end = panel_heard_.find('>')) {
        const std::string block = panel_heard_.substr(0, end + 1);
        panel_heard_.erase(0, end + 1);
        if (kUnasked.ends_with(block)) {  // or the tail of one, when the cable was put back in the middle
            continue;
        }
        const auto asked = asked_.find(panel_waits_for_);
        if (asked == asked_.end() || block != asked->second.answer) {
            ++counts_.misdirected;
        } else {
            panelEnds();
        }
    }
}

void TwoMasters::panelEnds() {
    const auto asked = asked_.find(panel_waits_for_);
    if (asked != asked_.end() && panel_heard_.empty() && clock_.now() - asked->second.wished_at >= kPanelPatience) {
        counts_.lost += asked->second.answer.empty() ? 0 : 1;
    }
    asked_.erase(panel_waits_for_);
    panel_waits_for_ = 0;
    ++panel_turn_;
    ++ended_;
    later(upTo(60ms), [this, turn = panel_turn_] {
        if (turn == panel_turn_) {  // not unplugged meanwhile
            panelAsks();
        }
    });
}

/// What the instrument says meanwhile goes nowhere; the panel comes back and begins anew.
void TwoMasters::unplugPanel() {
    if (!std::exchange(plugged_, false)) {
        return;
    }
    arbiter_.setPanel(nullptr);
    asked_.erase(panel_waits_for_);
    panel_waits_for_ = 0;
    ++panel_turn_;
    later(200ms + upTo(10s), [this] {
        panel_heard_.clear();
        plugged_ = true;
        arbiter_.setPanel(panel_.get());
        ++ended_;
        panelAsks();
    });
}

// ---- the instrument

void TwoMasters::instrumentHears(std::string_view bytes) {
    for (const char byte : bytes) {
        instrument_has_ += byte;
        if (byte == '\r') {
            instrumentAnswers(std::exchange(instrument_has_, {}));
        }
    }
}

void TwoMasters::instrumentAnswers(const std::string& command) {
    const auto number = numberIn(command);
    const auto asked = asked_.find(number.value_or(0));
    if (std::ranges::count(command, '#') != 1 || !number) {
        ++counts_.mangled;
        return;
    }
    const auto master = asked == asked_.end() ? Master::kPanel : asked->second.master;  // unplugged meanwhile
    counts_.interleaved += owed_ && *owed_ != master ? 1 : 0;
    if (asked != asked_.end()) {
        counts_.longest_wait = std::max(counts_.longest_wait, clock_.now() - asked->second.wished_at);
    }
    if (happens(troubles_.silent)) {
        ++counts_.silent;
        return;
    }
    owed_ = master;
    const std::string line = command.starts_with("RG,") ? "5=" : command.starts_with("RG#") ? "7=" : "info";
    instrumentSays(line + '#' + std::to_string(*number) + "\r\n>", number);
    if (happens(troubles_.unsolicited)) {
        instrumentSays(std::string(kUnasked), std::nullopt);
    }
}

/// In pieces, one after the other as on a wire.
void TwoMasters::instrumentSays(std::string text, std::optional<std::uint64_t> answers) {
    if (const auto asked = asked_.find(answers.value_or(0)); asked != asked_.end()) {
        asked->second.answer = text;
    }
    speaks_until_ = std::max(speaks_until_, clock_.now()) + upTo(80ms);
    for (std::size_t said = 0; said < text.size();) {
        const auto size = std::uniform_int_distribution<std::size_t>(1, text.size() - said)(random_);
        speaks_until_ += upTo(8ms) + 1us;
        const bool is_last = said + size == text.size();
        later(speaks_until_ - clock_.now(), [this, part = text.substr(said, size), ends = is_last && answers] {
            owed_ = ends ? std::nullopt : owed_;
            instrument_->say(part);
        });
        said += size;
    }
}

}  // namespace pmts::test
