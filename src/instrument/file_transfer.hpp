#pragma once

#include "exchange.hpp"
#include "pmts/instrument/memory.hpp"

namespace pmts::instrument {

/// OMC, OIC and M: what is in the memory and how much room is left.
[[nodiscard]] core::Task<core::Result<MemoryListing>> listMemory(StatePtr state, std::stop_token stop);

/// OM= or OI=, read until two readings are the same to the byte. kDevice 32: there is no such file.
[[nodiscard]] core::Task<core::Result<DownloadedFile>> downloadFile(StatePtr state, MemoryFileId id, OnTransfer progress,
                                                                    std::stop_token stop);

/// LM= or LI=: waits for `*`, sends the lines and the end mark in one hold of the line, reads the file back.
/// kDevice 33: it exists (nothing is overwritten), 34, 35: a line was not accepted, 36: memory full, 24: wrong state.
[[nodiscard]] core::Task<core::Result<UploadedFile>> uploadFile(StatePtr state, MemoryFileId id,
                                                                std::vector<std::string> lines, OnTransfer progress,
                                                                std::stop_token stop);

}  // namespace pmts::instrument
