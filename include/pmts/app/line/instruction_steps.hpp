#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/instrument/instruction_runner.hpp"

#include <QString>

#include <vector>

namespace pmts::app {

/// One line of the list of steps: what is sent, what came, and how it is judged.
struct StepRow {
    int line = 0;  ///< of the table
    DeviceState state = DeviceState::kIdle;
    QString sent;      ///< `WV,102=0`
    QString received;  ///< control characters as words: `0.8<CR>`; a dash where none came and none had to
    QString verdict;
    QString at;    ///< seconds since the routine began
    QString took;  ///< from sending to its end
};

/// The steps of a routine before it runs, as it runs and when it has ended.
class InstructionSteps {
public:
    /// Numbers that are missing leave their placeholder.
    void begin(const protocol::TableRoutine& routine, const std::map<std::string, double>& numbers);
    void setRunning(std::size_t index);
    void take(const instrument::StepOutcome& step);
    [[nodiscard]] const std::vector<StepRow>& rows() const { return rows_; }
    [[nodiscard]] int ended() const { return ended_; }
    void clear() { *this = {}; }

private:
    std::vector<StepRow> rows_;
    std::optional<core::Duration> began_at_;
    int ended_ = 0;
};

}  // namespace pmts::app
