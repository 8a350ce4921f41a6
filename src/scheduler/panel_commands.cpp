#include "panel_commands.hpp"

#include "pmts/protocol/reply.hpp"

#include <algorithm>

namespace pmts::scheduler {
namespace {

/// Longer than any command of the language, which has 80 characters or so.
constexpr std::size_t kLongestCommand = 1024;

std::string_view bare(std::string_view command) {
    const auto is_text = [](char c) { return c > ' ' && c < '\x7F'; };
    const auto first = std::ranges::find_if(command, is_text);
    command.remove_prefix(static_cast<std::size_t>(first - command.begin()));
    return command.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(command, is_text) - command.begin()));
}

/// `5` of `RG,5`; empty where not one label is asked for in the standard form.
std::string_view labelAskedFor(std::string_view text) {
    if (text.size() < 4 || text[0] != 'R' || text[2] != ',') {
        return {};
    }
    text.remove_prefix(3);
    return text.substr(0, text.find_first_not_of("0123456789"));
}

bool hasLabels(const protocol::Reply& reply) {
    return std::ranges::any_of(reply.items, [](const auto& item) { return item.label.has_value(); });
}

}  // namespace

PanelCommands::Taken PanelCommands::feed(std::string_view bytes) {
    Taken taken;
    for (const char byte : bytes) {
        if (after_end_ && half_.empty() && (byte == '\n' || isEnd(byte))) {
            (taken.commands.empty() ? taken.tail : taken.commands.back()) += byte;
            continue;
        }
        half_ += byte;
        after_end_ = isEnd(byte);
        if (after_end_) {
            taken.commands.push_back(half_);
            half_.clear();
        } else if (half_.size() > kLongestCommand) {
            taken.junk += half_;
            half_.clear();
        }
    }
    return taken;
}

std::string PanelCommands::takeHalf() {
    after_end_ = false;
    return std::exchange(half_, {});
}

bool takesLong(std::string_view command) {
    const auto text = bare(command);
    return text.starts_with("WS") || text.find_first_of("TPOLK") == 0;
}

bool isQuestion(std::string_view command) { return bare(command).find_first_of("RMO") == 0; }

bool canAnswer(std::string_view command, std::string_view block) {
    const auto text = bare(command);
    const auto reply = protocol::parseReply(block);
    const bool is_empty = !reply.status && reply.items.empty();
    if (isQuestion(command) && is_empty) {
        return false;
    }
    if (const auto label = labelAskedFor(text); !label.empty() && hasLabels(reply)) {
        return std::ranges::any_of(reply.items, [&](const auto& item) {
            return item.label && std::to_string(*item.label) == label;
        });
    }
    const bool wants_no_data = text.find_first_of("WTP") == 0 || text.starts_with("RGT");
    return !wants_no_data || !hasLabels(reply);
}

}  // namespace pmts::scheduler
