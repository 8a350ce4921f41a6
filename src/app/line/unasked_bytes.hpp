#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/scheduler/scheduler.hpp"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace pmts::app {

/// Bytes of one moment that belong to no transaction, without their block end.
struct UnaskedPiece {
    core::Duration at{0};
    std::string bytes;
};

/// Takes the answers out of the recorded bytes of the line: what is left came by itself (REG key, slave mode, the stream of
/// the bus), or is echo or noise. A piece for each block.
class UnaskedBytes {
public:
    /// The line begins anew: an answer may have begun before.
    void clear();
    void addReceived(std::string_view bytes, core::Duration at);
    /// Everything before the end of this transaction is decided.
    [[nodiscard]] std::vector<UnaskedPiece> take(const scheduler::TransactionRecord& record);
    /// Everything until then is decided: no transaction claims it any more.
    [[nodiscard]] std::vector<UnaskedPiece> takeOlderThan(core::Duration moment);

private:
    struct Byte {
        core::Duration at{0};
        char value = 0;
    };
    /// Of these bytes, those that `claimed` does not hold in this order.
    [[nodiscard]] static std::vector<Byte> without(const std::vector<Byte>& bytes, std::string_view claimed);
    [[nodiscard]] std::vector<UnaskedPiece> piecesOf(const std::vector<Byte>& bytes, core::Duration now);
    void closeWhenQuiet(core::Duration now, std::vector<UnaskedPiece>& pieces);
    [[nodiscard]] std::vector<Byte> taken(core::Duration until);

    std::deque<Byte> waiting_;
    std::optional<UnaskedPiece> open_;  ///< its block end has not come yet
    core::Duration last_at_{0};         ///< of its last byte
    bool is_first_ = true;  ///< transaction since the beginning
};

}  // namespace pmts::app
