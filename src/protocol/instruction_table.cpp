#include "pmts/protocol/instruction_table.hpp"

#include "pmts/protocol/command.hpp"
#include "pmts/protocol/seen_routine.hpp"
#include "text_lines.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <regex>

namespace pmts::protocol {
namespace {

// Asked before every std::regex: the library's recurses once for each character. 240 digits are still a double.
constexpr std::size_t kLongestText = 240;  ///< of a command with its placeholders
constexpr std::size_t kLongestName = 64;
constexpr std::size_t kLongestReply = 80;
constexpr double kLongestWait_s = 3600.0;
constexpr std::size_t kMostDigits = 9;  ///< of a number on the wire (protocol page 1.2)

const std::regex& replyGrammar() {
    static const std::regex grammar(R"([!-)+-~]+\*?|\*)");
    return grammar;
}
/// `{mode 0..4}`, `{angle}`.
const std::regex& placeholderGrammar() {
    static const std::regex grammar(R"(\{([a-z][a-z0-9_]*)(?: +(-?\d+(?:\.\d+)?)\.\.(-?\d+(?:\.\d+)?))?\})");
    return grammar;
}
const std::regex& nameGrammar() {
    static const std::regex grammar(R"([A-Za-z][A-Za-z0-9_]*)");
    return grammar;
}

QString tr(const char* text) { return QCoreApplication::translate("InstructionTable", text); }
QString shown(std::string_view text) { return clipped(text); }

/// None of a text that is too long to be a command.
std::vector<TableParameter> parametersIn(const std::string& text) {
    std::vector<TableParameter> found;
    if (text.size() > kLongestText) {
        return found;
    }
    for (std::sregex_iterator at(text.begin(), text.end(), placeholderGrammar()), end; at != end; ++at) {
        TableParameter parameter{.name = (*at)[1], .least = std::nullopt, .most = std::nullopt};
        if ((*at)[2].matched) {
            parameter.least = std::stod((*at)[2]);
            parameter.most = std::stod((*at)[3]);
        }
        found.push_back(parameter);
    }
    return found;
}

/// As the instrument reads numbers: no exponent, no needless zeros; nullopt: too long for the wire.
std::optional<std::string> numberText(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 5);
    if (error != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    std::string text(buffer.data(), end);
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
    const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
    return static_cast<std::size_t>(digits) <= kMostDigits ? std::optional(text) : std::nullopt;
}

std::string filled(std::string text, const std::map<std::string, std::string>& numbers) {
    std::smatch match;
    while (std::regex_search(text, match, placeholderGrammar())) {
        text = match.prefix().str() + numbers.at(match[1]) + match.suffix().str();
    }
    return text;
}

/// The command with the least numbers it may hold, for the checks.
std::string sample(const std::string& text) {
    std::map<std::string, std::string> numbers;
    for (const auto& parameter : parametersIn(text)) {
        numbers[parameter.name] = numberText(parameter.least.value_or(0)).value_or("0");
    }
    return filled(text, numbers);
}

/// The two letters of a command (protocol page 1.2): what it does and which unit it is for.
std::optional<QString> wrongLetter(std::string_view command) {
    constexpr std::string_view kVerbs = "RWPTOLKM", kUnits = "GRSVAMIUD*";
    if (command.empty() || kVerbs.find(command[0]) == std::string_view::npos) {
        return tr("\"%1\" begins no command: R reads, W writes, P runs a process (T, O, L, M as in the maker's manual).")
            .arg(shown(command.substr(0, 1)));
    }
    if (command.size() < 2 || kUnits.find(command[1]) == std::string_view::npos) {
        return tr("\"%1\" is no unit letter: V main board, A angle unit, G station, S servo, R control unit "
                  "(M, I, U, D, * for files).")
            .arg(shown(command.substr(1, 1)));
    }
    return std::nullopt;
}

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> found;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const auto end = std::min(text.find_first_of(" \t"), text.size());
        found.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return found;
}

bool matches(std::string_view pattern, std::string_view reply) {
    return pattern.ends_with('*') ? reply.starts_with(pattern.substr(0, pattern.size() - 1)) : reply == pattern;
}

class Reader {
public:
    InstructionTable read(std::string_view text) {
        (void)eachLine(text, [this](std::size_t number, std::string_view line) -> core::Result<void> {
            line_ = static_cast<int>(number);
            if (!line.empty() && !line.starts_with('#')) {
                takeLine(line);
            }
            return {};
        });
        for (const auto& routine : table_.routines) {
            checkRoutine(routine);
        }
        std::ranges::stable_sort(table_.problems, {}, &TableProblem::line);
        return std::move(table_);
    }

private:
    void complain(int line, const QString& sentence) { table_.problems.push_back({.line = line, .sentence = sentence}); }

    void takeLine(std::string_view line) {
        const auto end = std::min(line.find_first_of(" \t"), line.size());
        const auto word = line.substr(0, end);
        const auto rest = trimmed(line.substr(end));
        if (word == "routine") {
            beginRoutine(std::string(rest));
        } else if (table_.routines.empty()) {
            complain(line_, tr("\"%1\" stands before the first routine.").arg(shown(word)));
        } else if (word == "note") {
            table_.routines.back().note = rest;
        } else if (word == "send") {
            table_.routines.back().steps.push_back({.line = line_, .text = std::string(rest), .expect = {}, .fail = {}});
        } else if (table_.routines.back().steps.empty()) {
            complain(line_, tr("\"%1\" stands before the first command of its routine.").arg(shown(word)));
        } else {
            takeStepLine(table_.routines.back().steps.back(), word, rest);
        }
    }

    void beginRoutine(const std::string& name) {
        if (name.size() > kLongestName || !std::regex_match(name, nameGrammar())) {
            complain(line_, tr("\"%1\" is no name of a routine: letters, digits and _.").arg(shown(name)));
        } else if (table_.find(name) != nullptr) {
            complain(line_, tr("There is a routine %1 already, in line %2.").arg(shown(name)).arg(table_.find(name)->line));
        }
        table_.routines.push_back({.line = line_, .name = name, .note = {}, .steps = {}});
    }

    void takeStepLine(TableStep& step, std::string_view word, std::string_view rest) {
        if (word == "expect" || word == "fail") {
            takeReplies(word == "expect" ? step.expect : step.fail, rest);
        } else if (word == "within" || word == "pause") {
            takeTime(word == "within" ? step.within : step.pause, rest);
        } else if ((word == "optional" || word == "time_critical" || word == "always") && rest.empty()) {
            (word == "optional" ? step.optional : word == "always" ? step.always : step.time_critical) = true;
        } else {
            complain(line_, tr("\"%1\" is not understood.").arg(rest.empty() ? shown(word) : shown(word) + u' ' + shown(rest)));
        }
    }

    void takeReplies(std::vector<std::string>& replies, std::string_view rest) {
        const auto all = words(rest);
        if (all.empty()) {
            complain(line_, tr("A reply is missing, such as 240.8."));
        }
        for (const auto& reply : all) {
            if (reply.size() > kLongestReply) {
                complain(line_, tr("The reply \"%1\" is longer than %2 characters.").arg(shown(reply)).arg(kLongestReply));
            } else if (!std::regex_match(reply, replyGrammar())) {
                complain(line_, tr("\"%1\" is no reply: a * may stand at its end only.").arg(shown(reply)));
            }
            replies.push_back(reply);
        }
    }

    void takeTime(core::Duration& time, std::string_view rest) {
        double seconds = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), seconds);
        if (error != std::errc() || end != rest.data() + rest.size() || !(seconds > 0 && seconds <= kLongestWait_s)) {
            complain(line_, tr("\"%1\" is no time in seconds, from 0 to %2.").arg(shown(rest)).arg(kLongestWait_s));
            return;
        }
        time = std::chrono::round<core::Duration>(std::chrono::duration<double>(seconds));
    }

    void checkRoutine(const TableRoutine& routine) {
        if (routine.steps.empty()) {
            complain(routine.line, tr("The routine %1 sends nothing.").arg(shown(routine.name)));
        }
        for (const auto& step : routine.steps) {
            checkStep(step);
        }
    }

    void checkCommand(const TableStep& step) {
        if (step.text.size() > kLongestText) {
            complain(step.line, tr("The command is longer than %1 characters.").arg(kLongestText));
            return;
        }
        for (const auto& parameter : parametersIn(step.text)) {
            if (parameter.least > parameter.most) {
                complain(step.line, tr("The range of {%1} is empty.").arg(shown(parameter.name)));
            }
        }
        const auto command = sample(step.text);
        if (const auto sentence = wrongLetter(command)) {
            complain(step.line, *sentence);
        } else if (!isSeenCommand(command)) {
            complain(step.line, tr("\"%1\" is no command: capitals, no blanks, such as WV,102=0.").arg(shown(step.text)));
        } else if (const auto allowed = checkDenyList(command); !allowed) {
            complain(step.line, allowed.error().happened);
        }
    }

    void checkStep(const TableStep& step) {
        checkCommand(step);
        if (step.expect.empty() && !step.optional) {
            complain(step.line, tr("It is not said which reply is expected; \"optional\" where there may be none."));
        }
        for (const auto& reply : step.fail) {
            if (std::ranges::find(step.expect, reply) != step.expect.end()) {
                complain(step.line, tr("The reply %1 is expected and a failure at once.").arg(shown(reply)));
            }
        }
    }

    InstructionTable table_;
    int line_ = 0;
};

}  // namespace

std::vector<TableParameter> TableRoutine::parameters() const {
    std::vector<TableParameter> all;
    for (const auto& step : steps) {
        for (const auto& parameter : parametersIn(step.text)) {
            if (std::ranges::find(all, parameter.name, &TableParameter::name) == all.end()) {
                all.push_back(parameter);
            }
        }
    }
    return all;
}

const TableRoutine* InstructionTable::find(std::string_view name) const {
    const auto found = std::ranges::find(routines, name, &TableRoutine::name);
    return found == routines.end() ? nullptr : &*found;
}

InstructionTable readInstructionTable(std::string_view text) { return Reader().read(text); }

core::Result<std::string> bytesOf(const TableStep& step, const std::map<std::string, double>& numbers) {
    const QString says = tr("Line %1 of the instruction table says: %2").arg(step.line).arg(shown(step.text));
    std::map<std::string, std::string> texts;
    for (const auto& parameter : parametersIn(step.text)) {
        const auto given = numbers.find(parameter.name);
        const auto text = given == numbers.end() ? std::nullopt : numberText(given->second);
        if (!text || given->second < parameter.least.value_or(given->second) ||
            given->second > parameter.most.value_or(given->second)) {
            return core::fail(core::ErrorKind::kBadInput,
                              tr("The number \"%1\" is missing or out of its range.").arg(shown(parameter.name)), says);
        }
        texts[parameter.name] = *text;
    }
    const std::string command = step.text.size() > kLongestText ? step.text : filled(step.text, texts);
    if (!isSeenCommand(command)) {
        return core::fail(core::ErrorKind::kBadInput, tr("\"%1\" is no command.").arg(shown(command)), says);
    }
    PMTS_TRY(checkDenyList(command));  // what a number made of it is known only here
    return command + '\r';
}

TableVerdict judge(const TableStep& step, std::string_view block) {
    const auto is_end = [](char c) { return c == '\r' || c == '\n'; };
    while (!block.empty() && is_end(block.front())) {
        block.remove_prefix(1);
    }
    while (!block.empty() && is_end(block.back())) {
        block.remove_suffix(1);
    }
    const auto fits = [block](const std::string& pattern) { return matches(pattern, block); };
    if (std::ranges::any_of(step.fail, fits)) {
        return TableVerdict::kFailed;
    }
    return std::ranges::any_of(step.expect, fits) ? TableVerdict::kExpected : TableVerdict::kUnknown;
}

}  // namespace pmts::protocol
