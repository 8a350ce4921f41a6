#pragma once

#include "pmts/protocol/info_code.hpp"

#include <span>

namespace pmts::protocol {

/// A code or a range of codes with one meaning. Texts are translated in the context `InfoCode`.
struct InfoRow {
    int first = 0;
    int last = 0;
    InfoClass info_class = InfoClass::kUnknown;
    const char* happened = "";
    const char* remedy = "";
};

/// Protocol page, section 2.10, ascending. A single code inside a range stands before the range.
[[nodiscard]] std::span<const InfoRow> infoTable();

}  // namespace pmts::protocol
