#pragma once

#include "watch.hpp"

#include <algorithm>
#include <string_view>

namespace pmts::protocol {

inline constexpr std::size_t kMostLines = 32;

/// kBadInput that names the line of a text capture.
[[nodiscard]] tl::unexpected<core::Error> unreadableLine(std::size_t line, std::string_view text);

/// The text for a sentence: at most 80 characters of it.
[[nodiscard]] QString clipped(std::string_view text);

/// Without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Calls `use(number, line)` for each line until it returns an error. kCancelled when `progress` says false.
template <class Use>
core::Result<void> eachLine(std::string_view text, Use use, const Progress& progress = {}) {
    const std::size_t whole = text.size();
    Watch watch(progress);
    std::size_t number = 0;
    while (!text.empty()) {
        if (!watch.goesOn(number, whole - text.size(), whole)) {
            return core::cancelled();
        }
        const std::size_t end = std::min(text.find('\n'), text.size());
        PMTS_TRY(use(++number, trimmed(text.substr(0, end))));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

}  // namespace pmts::protocol
