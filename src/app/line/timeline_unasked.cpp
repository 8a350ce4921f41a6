#include "pmts/app/line/timeline.hpp"
#include "pmts/protocol/reply.hpp"

#include <algorithm>

namespace pmts::app {

namespace {

using namespace std::chrono_literals;

constexpr core::Duration kOneLine = 1s;  ///< what comes again and again within it is one line

}  // namespace

LineEvent* Timeline::openEvent(const std::optional<std::uint64_t>& number, core::Duration at) {
    const LineEvent* const found = number ? find(*number) : nullptr;
    if (found == nullptr || at < found->ended || at - found->began >= kOneLine) {
        return nullptr;
    }
    return &events_[static_cast<std::size_t>(found->number - events_.front().number)];
}

void Timeline::grow(LineEvent& event, core::Duration at) {
    ++event.count;
    event.ended = at;
    longest_ = std::max(longest_, event.ended - event.began);
    latest_ = std::max(latest_, at);
    for (auto later = events_.rbegin(); later->number != event.number; ++later) {
        disorder_ = std::max(disorder_, at - later->ended);
    }
    const auto row = static_cast<int>(event.number - events_.front().number);
    Q_EMIT dataChanged(index(row, kTime), index(row, kOutcome));
}

void Timeline::addUnasked(const scheduler::Stray& stray) {
    LineEvent* const open = openEvent(open_unasked_, stray.at);
    if (open != nullptr && open->record.received == stray.bytes && open->stray == stray.kind) {
        return grow(*open, stray.at);
    }
    LineEvent event{.kind = LineEvent::Kind::kUnasked, .began = stray.at, .sent = stray.at, .ended = stray.at};
    event.record.received = stray.bytes;
    event.stray = stray.kind;
    const bool is_whole = stray.kind == scheduler::StrayKind::kUnsolicited && !protocol::parseReply(stray.bytes).damaged;
    event.health = is_whole ? LineHealth::kGood : LineHealth::kSlow;
    open_unasked_ = add(std::move(event));
}

void Timeline::addStreamReading(const geometry::Pointing& pointing, core::Duration at) {
    if (LineEvent* const open = openEvent(open_stream_, at)) {
        open->pointing = pointing;
        return grow(*open, at);
    }
    LineEvent event{.kind = LineEvent::Kind::kStream, .began = at, .sent = at, .ended = at};
    event.pointing = pointing;
    open_stream_ = add(std::move(event));
}

void Timeline::addMissing(std::uint64_t records, core::Duration from, core::Duration to) {
    LineEvent event{.kind = LineEvent::Kind::kMissing, .began = from, .sent = from, .ended = to, .health = LineHealth::kSlow};
    event.count = records;
    event.text = tr("Missing here: %1 records of the black box.").arg(records);
    add(std::move(event));
}

void Timeline::addAir(const std::optional<double>& temperature_degc, const std::optional<double>& pressure_mbar,
                      core::Duration at) {
    QStringList said;
    if (temperature_degc) {
        said.append(tr("%1 °C").arg(*temperature_degc, 0, 'f', 1));
    }
    if (pressure_mbar) {
        said.append(tr("%1 mbar").arg(*pressure_mbar, 0, 'f', 1));
    }
    const QString text = said.join(QStringLiteral(", "));
    if (!text.isEmpty() && text != std::exchange(last_air_, text)) {
        addRemark(LineEvent::Kind::kAir, LineHealth::kGood, tr("Air: %1.").arg(text), at);
    }
}

void Timeline::addRemark(LineEvent::Kind kind, LineHealth health, const QString& text, core::Duration at) {
    add({.kind = kind, .began = at, .sent = at, .ended = at, .health = health, .text = text});
}

}  // namespace pmts::app
