#include "pmts/protocol/seen_routine.hpp"

#include "text_lines.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cctype>
#include <regex>

namespace pmts::protocol {
namespace {

constexpr std::size_t kLongestCommand = 80;
constexpr std::size_t kLongestPattern = 60;  ///< whatever follows is its `*`
constexpr std::size_t kMostReplies = 8;  ///< of one step: more is a value in disguise

QString tr(const char* text) { return QCoreApplication::translate("SeenRoutine", text); }

/// One line of the dialogue without its end.
struct Said {
    std::string text;
    TalkSide side = TalkSide::kUnknown;
    bool sure = true;
    bool ends_block = false;
};

std::vector<Said> saidLines(std::span<const DecodedCharacter> characters) {
    std::vector<Said> lines;
    Said line;
    const auto close = [&](bool ends_block) {
        if (!line.text.empty() || ends_block) {
            line.ends_block = ends_block;
            lines.push_back(line);
        }
        line = {};
    };
    for (const DecodedCharacter& character : characters) {
        if (!line.text.empty() && line.side != character.side) {
            close(false);
        }
        line.side = character.side;
        line.sure = line.sure && character.isSure();
        const bool block_end = character.value == 0x04 || character.value == '>';
        if (block_end || character.value == '\r' || character.value == '\n') {
            close(block_end);
        } else {
            line.text += static_cast<char>(character.value);
        }
    }
    close(false);
    return lines;
}

/// `A,166=…`, of any length: a regex would recurse once for each character of the line.
bool isStream(std::string_view text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (text.size() < 4 || text[0] < 'A' || text[0] > 'Z' || text[1] != ',' || !is_digit(text[2])) {
        return false;
    }
    const auto behind = std::ranges::find_if_not(text.substr(2), is_digit);
    return behind != text.end() && *behind == '=';
}

/// A reply as a pattern: an info code as it is, a value by its label, of anything else what a table may hold.
std::string patternOf(const std::vector<std::string>& lines) {
    static const std::regex code(R"(\d{1,3}(\.\d{1,2})?)");
    if (lines.size() == 1 && std::regex_match(lines[0], code)) {
        return lines[0];
    }
    const std::size_t equals = lines[0].find('=');
    std::string begin = lines[0].substr(0, std::min(equals == std::string::npos ? equals : equals + 1, kLongestPattern));
    const auto foreign = std::ranges::find_if(begin, [](char c) { return c < '!' || c > '~' || c == '*'; });
    begin.erase(foreign, begin.end());
    return begin + '*';
}

/// A command and what came back until the next one.
struct Exchange {
    std::string command;
    std::vector<std::string> replies;
    bool sure = true;
};

std::vector<Exchange> exchangesOf(std::span<const DecodedCharacter> characters) {
    std::vector<Exchange> exchanges;
    std::vector<std::string> block;
    const auto close = [&] {
        if (!block.empty() && !exchanges.empty()) {
            exchanges.back().replies.push_back(patternOf(block));
        }
        block.clear();
    };
    for (const Said& line : saidLines(characters)) {
        const bool is_command =
            line.side == TalkSide::kUnknown ? isSeenCommand(line.text) : line.side == TalkSide::kToInstrument;
        if (is_command && !line.text.empty()) {
            close();
            exchanges.push_back({.command = line.text, .replies = {}, .sure = line.sure});
            continue;
        }
        if (!line.text.empty() && !isStream(line.text) && !exchanges.empty()) {
            exchanges.back().sure = exchanges.back().sure && line.sure;
            block.push_back(line.text);
        }
        if (line.ends_block) {
            close();
        }
    }
    close();
    return exchanges;
}

void addReplies(TableStep& step, const std::vector<std::string>& replies) {
    for (const std::string& reply : replies) {
        if (std::ranges::find(step.expect, reply) == step.expect.end() && step.expect.size() < kMostReplies) {
            step.expect.push_back(reply);
        }
    }
    step.optional = step.optional || replies.empty();
}

/// What the reader of tables has against one step; empty: nothing.
QString complaintAbout(const TableStep& step) {
    const TableRoutine alone{.name = "seen", .note = {}, .steps = {step}};
    const InstructionTable table = readInstructionTable(instructionTableText({&alone, 1}, {}));
    return table.problems.empty() ? QString() : table.problems.front().sentence;
}

}  // namespace

bool isSeenCommand(std::string_view line) {
    static const std::regex grammar(R"([RWPTOLKM][GRSVAMIUD*][A-Z0-9<>]*(,\d{1,3})?(=[!-~]{1,16})?)");
    return line.size() <= kLongestCommand && std::regex_match(line.begin(), line.end(), grammar);
}

SeenRoutine seenRoutine(std::span<const DecodedCharacter> characters, const std::string& name, const std::string& note) {
    SeenRoutine seen{.routine = {.name = name, .note = note, .steps = {}}, .left_out = {}};
    const auto leave_out = [&seen](const QString& sentence) {
        if (!seen.left_out.contains(sentence)) {
            seen.left_out << sentence;
        }
    };
    for (const Exchange& exchange : exchangesOf(characters)) {
        if (!exchange.sure) {
            leave_out(tr("“%1” or its reply has characters that are not sure.").arg(clipped(exchange.command)));
            continue;
        }
        TableStep step{.text = exchange.command, .expect = {}, .fail = {}};
        addReplies(step, exchange.replies);
        auto& steps = seen.routine.steps;
        if (!steps.empty() && steps.back().text == step.text) {
            addReplies(steps.back(), exchange.replies);
        } else if (const QString complaint = complaintAbout(step); !complaint.isEmpty()) {
            leave_out(complaint);
        } else {
            steps.push_back(step);
        }
    }
    return seen;
}

}  // namespace pmts::protocol
