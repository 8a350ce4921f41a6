#pragma once

#include "pmts/scheduler/control.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/transport/byte_link.hpp"

#include <memory>
#include <string>

namespace pmts::scheduler {

struct ArbiterSettings {
    std::string command_ends = "\r";  ///< any of them ends a command of the panel
    /// How the running stream of the bus dialect begins; empty: there is none. Its blocks answer nobody and go to both.
    std::string stream_head{};
    core::Duration short_limit = std::chrono::seconds(3);   ///< silence that ends a reading or writing turn of the panel
    core::Duration long_limit = std::chrono::seconds(45);   ///< the same for motions, measurements, processes and files
    /// A command that does not go on for this long is dropped: the instrument forgets it after its own 10 s.
    core::Duration half_command_limit = std::chrono::seconds(11);
    core::Duration quiet_time = std::chrono::milliseconds(500);  ///< ends a reply where label 79 is 0
    int commands_in_turn = 3;  ///< the panel may ask again before its answer, this often while PMTS waits

    /// The bus under the control unit (protocol page 5): stream `A,166=…`, terminators not disclosed.
    [[nodiscard]] static ArbiterSettings forBus();
};

/// Two masters on one instrument line, one transaction at a time (thesis 4.4: two masters writing into one another was
/// its deadlock). It is the link the scheduler stands on and the keeper it asks; the panel is a link of its own.
/// A panel's command is taken when its terminator has come and passed on byte by byte as it was; what comes back until
/// the block end goes to the panel as it comes. In turn when both wait, so that neither starves the other. A block
/// belongs to whoever had the line at its first byte; one that comes while nobody has it goes to both.
/// In panel mode the line is a wire: every byte goes on at once. Instrument thread.
class Arbiter final : public transport::ByteLink, public LineKeeper {
public:
    /// Link and clock outlive the arbiter. Takes the callbacks of the link.
    Arbiter(transport::ByteLink& instrument, core::Clock& clock, ArbiterSettings settings = {});
    ~Arbiter() override;

    /// The panel's port; null: none, or it is gone. Takes its on_received. A turn that runs stays until its end.
    void setPanel(transport::ByteLink* panel);
    /// At once, or when the transaction that runs has ended; new ones wait for it.
    void setMode(ControlMode mode);
    [[nodiscard]] ControlMode mode() const;
    [[nodiscard]] LineOwner owner() const;
    [[nodiscard]] const ControlCounts& counts() const;
    /// The line begins anew: another port, another instrument. A turn of the panel ends here.
    void reset();

    std::function<void(LineOwner owner, core::Duration at)> on_owner;
    std::function<void(ControlMode before, ControlMode mode)> on_mode;  ///< it holds from now on
    /// Each turn of the panel when it has ended, and each command that was swallowed: for the log.
    std::function<void(const TransactionRecord& record)> on_panel_turn;
    /// A command of the panel goes to the instrument: what PMTS knows of the instrument may be old now.
    std::function<void(std::string_view command)> on_panel_command;

    // The scheduler's side.
    [[nodiscard]] core::Result<void> open() override;
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    void write(std::string_view bytes) override;
    [[nodiscard]] QString description() const override;
    [[nodiscard]] bool take() override;
    void give() override;
    void useEndMark(std::optional<char> end_mark) override;
    void passOn(std::string_view block) override;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::scheduler
