#pragma once

#include "pmts/scheduler/scheduler.hpp"

#include <array>
#include <deque>
#include <vector>

namespace pmts::scheduler {

/// One execute(), from the queue over the wire to its end.
struct Turn {
    explicit Turn(MicroInstruction what) : instruction(std::move(what)) {}

    MicroInstruction instruction;
    core::Completion<protocol::Reply> completion;
    TransactionRecord record;
    std::optional<core::VideoGate::Pause> pause;
    core::Timer time_limit;
    int holder = 0;       ///< of the hold it came with; the hold itself is its owner's
    bool waiting = true;  ///< false: its waiter has gone, but the line still owes the answer
};
using TurnPtr = std::shared_ptr<Turn>;

[[nodiscard]] core::Error timedOut(const Turn& turn);

/// The state behind Scheduler: queues, what is on the wire, and whose answer a block is.
class Scheduler::Impl : public std::enable_shared_from_this<Impl> {
public:
    Impl(transport::ByteLink& link, core::Clock& clock, core::VideoGate& gate)
        : link_(link), clock_(clock), gate_(gate) {}

    static core::Task<core::Result<protocol::Reply>> run(std::shared_ptr<Impl> line,
                                                         MicroInstruction instruction, std::stop_token stop);
    void attach(Scheduler& owner);
    void detach();

    void submit(const TurnPtr& turn);
    void withdraw(const TurnPtr& turn);
    void failAll(const core::Error& error);
    void reset(const core::Error& error);
    void setKeeper(LineKeeper* keeper);
    void bar(std::optional<core::Error> reason);
    [[nodiscard]] Hold makeHold();
    void setEndMark(std::optional<char> end_mark);
    [[nodiscard]] std::optional<char> endMark() const { return reader_.endMark(); }
    void setQuietTime(core::Duration quiet_time) { quiet_time_ = quiet_time; }
    void setStreamHead(std::string head) { stream_head_ = std::move(head); }
    void setByteTime(core::Duration byte_time) { byte_time_ = byte_time; }
    [[nodiscard]] bool isIdle() const;
    [[nodiscard]] const LineCounts& counts() const { return counts_; }

private:
    // Sending.
    void pump();
    [[nodiscard]] bool isQueueEmpty() const;
    [[nodiscard]] bool hasNext() const;
    [[nodiscard]] bool takeLine();
    void letGo();
    void endHold(int holder);
    [[nodiscard]] bool maySend(const Turn& turn) const { return holder_ == 0 || turn.holder == holder_; }
    void failQueued(const core::Error& error);
    TurnPtr nextQueued();
    void write(const TurnPtr& turn);
    void timeOut(const TurnPtr& turn);
    /// Tells the waiter; what it does next runs from the event loop.
    void finish(const TurnPtr& turn, Outcome outcome, core::Result<protocol::Reply> result);
    void leaveOwed(const TurnPtr& turn, Outcome outcome, core::Result<protocol::Reply> result);

    // Receiving.
    void received(std::string_view bytes);
    [[nodiscard]] bool takeStream(const std::string& block);
    [[nodiscard]] bool isStream(std::string_view text) const;
    [[nodiscard]] bool mayBecomeStream(std::string_view text) const;
    void handleBlock(const std::string& text, bool ended);
    [[nodiscard]] bool canAnswer(const Turn& turn, const protocol::Reply& reply) const;
    void answer(std::size_t index, const protocol::Reply& reply);
    void handleStray(const std::string& text);
    void countStray(StrayKind kind, std::string bytes);
    bool swallowLate(const std::string& text);
    void checkPrompt();
    void noteGrowth();
    void armTimeLimit(const TurnPtr& turn);
    void lost(const core::Error& error);

    // Quiet line.
    void armQuiet();
    [[nodiscard]] bool waitsForQuiet() const;
    [[nodiscard]] core::Duration quietDelay() const;
    void quiet();
    void forgetOwed();

    [[nodiscard]] bool anyoneWaits() const;

    transport::ByteLink& link_;
    core::Clock& clock_;
    core::VideoGate& gate_;
    Scheduler* owner_ = nullptr;
    LineKeeper* keeper_ = nullptr;
    bool has_line_ = false;  ///< the keeper let us onto it
    std::optional<core::Error> barred_;
    int holder_ = 0;  ///< 0: the line is for everybody
    int last_holder_ = 0;
    protocol::BlockReader reader_;
    std::string stream_head_;
    std::array<std::deque<TurnPtr>, 3> queues_;  ///< by Priority
    std::deque<TurnPtr> on_wire_;                ///< written, answer owed; oldest first
    struct Late {
        TurnPtr turn;
        core::Duration until;
    };
    std::vector<Late> late_;  ///< owed answers that were given up, in case they come after all
    /// Taken for the late answer of an interrupted transaction; given to the interrupting one if nothing
    /// follows.
    std::optional<protocol::Reply> only_answer_;
    std::string last_text_;
    core::Duration last_answer_at_{0};
    core::Duration owed_since_{0};
    core::Timer quiet_timer_;
    core::Duration quiet_time_ = std::chrono::milliseconds(500);
    core::Duration byte_time_{0};
    LineCounts counts_;
};

}  // namespace pmts::scheduler
