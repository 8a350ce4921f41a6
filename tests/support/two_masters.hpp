#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/scheduler/arbiter.hpp"

#include <cstdint>
#include <list>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace pmts::test {

/// What may go wrong in a run of two masters, as probabilities for each transaction.
struct Troubles {
    double silent = 0.0;       ///< the instrument does not answer
    double unplugged = 0.0;    ///< the panel's cable is pulled in mid transaction, and put back
    double unsolicited = 0.0;  ///< the instrument says something nobody asked for
};

/// What came of it. On a line that is arbitrated well all but the first two and the silences are zero.
struct TwoMastersCounts {
    std::uint64_t computer = 0;      ///< transactions begun
    std::uint64_t panel = 0;
    std::uint64_t silent = 0;        ///< not answered by the instrument
    std::uint64_t interleaved = 0;   ///< a command reached the instrument before the other side had its answer
    std::uint64_t mangled = 0;       ///< the instrument got something nobody had sent
    std::uint64_t lost = 0;          ///< answered by the instrument, not heard by whoever asked
    std::uint64_t misdirected = 0;   ///< heard by the other side, or not as it was said
    core::Duration longest_wait{0};  ///< of either side, from the wish to the wire
};

/// PMTS's scheduler and a panel at one instrument, in virtual time: both ask at random moments, often at the same, the
/// instrument answers in random pieces. Every command carries its number and the answer repeats it, so that each side
/// can tell its own. Commands, pieces, pauses and troubles all come from the seed.
class TwoMasters {
public:
    TwoMasters(unsigned seed, Troubles troubles);
    ~TwoMasters();
    TwoMasters(const TwoMasters&) = delete;
    TwoMasters& operator=(const TwoMasters&) = delete;

    /// Runs until this many transactions have ended; false when the line stood still before that: a deadlock.
    [[nodiscard]] bool run(std::uint64_t transactions);
    [[nodiscard]] const TwoMastersCounts& counts() const { return counts_; }
    [[nodiscard]] const scheduler::ControlCounts& control() const { return arbiter_.counts(); }

private:
    class End;
    struct Asked {
        scheduler::Master master;
        core::Duration wished_at;
        std::string answer;  ///< as the instrument says it; empty before it has, or when it does not
    };

    core::Task<void> computer();
    void panelAsks();
    void panelHears(std::string_view bytes);
    void panelEnds();
    void unplugPanel();
    void instrumentHears(std::string_view bytes);
    void instrumentAnswers(const std::string& command);
    void instrumentSays(std::string text, std::optional<std::uint64_t> answers);
    std::string newCommand(scheduler::Master master);
    [[nodiscard]] bool happens(double probability);
    [[nodiscard]] core::Duration upTo(core::Duration most);
    void later(core::Duration after, std::function<void()> action);

    core::VirtualClock clock_;
    core::VideoGate gate_;
    std::mt19937 random_;
    Troubles troubles_;
    std::unique_ptr<End> instrument_;
    std::unique_ptr<End> panel_;
    scheduler::Arbiter arbiter_;
    scheduler::Scheduler line_;
    TwoMastersCounts counts_;
    std::uint64_t ended_ = 0;

    std::uint64_t number_ = 0;
    std::map<std::uint64_t, Asked> asked_;    ///< by the number of the command
    std::string instrument_has_;              ///< of the command that is being received
    std::optional<scheduler::Master> owed_;   ///< whom the instrument has not answered to its end
    core::Duration speaks_until_{0};
    std::uint64_t panel_waits_for_ = 0;
    std::string panel_heard_;
    unsigned panel_turn_ = 0;
    bool stops_ = false;
    bool plugged_ = true;
    std::map<std::uint64_t, core::Timer> timers_;
    std::uint64_t timer_ = 0;
};

}  // namespace pmts::test
