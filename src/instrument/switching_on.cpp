#include "pmts/instrument/switching_on.hpp"

namespace pmts::instrument {

core::Task<core::Result<void>> switchOn(transport::ByteLink& link, core::Clock& clock, SwitchingOn how, std::stop_token stop) {
    PMTS_CO_TRY(link.setBreak(true));
    auto holding = core::sleepFor(clock, how.break_length, stop);
    const auto held = co_await holding;
    PMTS_CO_TRY(link.setBreak(false));  // also when cancelled: a line that is held carries nothing
    PMTS_CO_TRY(held);
    auto waiting = core::sleepFor(clock, how.pause, stop);
    PMTS_CO_TRY(co_await waiting);
    link.write(how.answer);
    auto settling = core::sleepFor(clock, how.break_length, stop);
    co_return co_await settling;
}

}  // namespace pmts::instrument
