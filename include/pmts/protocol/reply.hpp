#pragma once

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

/// One block, from the first byte to the block end.
struct Reply {
    std::optional<Status> status;
    std::vector<Item> items;
    std::string raw;          ///< bytes without the block end, for the log
    bool ended = true;        ///< false when a time-out closed it (label 79 = 0)

    [[nodiscard]] const Item* find(int label) const;
    [[nodiscard]] bool operator==(const Reply&) const = default;
};

/// Block -> values, in any of the forms S, N, D, V (V: a line with a label number, then a line with its data).
/// `separate` says that the V form was asked for; nothing in the text tells `7` the label from `7` the data.
[[nodiscard]] Reply parseReply(std::string_view block, bool separate = false);

/// Cuts a byte stream into blocks at the end mark (label 79). Takes any chunking, stray marks at the start, garbage.
class BlockReader {
public:
    explicit BlockReader(std::optional<char> end_mark = '>') : end_mark_(end_mark) {}

    /// Complete blocks, without their end mark; an unfinished one is kept. Empty blocks are reported: they answer writes.
    [[nodiscard]] std::vector<std::string> feed(std::string_view bytes);
    /// The line went quiet: hands out what is there (label 79 = 0) and forgets it.
    [[nodiscard]] std::optional<std::string> flush();
    void clear() { pending_.clear(); }
    void setEndMark(std::optional<char> end_mark) { end_mark_ = end_mark; }
    [[nodiscard]] bool hasPending() const { return !pending_.empty(); }
    /// Unfinished bytes: the driver looks here for the `*`, `@` and `!` prompts.
    [[nodiscard]] std::string_view pending() const { return pending_; }

private:
    std::optional<char> end_mark_;
    std::string pending_;
};

}  // namespace pmts::protocol
