#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

enum class PollKind {
    kDistance,   ///< status 0 with a distance
    kMeasuring,  ///< status 0 without one
    kOld,        ///< 3: recorded before
    kInvalid,    ///< 4, 7, 28: nothing to record (yet)
    kRemeasure,  ///< 171-175: the distance meter gave up
    kDamaged,    ///< an answer that was lost or damaged: it may have been the one with the distance
    kFailed,     ///< anything else
};

/// What one `RG` brought.
struct PollOutcome {
    PollKind kind = PollKind::kFailed;
    std::string distance;
    std::optional<geometry::Pointing> pointing;
    std::string raw;
    core::Error error;
    core::Duration asked_at{0};
};

/// RG, once. The circles in the block are noted in passing.
[[nodiscard]] core::Task<PollOutcome> pollDistance(StatePtr state, std::stop_token stop);

/// Back to back near the expected end, with pauses while it is far; the first poll follows TG at once, so
/// that an older distance shows itself by being there too soon.
[[nodiscard]] core::Task<core::Result<void>> pauseBeforePoll(StatePtr state, core::Duration began_at,
                                                             std::optional<core::Duration> soonest, int polls,
                                                             std::stop_token stop);
/// D-bar: lets the mean settle, with the circles kept fresh.
[[nodiscard]] core::Task<core::Result<void>> watchAveraging(StatePtr state, core::Duration span,
                                                            std::stop_token stop);

enum class PollVerdict { kGoOn, kFound, kAgain, kFailed };

/// Follows the polls of one shot: which of them brought the distance of this trigger.
class PollJudge {
public:
    explicit PollJudge(GeodimeterState& state) : state_(state) {}

    [[nodiscard]] PollVerdict judge(PollOutcome& outcome, core::Duration began_at);

private:
    [[nodiscard]] PollVerdict judgeOld(PollOutcome& outcome, core::Duration began_at);
    [[nodiscard]] PollVerdict judgeInvalid(core::Duration began_at);
    [[nodiscard]] PollVerdict judgeFailure(const core::Error& error);

    GeodimeterState& state_;
    bool was_measuring_ = false;
    bool answer_lost_ = false;
    std::optional<int> failure_code_;
    int old_in_row_ = 0;
    int invalid_in_row_ = 0;
    int trouble_in_row_ = 0;
};

}  // namespace pmts::instrument
