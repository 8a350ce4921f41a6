#include "label_survey.hpp"

#include "pmts/protocol/labels.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

/// A value that two of so many readings do not agree on changes by itself: a circle, the clock.
constexpr int kMostReadings = 4;

core::Task<core::Result<protocol::LabelReading>> readOnce(StatePtr state, int label, std::stop_token stop) {
    Question question = labelQuestion(*state, label);
    question.ours = false;
    question.may_be_silent = true;
    auto asking = ask(state, question, stop);
    const auto block = co_await asking;
    protocol::LabelReading reading{.label = label, .data = {}, .refused = {}};
    if (block && block->find(label) != nullptr) {
        reading.data = *block->find(label);
    } else if (block) {
        reading.refused = block->status.value_or(protocol::Status{});
    } else if (block.error().info_code && !isClass(block.error(), protocol::InfoClass::kComm)) {
        reading.refused = protocol::Status{.code = *block.error().info_code, .suffix = {}};
    } else {
        // No answer to this one, where the line answers otherwise: one label is no reason to lose all the others.
        auto settling = settleLine(state, stop);
        const bool settled = co_await settling;
        if (!settled || !isLineTrouble(block.error())) {
            co_return tl::unexpected(stop.stop_requested() ? core::cancelled().value() : block.error());
        }
    }
    co_return reading;
}

core::Task<core::Result<protocol::LabelReading>> readAgreed(StatePtr state, int label, std::stop_token stop) {
    std::vector<protocol::LabelReading> seen;
    for (int i = 0; i < kMostReadings; ++i) {
        auto reading_once = readOnce(state, label, stop);
        auto reading = co_await reading_once;
        const bool alike = reading && std::ranges::find(seen, *reading) != seen.end();
        if (!reading || alike || (reading->isSilent() && seen.empty())) {
            co_return reading;
        }
        if (!reading->isSilent()) {
            seen.push_back(*reading);
        }
    }
    seen.back().steady = false;
    co_return seen.back();
}

std::string dataOf(const protocol::LabelBackup& backup, int label) {
    const auto found = std::ranges::find(backup.readings, label, &protocol::LabelReading::label);
    return found == backup.readings.end() ? std::string() : found->data.value_or(std::string());
}

}  // namespace

core::Task<core::Result<protocol::LabelBackup>> backUpLabels(StatePtr state, OnTransfer progress, std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    const auto& labels = protocol::backupLabels();
    protocol::LabelBackup backup{.utc = state->clock.utcNow(), .serial_number = {}, .temperature = {}, .readings = {}};
    for (const int label : labels) {
        auto reading_label = readAgreed(state, label, routine.token());
        auto reading = co_await reading_label;
        if (!reading) {
            co_return tl::unexpected(reading.error());
        }
        backup.readings.push_back(*std::move(reading));
        if (progress) {
            progress({.step = TransferStep::kLabels,
                      .done = static_cast<int>(backup.readings.size()),
                      .of = static_cast<int>(labels.size())});
        }
    }
    backup.serial_number = dataOf(backup, protocol::kSerialNumber);
    backup.temperature = dataOf(backup, protocol::kTemperature);
    co_return backup;
}

}  // namespace pmts::instrument
