#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/transport/byte_link.hpp"

#include <stop_token>
#include <string>

namespace pmts::instrument {

/// How a switched-off instrument is woken over its line: by a BREAK (protocol page 2.9). Its length, the time until the
/// instrument can be asked and the answer to its question are not disclosed.
struct SwitchingOn {
    core::Duration break_length = std::chrono::milliseconds(500);
    core::Duration pause = std::chrono::seconds(2);
    /// To "continue yes/no", asked where its values are kept: they stay. Refused as no command where nothing was asked
    /// (info 30). Empty: none.
    std::string answer = "Y\r";
};

/// Switches on what is behind an open link. Nothing says that it worked: ask who is there. The link and the clock outlive
/// the task. Fails with kUnsupported where the link has no BREAK.
[[nodiscard]] core::Task<core::Result<void>> switchOn(transport::ByteLink& link, core::Clock& clock, SwitchingOn how,
                                                      std::stop_token stop);

}  // namespace pmts::instrument
