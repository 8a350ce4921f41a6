#include "unasked_bytes.hpp"

#include <algorithm>

namespace pmts::app {

namespace {

constexpr char kBlockEnd = '>';

}  // namespace

void UnaskedBytes::clear() {
    waiting_.clear();
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

std::vector<UnaskedPiece> UnaskedBytes::piecesOf(const std::vector<Byte>& bytes) {
    std::vector<UnaskedPiece> pieces;
    bool is_open = false;
    for (const Byte& byte : bytes) {
        if (!is_open) {
            pieces.push_back({.at = byte.at, .bytes = {}});
        }
        pieces.back().bytes += byte.value;
        is_open = byte.value != kBlockEnd && byte.value != protocol::kBusBlockEnd;
    }
    return pieces;
}

std::vector<UnaskedPiece> UnaskedBytes::take(const scheduler::TransactionRecord& record) {
    std::vector<Byte> before = taken(record.sent_at - core::Duration(1));
    const std::vector<Byte> during = taken(record.finished_at);
    if (std::exchange(is_first_, false)) {
        return {};  // it may be the rest of an answer that began before
    }
    const std::vector<Byte> left = without(during, record.received);
    before.insert(before.end(), left.begin(), left.end());
    return piecesOf(before);
}

std::vector<UnaskedPiece> UnaskedBytes::takeOlderThan(core::Duration moment) { return piecesOf(taken(moment)); }

}  // namespace pmts::app
