#pragma once

#include "pmts/protocol/labels.hpp"

#include <span>

namespace pmts::protocol {

/// The rows as printed in the protocol page, section 3.1, in ascending order.
[[nodiscard]] std::span<const Label> labelTable();

}  // namespace pmts::protocol
