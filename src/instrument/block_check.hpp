#pragma once

#include "pmts/protocol/reply.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::instrument {

// The parser of the protocol room is lenient: it passes over noise. A driver on a line without check sums
// must not: here a block is only taken when every byte of it is accounted for.

enum class BlockKind {
    kEmpty,      ///< nothing but the block end: done
    kStatus,     ///< one status line
    kItems,      ///< `label=data` lines, perhaps a status line in front
    kMalformed,  ///< anything else: a damaged block
};

struct CheckedBlock {
    BlockKind kind = BlockKind::kMalformed;
    std::optional<protocol::Status> status;
    std::vector<protocol::Item> items;

    [[nodiscard]] const std::string* find(int label) const;
};

/// Every line must end with CR, LF or both; stray `>` and line ends in front are passed over.
[[nodiscard]] CheckedBlock checkBlock(const protocol::Reply& reply);

/// Digits, at most one point with digits on both sides, at most one sign, no leading zeros: how the
/// instrument writes numbers. The count of decimals; nullopt for a damaged number.
[[nodiscard]] std::optional<int> decimalsOf(std::string_view number);

/// Whether a block can be the answer to `RG,label`, to `RG`, to a command that is only acknowledged. Damaged
/// blocks count as answers where data were asked for: better a question repeated at once than a time-out.
[[nodiscard]] bool canAnswerLabel(const protocol::Reply& reply, int label);
[[nodiscard]] bool canAnswerMeasurement(const protocol::Reply& reply);
[[nodiscard]] bool canAnswerCommand(const protocol::Reply& reply);
/// The same for a command that measures nothing: "already recorded" or "no distance" is then somebody else's
/// answer.
[[nodiscard]] bool canAnswerWrite(const protocol::Reply& reply);
/// Exactly this label and nothing else, or a status: what settles the line after a time-out.
[[nodiscard]] bool isExactlyLabel(const protocol::Reply& reply, int label);

}  // namespace pmts::instrument
