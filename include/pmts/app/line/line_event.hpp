#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/instrument/control_settings.hpp"
#include "pmts/scheduler/scheduler.hpp"

#include <QString>

#include <optional>

namespace pmts::app {

/// How an event of the line ended. What is not good has a shape of its own, not only a colour.
enum class LineHealth {
    kGood,
    kNote,    ///< meant to be so: cancelled, swallowed, control changed
    kSlow,    ///< much longer than its kind usually takes
    kFailed,  ///< no answer, the line was lost, the instrument refused
};

/// One thing that happened on the line. Times on core::Clock's scale.
struct LineEvent {
    enum class Kind {
        kTransaction,
        kControl,
        kGap,         ///< the picture stood still
        kConnection,
        kUnasked,     ///< what answers nobody: REG key, slave mode, a late answer; its bytes are record.received
        kStream,      ///< readings that come by themselves, those of about a second in one
        kMissing,     ///< of a recording: so many records could not be kept
        kAir,         ///< temperature, pressure
    };

    Kind kind = Kind::kTransaction;
    core::Duration began{0};  ///< queued
    core::Duration sent{0};   ///< as began where nothing was sent
    core::Duration ended{0};
    LineHealth health = LineHealth::kGood;
    scheduler::TransactionRecord record{};  ///< of a transaction
    scheduler::StrayKind stray = scheduler::StrayKind::kUnsolicited;  ///< of what came unasked
    std::optional<geometry::Pointing> pointing{};  ///< the last one of a stream
    std::uint64_t count = 1;                ///< readings of a stream, equal blocks, records missing
    std::optional<core::Duration> usual{};  ///< of its kind, where it was slow
    QString text{};                         ///< of the others
    std::uint64_t number = 0;               ///< counts up by one; holds while the oldest are forgotten

    [[nodiscard]] core::Duration waited() const { return sent - began; }
    [[nodiscard]] core::Duration onWire() const { return ended - sent; }
};

/// A picture of the live view and how many before it did not come.
struct FrameTick {
    core::Duration at{0};
    int dropped = 0;  ///< at the source, while the video gate was closed
    int missing = 0;  ///< for another reason
};

/// Who had the line from a moment on.
struct OwnerMark {
    core::Duration from{0};
    scheduler::LineOwner owner = scheduler::LineOwner::kIdle;
    scheduler::ControlMode mode = scheduler::ControlMode::kShared;
};

}  // namespace pmts::app
