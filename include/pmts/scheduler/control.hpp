#pragma once

#include "pmts/core/clock.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace pmts::scheduler {

/// Who asks on a line that two share: PMTS, or the maker's control unit on a second port.
enum class Master { kComputer, kPanel };

/// The three modes of control (thesis ch. 3).
enum class ControlMode {
    kShared,    ///< both, one transaction at a time
    kComputer,  ///< the panel's bytes are swallowed and logged
    kPanel,     ///< PMTS sends nothing, it listens and logs
};

/// Whose transaction is on the line. In panel mode it is the panel's all the time.
enum class LineOwner { kIdle, kComputer, kPanel };

/// What has passed since the line was opened.
struct ControlCounts {
    std::uint64_t computer_turns = 0;
    std::uint64_t panel_turns = 0;
    std::uint64_t panel_commands = 0;   ///< more than turns where the panel asked again before its answer
    std::uint64_t panel_timed_out = 0;  ///< turns that the instrument did not answer
    std::uint64_t swallowed = 0;        ///< commands of the panel that did not go to the instrument
    std::uint64_t unsolicited = 0;      ///< blocks that nobody asked for
    core::Duration longest_computer_wait{0};
    core::Duration longest_panel_wait{0};

    [[nodiscard]] bool operator==(const ControlCounts&) const = default;
};

/// Lets a scheduler onto a line that it shares, one transaction at a time.
class LineKeeper {
public:
    virtual ~LineKeeper() = default;

    /// True: the line is the scheduler's until give(). False: on_free will say when to ask again.
    [[nodiscard]] virtual bool take() = 0;
    virtual void give() = 0;
    virtual void useEndMark(std::optional<char> end_mark) = 0;
    /// A block that came in the scheduler's turn and is no answer to it: the other side may know what it is.
    virtual void passOn(std::string_view block) = 0;

    std::function<void()> on_free;
};

}  // namespace pmts::scheduler
