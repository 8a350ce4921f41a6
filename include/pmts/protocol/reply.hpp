#pragma once

#include "pmts/core/result.hpp"
#include "pmts/protocol/command.hpp"

#include <QString>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::protocol {

/// An info code as it stands in a reply: `35.8` is code 35 of device 8.
struct Status {
    int code = 0;
    std::optional<int> suffix;

    [[nodiscard]] bool operator==(const Status&) const = default;
};

/// One line of data. `label` for `7=177.5612` and the V form, `name` for the N form, neither for the D form.
struct Item {
    std::optional<int> label;
    std::string name;
    std::string data;

    [[nodiscard]] bool operator==(const Item&) const = default;
};

/// EOT ends a block on the bus (protocol page 5.1); on the external interface label 79 says what does.
inline constexpr char kBusBlockEnd = '\x04';

/// One block, from the first byte to the block end.
struct Reply {
    std::optional<Status> status;
    std::vector<Item> items;
    std::string raw;          ///< bytes without the block end, for the log
    bool ended = true;        ///< false when a time-out closed it (label 79 = 0)
    /// Bytes were lost or turned on the way: a label twice, a line that is nothing, bytes that are no text. Two blocks
    /// run into one when the end mark between them is lost: believe no number of such a reply, ask again.
    bool damaged = false;

    [[nodiscard]] const Item* find(int label) const;
    [[nodiscard]] bool operator==(const Reply&) const = default;
};

/// What was asked for decides how some lines are read: nothing in the text tells `7` the label from `7` the data,
/// nor the data `104` of `RGD,5` from a status 104.
struct ReplyShape {
    ReadForm form = ReadForm::kStandard;
    bool one_label = false;  ///< no status line on success
    bool file = false;       ///< names or contents of files: labels come again and again
};
[[nodiscard]] ReplyShape shapeOf(const Command& command);

/// Block -> values, in any of the forms S, N, D, V (V: a line with a label number, then a line with its data).
/// Stray marks and bytes that are no text are passed over at the start without damage; in S and N form lines that are
/// neither status nor item are left to `raw`. A single line that answers `RGD,lbl` is data, even where it looks like a status.
[[nodiscard]] Reply parseReply(std::string_view block, ReplyShape shape);
/// The same where the form is not known: with a `=` anywhere it is S or N, else D; `separate` says it is V.
[[nodiscard]] Reply parseReply(std::string_view block, bool separate = false);

/// `35.8` and `0`, nothing else (at most three digits, at most two of suffix).
[[nodiscard]] std::optional<Status> parseStatus(std::string_view line);

/// Label 79 as written by the instrument: `62` is `>`, `0` means that no block end is sent. Fails with kProtocol.
[[nodiscard]] core::Result<std::optional<char>> endMarkFromLabel(std::string_view data);
[[nodiscard]] std::string endMarkText(std::optional<char> end_mark);

/// Cuts a byte stream into blocks at the end mark (label 79). Takes any chunking, stray marks, garbage.
/// A stray mark shows as an empty block: whoever waits for data passes over it, whoever waits for `done` is served.
class BlockReader {
public:
    explicit BlockReader(std::optional<char> end_mark = '>') : end_mark_(end_mark) {}

    /// Complete blocks, without their end mark; an unfinished one is kept. Empty blocks are reported: they answer writes.
    [[nodiscard]] std::vector<std::string> feed(std::string_view bytes);
    /// The line went quiet: hands out what is there (label 79 = 0) and forgets it.
    [[nodiscard]] std::optional<std::string> flush();
    void clear();
    /// Holds for the block that is being read, too.
    void setEndMark(std::optional<char> end_mark);
    [[nodiscard]] std::optional<char> endMark() const { return end_mark_; }
    [[nodiscard]] bool hasPending() const { return !pending_.empty(); }
    /// Unfinished bytes: the driver looks here for the `*`, `@` and `!` prompts.
    [[nodiscard]] std::string_view pending() const { return pending_; }

private:
    std::optional<char> end_mark_;
    std::string pending_;
    std::size_t searched_ = 0;  ///< bytes of pending_ known to hold no end mark
};

}  // namespace pmts::protocol
