#pragma once

#include "pmts/core/result.hpp"
#include "pmts/protocol/reply.hpp"

#include <QDateTime>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::protocol {

/// What one label answered when it was read.
struct LabelReading {
    int label = 0;
    std::optional<std::string> data;
    std::optional<Status> refused;  ///< instead of data; neither: it did not answer
    bool steady = true;             ///< false: it changed while it was read (a circle, the clock)

    [[nodiscard]] bool isSilent() const { return !data && !refused; }
    [[nodiscard]] bool operator==(const LabelReading&) const = default;
};

/// All labels of an instrument at one time (features C23). Only read; nothing is ever written back from it.
struct LabelBackup {
    QDateTime utc;
    std::string serial_number;  ///< label 55; empty when the instrument does not say
    std::string temperature;    ///< label 56 as it stands, the unit is in label 23
    std::vector<LabelReading> readings;
};

/// 0-109, then the service labels that may be read (protocol page 3.2): not 127 (service access), not 247 and 250
/// (radio command, test), not the transport labels 251-254.
[[nodiscard]] const std::vector<int>& backupLabels();

/// One text: head lines that begin with `#`, then `label=data`, or `label!status` where it was refused; `~` instead of
/// `=` for a value that changed while it was read; `label?` where nothing was answered.
[[nodiscard]] std::string backupText(const LabelBackup& backup);
/// kBadInput names the line that cannot be read.
[[nodiscard]] core::Result<LabelBackup> parseBackup(std::string_view text);

/// A label that says something else than before; absent where it was refused or not read. One that was silent either
/// time says nothing of a change.
struct LabelChange {
    int label = 0;
    std::optional<std::string> before, after;
    bool is_setting = false;  ///< neither measured nor computed nor the clock: somebody or something set it

    [[nodiscard]] bool operator==(const LabelChange&) const = default;
};
[[nodiscard]] std::vector<LabelChange> changesBetween(const LabelBackup& before, const LabelBackup& after);

}  // namespace pmts::protocol
