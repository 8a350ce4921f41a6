#pragma once

#include "block_watch.hpp"
#include "panel_commands.hpp"
#include "pmts/scheduler/arbiter.hpp"

#include <deque>

namespace pmts::scheduler {

/// The state behind Arbiter: whose turn it is, what the panel has sent and is owed, where a block goes.
class Arbiter::Impl {
public:
    Impl(Arbiter& arbiter, transport::ByteLink& instrument, core::Clock& clock, ArbiterSettings settings);
    ~Impl();

    void setPanel(transport::ByteLink* panel);
    void setMode(ControlMode mode);
    void reset();
    bool take();
    void give();
    void passOn(std::string_view block);
    void setEndMark(std::optional<char> end_mark) { watch_.setEndMark(end_mark); }

    [[nodiscard]] ControlMode mode() const { return mode_; }
    [[nodiscard]] LineOwner owner() const { return shown_owner_; }
    [[nodiscard]] const ControlCounts& counts() const { return counts_; }
    [[nodiscard]] transport::ByteLink& instrument() { return instrument_; }

private:
    struct Waiting {
        std::string command;
        core::Duration since;
    };
    struct PanelTurn {
        TransactionRecord record;
        std::deque<std::string> owed;  ///< commands without their block end yet
        int commands = 0;
        bool in_dialogue = false;  ///< the instrument asks for more (`*`, `@`, `!`): bytes go on as they come
    };
    enum class Route { kNobody, kComputer, kPanel };

    // From the panel.
    void fromPanel(std::string_view bytes);
    void passThrough(std::string_view bytes);
    void queue(PanelCommands::Taken taken);
    void swallow(std::string bytes, Outcome outcome = Outcome::kSwallowed);
    void dropWaiting(Outcome outcome);
    void armHalf();

    // From the instrument.
    void fromInstrument(std::string_view bytes);
    void deliver(const BlockWatch::Piece& piece);
    [[nodiscard]] Route routeNow() const;
    void toPanel(std::string_view bytes);
    void toComputer(std::string_view bytes);
    void noteBlock(const std::string& block);
    void noteDialogue();
    void lost(const core::Error& error);

    // Turns.
    void next();
    void offerToComputer();
    void beginTurn(core::Duration waiting_since);
    void sendNext();
    void becomeWire();
    void noteCommand(const std::string& command);
    void extendTurn();
    void armTurn();
    void turnTimer();
    void endTurnIfAnswered();
    void endTurn(Outcome outcome);
    void applyMode();
    void showOwner();
    [[nodiscard]] bool isBusy() const;

    Arbiter& owner_;
    transport::ByteLink& instrument_;
    transport::ByteLink* panel_ = nullptr;
    core::Clock& clock_;
    ArbiterSettings settings_;
    ControlMode mode_ = ControlMode::kShared;
    std::optional<ControlMode> next_mode_;
    LineOwner shown_owner_ = LineOwner::kIdle;
    ControlCounts counts_;

    PanelCommands commands_;
    std::deque<Waiting> waiting_;
    std::optional<PanelTurn> turn_;
    bool computer_has_it_ = false;
    std::optional<core::Duration> computer_waits_since_;
    Master last_ = Master::kPanel;

    BlockWatch watch_;
    Route route_ = Route::kNobody;
    bool delivering_ = false;
    core::Duration heard_at_{0};
    core::Timer turn_timer_, half_timer_;
};

}  // namespace pmts::scheduler
