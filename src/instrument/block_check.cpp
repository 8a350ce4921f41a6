#include "block_check.hpp"

#include "pmts/protocol/info_code.hpp"

#include <algorithm>
#include <charconv>

namespace pmts::instrument {
namespace {

constexpr std::size_t kLongestDamagedAcknowledgement = 2;

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLineEnd(char c) { return c == '\r' || c == '\n'; }
bool isPrintable(char c) { return c >= 0x20 && c <= 0x7E; }

/// Lines of a block; nullopt when the last one has no end.
std::optional<std::vector<std::string_view>> completeLines(std::string_view text) {
    const auto start = text.find_first_not_of(">\r\n");
    text.remove_prefix(std::min(start, text.size()));
    if (!text.empty() && !isLineEnd(text.back())) {
        return std::nullopt;
    }
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const auto end = text.find_first_of("\r\n");
        if (end > 0) {
            lines.push_back(text.substr(0, end));
        }
        text.remove_prefix(end + 1);
    }
    return lines;
}

std::optional<protocol::Item> itemOf(std::string_view line) {
    const auto equals = line.find('=');
    const auto key = line.substr(0, std::min(equals, line.size()));
    const bool is_label = equals != std::string_view::npos && !key.empty() && key.size() <= 3 &&
                          std::ranges::all_of(key, isDigit) && (key.size() == 1 || key.front() != '0');
    if (!is_label || !std::ranges::all_of(line, isPrintable)) {
        return std::nullopt;
    }
    int label = 0;
    std::from_chars(key.data(), key.data() + key.size(), label);
    return protocol::Item{.label = label, .name = {}, .data = std::string(line.substr(equals + 1))};
}

bool hasDoubleLabels(const std::vector<protocol::Item>& items) {
    for (auto item = items.begin(); item != items.end(); ++item) {
        if (std::any_of(item + 1, items.end(),
                        [&](const auto& other) { return other.label == item->label; })) {
            return true;
        }
    }
    return false;
}

/// A label is read without a status line; a warning may stand before it.
bool isBareOrWarned(const CheckedBlock& block) {
    return !block.status || protocol::isWarning(block.status->code);
}

}  // namespace

const std::string* CheckedBlock::find(int label) const {
    const auto found = std::ranges::find(items, std::optional(label), &protocol::Item::label);
    return found == items.end() ? nullptr : &found->data;
}

CheckedBlock checkBlock(const protocol::Reply& reply) {
    const auto lines = completeLines(reply.raw);
    if (!lines) {
        return {};
    }
    CheckedBlock block;
    for (std::size_t i = 0; i < lines->size(); ++i) {
        if (auto item = itemOf((*lines)[i])) {
            block.items.push_back(*std::move(item));
        } else if (i == 0 && (block.status = protocol::parseStatus(lines->front()))) {
            continue;
        } else {
            return {};
        }
    }
    if (hasDoubleLabels(block.items)) {
        return {};
    }
    block.kind = lines->empty()        ? BlockKind::kEmpty
                 : block.items.empty() ? BlockKind::kStatus
                                       : BlockKind::kItems;
    return block;
}

std::optional<int> decimalsOf(std::string_view number) {
    if (number.starts_with('-') || number.starts_with('+')) {
        number.remove_prefix(1);
    }
    const auto point = std::min(number.find('.'), number.size());
    const auto whole = number.substr(0, point);
    const bool whole_ok =
        !whole.empty() && std::ranges::all_of(whole, isDigit) && (whole.size() == 1 || whole.front() != '0');
    if (!whole_ok) {
        return std::nullopt;
    }
    if (point == number.size()) {
        return 0;
    }
    const auto fraction = number.substr(point + 1);
    const bool fraction_ok = !fraction.empty() && std::ranges::all_of(fraction, isDigit);
    return fraction_ok ? std::optional(static_cast<int>(fraction.size())) : std::nullopt;
}

bool canAnswerLabel(const protocol::Reply& reply, int label) {
    const auto block = checkBlock(reply);
    switch (block.kind) {
        case BlockKind::kEmpty:
            return false;
        case BlockKind::kItems:
            return isBareOrWarned(block) && block.items.size() == 1 && block.items.front().label == label;
        case BlockKind::kStatus:
        case BlockKind::kMalformed:
            break;
    }
    return true;
}

bool canAnswerMeasurement(const protocol::Reply& reply) {
    const auto block = checkBlock(reply);
    return block.kind != BlockKind::kEmpty &&
           (block.kind != BlockKind::kItems || block.status.has_value() || block.items.size() > 1);
}

bool canAnswerCommand(const protocol::Reply& reply) {
    const auto kind = checkBlock(reply).kind;
    const bool damaged = kind == BlockKind::kMalformed && reply.raw.size() <= kLongestDamagedAcknowledgement;
    return kind == BlockKind::kEmpty || kind == BlockKind::kStatus || damaged;
}

bool canAnswerWrite(const protocol::Reply& reply) {
    const auto status = checkBlock(reply).status;
    const auto info_class = status ? protocol::infoCode(status->code).info_class : protocol::InfoClass::kOk;
    const bool about_a_measurement =
        info_class == protocol::InfoClass::kRemeasure || info_class == protocol::InfoClass::kData;
    return canAnswerCommand(reply) && !about_a_measurement;
}

bool isExactlyLabel(const protocol::Reply& reply, int label) {
    const auto block = checkBlock(reply);
    return block.kind == BlockKind::kStatus ||
           (block.kind == BlockKind::kItems && isBareOrWarned(block) && block.items.size() == 1 &&
            block.items.front().label == label);
}

}  // namespace pmts::instrument
