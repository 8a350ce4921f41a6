#pragma once

#include "file_transfer.hpp"

namespace pmts::instrument {

/// kBadInput for what the instrument would not take as the name of a file.
[[nodiscard]] core::Result<void> checkName(const MemoryFileId& id);

/// OM= or OI=, until two readings agree. A block of readings that the instrument sends by itself is not taken for the file,
/// unless it is `expected`: what was just sent.
[[nodiscard]] core::Task<core::Result<DownloadedFile>> readFile(StatePtr state, MemoryFileId id,
                                                                std::vector<std::string> expected, OnTransfer progress,
                                                                std::stop_token stop);

}  // namespace pmts::instrument
