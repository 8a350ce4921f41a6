#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

/// Finds the block end and the units, asks for the serial number, reads the circles.
[[nodiscard]] core::Task<core::Result<Identity>> identify(StatePtr state, std::stop_token stop);

/// What came instead of an answer, as the sentence for the connection page: nothing, unreadable, somebody
/// else.
[[nodiscard]] core::Error noInstrument(const std::string& heard);

}  // namespace pmts::instrument
