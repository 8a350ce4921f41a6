// The way back from routines to the text of an instruction table.
#include "pmts/protocol/seen_routine.hpp"

#include <array>
#include <charconv>

namespace pmts::protocol {
namespace {

/// One line: a line break in a remark would end the comment.
std::string oneLine(std::string text) {
    for (char& c : text) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    return text;
}

std::string secondsText(core::Duration time) {
    std::array<char, 32> buffer{};
    const double seconds = std::chrono::duration<double>(time).count();
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), seconds);
    return error == std::errc() ? std::string(buffer.data(), end) : "5";
}

void addReplies(std::string& text, const char* word, const std::vector<std::string>& replies) {
    if (replies.empty()) {
        return;
    }
    text += std::string("    ") + word;
    for (const std::string& reply : replies) {
        text += ' ' + reply;
    }
    text += '\n';
}

void addStep(std::string& text, const TableStep& step) {
    text += "send " + step.text + '\n';
    addReplies(text, "expect", step.expect);
    addReplies(text, "fail", step.fail);
    if (step.within != TableStep().within) {
        text += "    within " + secondsText(step.within) + '\n';
    }
    text += step.optional ? "    optional\n" : "";
    text += step.time_critical ? "    time_critical\n" : "";
    text += step.always ? "    always\n" : "";
    if (step.pause > core::Duration::zero()) {
        text += "    pause " + secondsText(step.pause) + '\n';
    }
}

}  // namespace

std::string instructionTableText(std::span<const TableRoutine> routines, const std::vector<std::string>& remarks) {
    std::string text = "# PMTS instruction table 1\n";
    for (const std::string& remark : remarks) {
        text += "# " + oneLine(remark) + '\n';
    }
    for (const TableRoutine& routine : routines) {
        text += "\nroutine " + routine.name + '\n';
        text += routine.note.empty() ? "" : "note " + oneLine(routine.note) + '\n';
        for (const TableStep& step : routine.steps) {
            addStep(text, step);
        }
    }
    return text;
}

}  // namespace pmts::protocol
