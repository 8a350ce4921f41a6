#include "unasked_bytes.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

constexpr core::Duration kQuiet = std::chrono::milliseconds(500);

bool isBlockEnd(char value) { return value == '>' || value == protocol::kBusBlockEnd; }

}  // namespace

void UnaskedBytes::clear() {
    waiting_.clear();
    open_.reset();
    is_first_ = true;
}

void UnaskedBytes::addReceived(std::string_view bytes, core::Duration at) {
    for (const char value : bytes) {
        waiting_.push_back({.at = at, .value = value});
    }
}

std::vector<UnaskedBytes::Byte> UnaskedBytes::taken(core::Duration until) {
    const auto end = std::find_if(waiting_.begin(), waiting_.end(), [until](const Byte& byte) { return byte.at > until; });
    std::vector<Byte> bytes(waiting_.begin(), end);
    waiting_.erase(waiting_.begin(), end);
    return bytes;
}

/// In one piece where it is so, else byte after byte: noise may stand between.
std::vector<UnaskedBytes::Byte> UnaskedBytes::without(const std::vector<Byte>& bytes, std::string_view claimed) {
    std::vector<Byte> left;
    const auto same = [](const Byte& byte, char value) { return byte.value == value; };
    const auto whole = std::search(bytes.begin(), bytes.end(), claimed.begin(), claimed.end(), same);
    if (whole != bytes.end()) {
        left.assign(bytes.begin(), whole);
        left.insert(left.end(), whole + static_cast<std::ptrdiff_t>(claimed.size()), bytes.end());
        return left;
    }
    for (const Byte& byte : bytes) {
        if (!claimed.empty() && byte.value == claimed.front()) {
            claimed.remove_prefix(1);
        } else {
            left.push_back(byte);
        }
    }
    return left;
}

std::vector<UnaskedPiece> UnaskedBytes::piecesOf(const std::vector<Byte>& bytes, core::Duration now) {
    std::vector<UnaskedPiece> pieces;
    for (const Byte& byte : bytes) {
        closeWhenQuiet(byte.at, pieces);
        open_ = open_.value_or(UnaskedPiece{.at = byte.at, .bytes = {}});
        last_at_ = byte.at;
        if (isBlockEnd(byte.value)) {
            pieces.push_back(*std::exchange(open_, std::nullopt));
        } else {
            open_->bytes += byte.value;
        }
    }
    closeWhenQuiet(now, pieces);
    return pieces;
}

/// Nothing more comes of a block that stopped half a second ago. Line ends alone are nothing.
void UnaskedBytes::closeWhenQuiet(core::Duration now, std::vector<UnaskedPiece>& pieces) {
    if (open_ && now - last_at_ >= kQuiet) {
        const auto ended = *std::exchange(open_, std::nullopt);
        if (ended.bytes.find_first_not_of("\r\n") != std::string::npos) {
            pieces.push_back(ended);
        }
    }
}

std::vector<UnaskedPiece> UnaskedBytes::take(const scheduler::TransactionRecord& record) {
    std::vector<Byte> before = taken(record.sent_at - core::Duration(1));
    const std::vector<Byte> during = taken(record.finished_at);
    if (std::exchange(is_first_, false)) {
        return {};  // it may be the rest of an answer that began before
    }
    std::vector<Byte> left = without(during, record.received);
    if (record.outcome == scheduler::Outcome::kAnswered && (record.received.empty() || !isBlockEnd(record.received.back()))) {
        const auto end = std::find_if(left.begin(), left.end(), [](const Byte& byte) { return isBlockEnd(byte.value); });
        left.erase(end, end == left.end() ? end : std::next(end));  // of the answer: the record goes without
    }
    before.insert(before.end(), left.begin(), left.end());
    return piecesOf(before, record.finished_at);
}

std::vector<UnaskedPiece> UnaskedBytes::takeOlderThan(core::Duration moment) {
    return piecesOf(taken(moment), moment);
}

}  // namespace pmts::app
