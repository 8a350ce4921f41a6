#include "pmts/app/line/timeline.hpp"

#include "pmts/protocol/info_code.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/wire_words.hpp"

#include <algorithm>

namespace pmts::app {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kForgottenAtOnce = 500;  ///< the table loses rows seldom, not with each event
constexpr double kSlowFactor = 3.0;
constexpr core::Duration kNeverSlow = 250ms;
constexpr core::Duration kGapWorthSaying = 500ms;

/// The kind of a command, for its usual time; empty where the time hangs on what is measured or how far it turns.
std::string kindOf(const std::string& sent) {
    if (sent.starts_with("WS") || sent.starts_with("TG") || sent.starts_with("PV") || sent.starts_with('O') ||
        sent.starts_with('L') || sent == "RG\r") {
        return {};
    }
    return sent.substr(0, sent.find_first_of("=\r"));
}

/// `240 process finished`, `150 motion finished` and `301 signal` are answers, not refusals.
bool isRefused(const scheduler::TransactionRecord& record) {
    const protocol::Reply reply = protocol::parseReply(record.received, protocol::shapeOfAnswerTo(record.sent));
    if (!reply.status || reply.status->code == 0 || protocol::isWarning(reply.status->code)) {
        return false;
    }
    const protocol::InfoClass info_class = protocol::infoCode(reply.status->code).info_class;
    return info_class != protocol::InfoClass::kOk && info_class != protocol::InfoClass::kData;
}

qint64 milliseconds(core::Duration span) { return std::chrono::duration_cast<std::chrono::milliseconds>(span).count(); }

template <class Item>
void keepNewest(std::deque<Item>& ring) {
    if (ring.size() > Timeline::kCapacity) {
        ring.pop_front();
    }
}

}  // namespace

Timeline::Timeline(const core::Clock& clock, QObject* parent)
    : QAbstractTableModel(parent), clock_(clock) {
    words_.utc_of_zero = clock.utcNow().addMSecs(-milliseconds(clock.now()));
}

std::uint64_t Timeline::add(LineEvent event) {
    if (events_.size() >= kCapacity) {
        beginRemoveRows({}, 0, static_cast<int>(kForgottenAtOnce) - 1);
        events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(kForgottenAtOnce));
        endRemoveRows();
    }
    longest_ = std::max(longest_, event.ended - event.began);
    disorder_ = std::max(disorder_, latest_ - event.ended);
    latest_ = std::max(latest_, event.ended);
    event.number = next_number_++;
    const int row = static_cast<int>(events_.size());
    beginInsertRows({}, row, row);
    events_.push_back(std::move(event));
    endInsertRows();
    return next_number_ - 1;
}

void Timeline::addTransaction(const scheduler::TransactionRecord& record) {
    LineEvent event{.kind = LineEvent::Kind::kTransaction,
                    .began = record.queued_at,
                    .sent = record.sent_at,
                    .ended = record.finished_at,
                    .record = record};
    if (event.sent < event.began) {  // never sent: it waited until it was given up
        event.sent = event.ended;
    }
    if (!event.record.received.empty() && event.record.received.back() == '>') {
        event.record.received.pop_back();
    }
    event.health = judge(event);
    add(std::move(event));
}

LineHealth Timeline::judge(LineEvent& event) {
    switch (event.record.outcome) {
        case scheduler::Outcome::kTimedOut: return event.record.may_stay_silent ? LineHealth::kNote : LineHealth::kFailed;
        case scheduler::Outcome::kFailed: return LineHealth::kFailed;
        case scheduler::Outcome::kCancelled:
        case scheduler::Outcome::kSwallowed: return LineHealth::kNote;
        case scheduler::Outcome::kAnswered: break;
    }
    if (isRefused(event.record)) {
        return LineHealth::kFailed;
    }
    const std::string kind = kindOf(event.record.sent);
    if (kind.empty()) {
        return LineHealth::kGood;
    }
    const auto usual = usual_times_.quantile(kind, 0.5);
    const bool known = usual && usual_times_.count(kind) >= 8;
    usual_times_.add(kind, event.onWire());
    if (known && event.onWire() > kNeverSlow && event.onWire() > *usual * kSlowFactor) {
        event.usual = usual;
        return LineHealth::kSlow;
    }
    return LineHealth::kGood;
}

void Timeline::addFrame(core::Duration captured_at, std::uint64_t sequence, std::uint64_t dropped_by_gate) {
    if (!frames_.empty() && captured_at <= frames_.back().at) {
        return;  // the same picture again, or a camera that was exchanged
    }
    FrameTick tick{.at = captured_at};
    const bool goes_on = last_sequence_ != 0 && sequence > last_sequence_;
    const std::uint64_t between = goes_on ? sequence - last_sequence_ - 1 : 0;
    const std::uint64_t dropped = dropped_by_gate > last_dropped_ ? dropped_by_gate - last_dropped_ : 0;
    tick.dropped = static_cast<int>(std::min(between, dropped));
    tick.missing = static_cast<int>(between) - tick.dropped;
    last_sequence_ = sequence;
    last_dropped_ = dropped_by_gate;
    const core::Duration before = frames_.empty() ? captured_at : frames_.back().at;
    frames_.push_back(tick);
    keepNewest(frames_);
    if (tick.missing > 0 && captured_at - before > kGapWorthSaying) {
        add({.kind = LineEvent::Kind::kGap, .began = before, .sent = before, .ended = captured_at,
             .health = LineHealth::kSlow,
             .text = tr("The picture stood still for %1, frames missing: %2.").arg(spanText(captured_at - before)).arg(tick.missing)});
    }
}

void Timeline::addControl(const instrument::ControlStatus& status) {
    const bool other_mode = !owners_.empty() && owners_.back().mode != status.mode;
    if (!owners_.empty() && !other_mode && owners_.back().owner == status.owner) {
        return;
    }
    const core::Duration from = owners_.empty() ? status.owner_since : std::max(status.owner_since, owners_.back().from);
    owners_.push_back({.from = from, .owner = status.owner, .mode = status.mode});
    keepNewest(owners_);
    if (other_mode) {
        static const char* const kSentences[] = {QT_TR_NOOP("Panel and computer share the instrument."),
                                                 QT_TR_NOOP("The computer has control."),
                                                 QT_TR_NOOP("The panel has control.")};
        addRemark(LineEvent::Kind::kControl, LineHealth::kNote, tr(kSentences[static_cast<int>(status.mode)]), now());
    }
}

void Timeline::addConnection(const QString& sentence, LineHealth health) {
    addRemark(LineEvent::Kind::kConnection, health, sentence, now());
}

void Timeline::setUnits(const std::optional<protocol::WireUnits>& units) {
    words_.units = units;
    sayAnew();
}

void Timeline::setNames(const QMap<QString, QString>& names) {
    if (names != words_.names) {
        words_.names = names;
        sayAnew();
    }
}

void Timeline::sayAnew() {
    if (!events_.empty()) {
        Q_EMIT dataChanged(index(0, kWhat), index(rowCount() - 1, kAnswer));
    }
}

void Timeline::clear() {
    beginResetModel();
    events_.clear();
    frames_.clear();
    owners_.clear();
    usual_times_ = scheduler::TtStatistics();
    longest_ = latest_ = disorder_ = {};
    open_stream_.reset();
    open_unasked_.reset();
    last_air_.clear();
    last_sequence_ = last_dropped_ = 0;
    endResetModel();
}

void Timeline::showMoment(core::Duration now, const QDateTime& utc_of_zero) {
    shown_now_ = now;
    words_.utc_of_zero = utc_of_zero;
}

std::pair<std::size_t, std::size_t> Timeline::eventsIn(core::Duration from, core::Duration to) const {
    const auto ends_before = [](const LineEvent& event, core::Duration at) { return event.ended < at; };
    // What comes from another thread or grows may end a little before the one in front of it.
    const auto first = std::lower_bound(events_.begin(), events_.end(), from - disorder_, ends_before);
    // An event that ends later than this began after the span: none was ever longer.
    const auto last = std::lower_bound(first, events_.end(), to + longest_ + disorder_ + core::Duration(1), ends_before);
    return {static_cast<std::size_t>(first - events_.begin()), static_cast<std::size_t>(last - events_.begin())};
}

const LineEvent* Timeline::find(std::uint64_t number) const {
    const std::uint64_t first = events_.empty() ? 0 : events_.front().number;
    const bool is_kept = number >= first && number - first < events_.size();
    return is_kept ? &events_[static_cast<std::size_t>(number - first)] : nullptr;
}

core::Duration Timeline::now() const { return shown_now_.value_or(clock_.now()); }

int Timeline::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(events_.size()); }

int Timeline::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant Timeline::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const LineEvent& event = events_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case kHealthRole: return static_cast<int>(event.health);
        case Qt::DisplayRole: return cell(event, index.column());
        case Qt::ToolTipRole: return index.column() == kTime ? QVariant() : cell(event, index.column());
        case Qt::TextAlignmentRole:
            return QVariant(index.column() == kWaited || index.column() == kOnWire ? Qt::AlignRight | Qt::AlignVCenter
                                                                                  : Qt::AlignLeft | Qt::AlignVCenter);
        default: return {};
    }
}

QVariant Timeline::cell(const LineEvent& event, int column) const {
    const bool is_transaction = event.kind == LineEvent::Kind::kTransaction;
    switch (column) {
        case kTime: return words_.timeOfDay(event);
        case kWho: return words_.who(event);
        case kWhat: return words_.what(event);
        case kAnswer: return words_.answer(event);
        case kWaited: return is_transaction ? QVariant(spanText(event.waited())) : QVariant();
        case kOnWire: return is_transaction ? QVariant(spanText(event.onWire())) : QVariant();
        case kOutcome: return is_transaction ? QVariant(words_.outcome(event)) : QVariant();
        default: return {};
    }
}

QVariant Timeline::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case kTime: return tr("Time");
        case kWho: return tr("Who");
        case kWhat: return tr("What");
        case kAnswer: return tr("Answer");
        case kWaited: return tr("Waited");
        case kOnWire: return tr("On the wire");
        case kOutcome: return tr("Outcome");
        default: return {};
    }
}

}  // namespace pmts::app
