#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

[[nodiscard]] core::Task<core::Result<QString>> getLabel(StatePtr state, int label, std::stop_token stop);
/// Writes and reads back; numbers are compared as numbers, within the decimals that are shown.
[[nodiscard]] core::Task<core::Result<void>> setLabel(StatePtr state, int label, QString data,
                                                      std::stop_token stop);

/// Whether the read-back text means what was written: `12.5` is shown as `12.500`, `96.16838` as `96.1684`.
[[nodiscard]] bool meansTheSame(int label, const std::string& written, const std::string& shown);

}  // namespace pmts::instrument
