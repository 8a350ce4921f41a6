#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/instrument/control_settings.hpp"
#include "pmts/protocol/units.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/scheduler/tt_statistics.hpp"

#include <QAbstractTableModel>
#include <QDateTime>

#include <deque>
#include <optional>
#include <utility>

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
        kUnasked,     ///< a block that nobody asked for: REG key, slave mode; its bytes are record.received
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

/// What went over the line and came by itself, newest last, in rings that forget the oldest; also the table of it. Costs a few microseconds an
/// event: words are made when they are looked at.
class Timeline : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kWho, kWhat, kAnswer, kWaited, kOnWire, kOutcome, kColumnCount };
    enum Role { kHealthRole = Qt::UserRole };
    static constexpr std::size_t kCapacity = 20000;  ///< of each ring

    /// The clock outlives the time line.
    explicit Timeline(const core::Clock& clock, QObject* parent = nullptr);

    void addTransaction(const scheduler::TransactionRecord& record);
    /// `sequence` counts the frames of the device, `dropped_by_gate` those that the video gate has cost so far.
    void addFrame(core::Duration captured_at, std::uint64_t sequence, std::uint64_t dropped_by_gate);
    void addControl(const instrument::ControlStatus& status);
    void addConnection(const QString& sentence, LineHealth health);
    /// Equal blocks within a second become one line that counts them.
    void addUnasked(const std::string& bytes, core::Duration at);
    /// However many readings come: one line a second.
    void addStreamReading(const geometry::Pointing& pointing, core::Duration at);
    void addMissing(std::uint64_t records, core::Duration from, core::Duration to);
    /// Only what changed is a line.
    void addAir(const std::optional<double>& temperature_degc, const std::optional<double>& pressure_mbar, core::Duration at);
    void setUnits(const std::optional<protocol::WireUnits>& units);
    void clear();
    /// A recording is shown: its moment and the time of day of its clock's zero.
    void showMoment(core::Duration now, const QDateTime& utc_of_zero);

    [[nodiscard]] const std::deque<LineEvent>& events() const { return events_; }
    [[nodiscard]] const std::deque<FrameTick>& frames() const { return frames_; }
    [[nodiscard]] const std::deque<OwnerMark>& owners() const { return owners_; }
    /// Indices [first, last) of the events that can reach into a span of time; the events end nearly in order.
    [[nodiscard]] std::pair<std::size_t, std::size_t> eventsIn(core::Duration from, core::Duration to) const;
    [[nodiscard]] const LineEvent* find(std::uint64_t number) const;  ///< null: forgotten
    [[nodiscard]] core::Duration now() const;
    [[nodiscard]] QDateTime utcOf(core::Duration at) const;

    // Plain language.
    [[nodiscard]] QString whoText(const LineEvent& event) const;
    [[nodiscard]] QString whatText(const LineEvent& event) const;
    [[nodiscard]] QString answerText(const LineEvent& event) const;
    [[nodiscard]] QString outcomeText(const LineEvent& event) const;
    /// Everything about it, in lines: the panel beside the lanes.
    [[nodiscard]] QStringList detailLines(const LineEvent& event) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::uint64_t add(LineEvent event);  ///< its number
    void addRemark(LineEvent::Kind kind, LineHealth health, const QString& text, core::Duration at);
    /// The last line of a kind, where it began less than a second before; else null.
    [[nodiscard]] LineEvent* openEvent(const std::optional<std::uint64_t>& number, core::Duration at);
    void grow(LineEvent& event, core::Duration at);
    [[nodiscard]] LineHealth judge(LineEvent& event);
    [[nodiscard]] QVariant cell(const LineEvent& event, int column) const;

    const core::Clock& clock_;
    std::deque<LineEvent> events_;
    std::deque<FrameTick> frames_;
    std::deque<OwnerMark> owners_;
    std::optional<protocol::WireUnits> units_;
    scheduler::TtStatistics usual_times_;
    core::Duration longest_{0};  ///< from queueing to end, of any event so far
    core::Duration latest_{0};   ///< end of any event so far
    core::Duration disorder_{0}; ///< by how much an event ended before one that stands in front of it
    std::optional<std::uint64_t> open_stream_;
    std::optional<std::uint64_t> open_unasked_;
    QString last_air_;
    std::uint64_t next_number_ = 0;
    std::uint64_t last_sequence_ = 0;
    std::uint64_t last_dropped_ = 0;
    QDateTime utc_of_zero_;  ///< fixed: a clock that is set meanwhile must not move what was
    std::optional<core::Duration> shown_now_;
};

/// `52 ms`, `3.2 s`: a span of time as people say it.
[[nodiscard]] QString spanText(core::Duration span);
/// Bytes of the line with `\r` and `\x07` for those that would not show.
[[nodiscard]] QString bytesText(const std::string& bytes);

}  // namespace pmts::app
