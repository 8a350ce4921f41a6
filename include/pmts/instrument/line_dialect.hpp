#pragma once

namespace pmts::instrument {

/// Which of the two languages is spoken at the contacts the line is on (protocol page, sections 1 and 5).
enum class LineDialect {
    kExternal,  ///< the serial connector in the foot, documented by the maker
    kBus,       ///< the contacts under the detachable panel
};

}  // namespace pmts::instrument
