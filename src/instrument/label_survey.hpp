#pragma once

#include "exchange.hpp"
#include "pmts/instrument/memory.hpp"
#include "pmts/protocol/label_backup.hpp"

namespace pmts::instrument {

/// Reads all labels of protocol::backupLabels(); a refusal is an answer. Only `RG,n` leaves.
[[nodiscard]] core::Task<core::Result<protocol::LabelBackup>> backUpLabels(StatePtr state, OnTransfer progress,
                                                                           std::stop_token stop);

}  // namespace pmts::instrument
