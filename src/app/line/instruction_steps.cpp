#include "pmts/app/line/instruction_steps.hpp"

#include "pmts/app/line/line_words.hpp"

#include <QCoreApplication>

namespace pmts::app {
namespace {

using instrument::StepVerdict;

QString tr(const char* text) { return QCoreApplication::translate("InstructionSteps", text); }

QString verdictText(const instrument::StepOutcome& step) {
    QString text;
    switch (step.verdict) {
        case StepVerdict::kExpected: text = tr("as expected"); break;
        case StepVerdict::kMissing: text = tr("no reply, may be missing"); break;
        case StepVerdict::kFailed: text = tr("a failure"); break;
        case StepVerdict::kUnknown: text = tr("not in the table"); break;
        case StepVerdict::kTimedOut: text = tr("no reply in time"); break;
        case StepVerdict::kBrokenOff: text = tr("broken off"); break;
    }
    return step.video_paused ? tr("%1, video paused").arg(text) : text;
}

DeviceState stateOf(StepVerdict verdict) {
    switch (verdict) {
        case StepVerdict::kExpected: return DeviceState::kGood;
        case StepVerdict::kMissing: return DeviceState::kGood;
        case StepVerdict::kBrokenOff: return DeviceState::kWarning;
        case StepVerdict::kFailed:
        case StepVerdict::kUnknown:
        case StepVerdict::kTimedOut: return DeviceState::kFailed;
    }
    return DeviceState::kIdle;
}

QString secondsText(core::Duration span) {
    return QStringLiteral("%1 s").arg(std::chrono::duration<double>(span).count(), 0, 'f', 3);
}

}  // namespace

void InstructionSteps::begin(const protocol::TableRoutine& routine, const std::map<std::string, double>& numbers) {
    clear();
    for (const auto& step : routine.steps) {
        auto bytes = protocol::bytesOf(step, numbers);
        const std::string sent = bytes ? bytes->substr(0, bytes->size() - 1) : step.text;
        rows_.push_back({.line = step.line, .sent = bytesText(sent), .received = {}, .verdict = {}, .at = {}, .took = {}});
    }
}

void InstructionSteps::setRunning(std::size_t index) {
    if (index < rows_.size()) {
        rows_[index].state = DeviceState::kBusy;
    }
}

void InstructionSteps::take(const instrument::StepOutcome& step) {
    if (step.index >= rows_.size()) {
        return;
    }
    began_at_ = began_at_.value_or(step.sent_at);
    auto& row = rows_[step.index];
    row.state = stateOf(step.verdict);
    row.received = step.received.empty() ? QStringLiteral("–") : bytesText(step.received);
    row.verdict = verdictText(step);
    row.at = secondsText(step.sent_at - *began_at_);
    row.took = secondsText(step.finished_at - step.sent_at);
    ++ended_;
}

}  // namespace pmts::app
