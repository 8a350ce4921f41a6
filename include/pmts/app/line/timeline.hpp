#pragma once

#include "pmts/app/line/line_words.hpp"
#include "pmts/scheduler/tt_statistics.hpp"

#include <QAbstractTableModel>

#include <deque>
#include <optional>
#include <utility>

namespace pmts::app {

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
    /// Equal ones within a second become one line that counts them.
    void addUnasked(const scheduler::Stray& stray);
    /// However many readings come: one line a second.
    void addStreamReading(const geometry::Pointing& pointing, core::Duration at);
    void addMissing(std::uint64_t records, core::Duration from, core::Duration to);
    /// Only what changed is a line.
    void addAir(const std::optional<double>& temperature_degc, const std::optional<double>& pressure_mbar, core::Duration at);
    void setUnits(const std::optional<protocol::WireUnits>& units);
    /// What the user calls labels and variables (VariableNames).
    void setNames(const QMap<QString, QString>& names);
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
    [[nodiscard]] QDateTime utcOf(core::Duration at) const { return words_.utcOf(at); }
    [[nodiscard]] const LineWords& words() const { return words_; }

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
    void sayAnew();
    [[nodiscard]] LineHealth judge(LineEvent& event);
    [[nodiscard]] QVariant cell(const LineEvent& event, int column) const;

    const core::Clock& clock_;
    std::deque<LineEvent> events_;
    std::deque<FrameTick> frames_;
    std::deque<OwnerMark> owners_;
    LineWords words_;
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
    std::optional<core::Duration> shown_now_;
};

}  // namespace pmts::app
