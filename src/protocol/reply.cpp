#include "pmts/protocol/reply.hpp"

#include <algorithm>
#include <charconv>

namespace pmts::protocol {
namespace {

/// A line that never ends is noise: no file of the instrument is longer.
constexpr std::size_t kLongestBlock = std::size_t{1} << 20;

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isText(char c) { return c >= 0x20 && c <= 0x7E; }

bool isNumber(std::string_view text, std::size_t most_digits) {
    return !text.empty() && text.size() <= most_digits && std::ranges::all_of(text, isDigit);
}

int toInt(std::string_view digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

std::string_view withoutStrayStart(std::string_view block) {
    const auto start = std::ranges::find_if(block, [](char c) { return isText(c) && c != '>'; });
    block.remove_prefix(static_cast<std::size_t>(start - block.begin()));
    return block;
}

/// Lines without their CR and LF; empty ones are dropped, so that CR, LF and CR LF all end a line.
std::vector<std::string_view> linesOf(std::string_view block) {
    std::vector<std::string_view> lines;
    while (!block.empty()) {
        const auto end = std::min(block.find_first_of("\r\n"), block.size());
        if (end > 0) {
            lines.push_back(block.substr(0, end));
        }
        block.remove_prefix(std::min(end + 1, block.size()));
    }
    return lines;
}

Item assignment(std::string_view line, std::size_t equals) {
    const std::string_view key = line.substr(0, equals);
    Item item{.label = std::nullopt, .name = {}, .data = std::string(line.substr(equals + 1))};
    if (isNumber(key, 3)) {
        item.label = toInt(key);
    } else {
        item.name = key;
    }
    return item;
}

using Lines = std::vector<std::string_view>;

/// S and N: `label=data`, `name=data`. What is neither item nor status is noise.
void readAssignments(const Lines& lines, Reply& reply) {
    for (const auto line : lines) {
        if (const auto equals = line.find('='); equals != std::string_view::npos) {
            reply.items.push_back(assignment(line, equals));
        } else if (const auto status = parseStatus(line); status && !reply.status && reply.items.empty()) {
            reply.status = status;
        } else {
            reply.damaged = true;
        }
    }
}

void readDataOnly(Lines lines, bool one_label, Reply& reply) {
    const bool only_data = one_label && lines.size() == 1;
    if (!lines.empty() && !only_data && (reply.status = parseStatus(lines.front()))) {
        lines.erase(lines.begin());
    }
    for (const auto line : lines) {
        reply.items.push_back({.label = std::nullopt, .name = {}, .data = std::string(line)});
    }
}

/// V: pairs of lines. An odd number of lines has a status in front.
void readSeparate(Lines lines, Reply& reply) {
    if (lines.size() % 2 == 1 && (reply.status = parseStatus(lines.front()))) {
        lines.erase(lines.begin());
    }
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        if (isNumber(lines[i], 3)) {
            reply.items.push_back({.label = toInt(lines[i]), .name = {}, .data = std::string(lines[i + 1])});
        }
    }
    reply.damaged = reply.items.size() * 2 != lines.size();
}

bool isSameKey(const Item& a, const Item& b) {
    return a.label == b.label && a.name == b.name && (a.label || !a.name.empty());
}

bool hasKeyTwice(const std::vector<Item>& items) {
    for (auto item = items.begin(); item != items.end(); ++item) {
        if (std::any_of(std::next(item), items.end(),
                        [&](const Item& other) { return isSameKey(*item, other); })) {
            return true;
        }
    }
    return false;
}

bool isWholeText(const Lines& lines) {
    return std::ranges::all_of(lines,
                               [](std::string_view line) { return std::ranges::all_of(line, isText); });
}

}  // namespace

const Item* Reply::find(int label) const {
    const auto found = std::ranges::find(items, std::optional(label), &Item::label);
    return found == items.end() ? nullptr : &*found;
}

ReplyShape shapeOf(const Command& command) {
    if (const auto* read = std::get_if<ReadMeasurement>(&command)) {
        return {.form = read->form, .one_label = false, .file = false};
    }
    if (const auto* read = std::get_if<ReadLabel>(&command)) {
        return {.form = read->form, .one_label = true, .file = false};
    }
    if (std::holds_alternative<FreeMemory>(command)) {
        return {.form = ReadForm::kDataOnly, .one_label = true, .file = false};
    }
    if (std::holds_alternative<ListFiles>(command) || std::holds_alternative<OutputFile>(command)) {
        return {.form = ReadForm::kStandard, .one_label = false, .file = true};
    }
    return {};
}

Reply parseReply(std::string_view block, ReplyShape shape) {
    Reply reply;
    reply.raw = block;
    const Lines lines = linesOf(withoutStrayStart(block));
    switch (shape.form) {
        case ReadForm::kStandard:
        case ReadForm::kNames:
            readAssignments(lines, reply);
            break;
        case ReadForm::kDataOnly:
            readDataOnly(lines, shape.one_label, reply);
            break;
        case ReadForm::kSeparate:
            readSeparate(lines, reply);
            break;
    }
    reply.damaged = reply.damaged || !isWholeText(lines) || (!shape.file && hasKeyTwice(reply.items));
    return reply;
}

Reply parseReply(std::string_view block, bool separate) {
    if (separate) {
        return parseReply(block, ReplyShape{.form = ReadForm::kSeparate, .one_label = false, .file = false});
    }
    const bool has_assignment = block.find('=') != std::string_view::npos;
    return parseReply(block, ReplyShape{.form = has_assignment ? ReadForm::kStandard : ReadForm::kDataOnly,
                                        .one_label = false,
                                        .file = false});
}

std::optional<Status> parseStatus(std::string_view line) {
    const auto point = line.find('.');
    const std::string_view code = line.substr(0, point);
    if (!isNumber(code, 3)) {
        return std::nullopt;
    }
    if (point == std::string_view::npos) {
        return Status{.code = toInt(code), .suffix = std::nullopt};
    }
    const std::string_view suffix = line.substr(point + 1);
    if (!isNumber(suffix, 2)) {
        return std::nullopt;
    }
    return Status{.code = toInt(code), .suffix = toInt(suffix)};
}

core::Result<std::optional<char>> endMarkFromLabel(std::string_view data) {
    if (!isNumber(data, 3) || toInt(data) > 127) {
        return core::fail(core::ErrorKind::kProtocol,
                          QStringLiteral("The instrument gave no usable end mark (label 79)."),
                          QStringLiteral("Set label 79 to 62 on the control unit."),
                          QString::fromLatin1(data));
    }
    const int code = toInt(data);
    return code == 0 ? std::nullopt : std::optional(static_cast<char>(code));
}

std::string endMarkText(std::optional<char> end_mark) {
    return std::to_string(static_cast<int>(end_mark.value_or('\0')));
}

std::vector<std::string> BlockReader::feed(std::string_view bytes) {
    pending_ += bytes;
    std::vector<std::string> blocks;
    while (end_mark_) {
        const auto end = pending_.find(*end_mark_, searched_);
        if (end == std::string::npos) {
            break;
        }
        blocks.push_back(pending_.substr(0, end));
        pending_.erase(0, end + 1);
        searched_ = 0;
    }
    if (pending_.size() > kLongestBlock) {
        pending_.clear();
    }
    searched_ = pending_.size();
    return blocks;
}

std::optional<std::string> BlockReader::flush() {
    searched_ = 0;
    std::string rest = std::exchange(pending_, {});
    return rest.empty() ? std::nullopt : std::optional(std::move(rest));
}

void BlockReader::clear() {
    pending_.clear();
    searched_ = 0;
}

void BlockReader::setEndMark(std::optional<char> end_mark) {
    end_mark_ = end_mark;
    searched_ = 0;
}

}  // namespace pmts::protocol
