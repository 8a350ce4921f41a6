#include "pmts/blackbox/excerpt.hpp"

#include "pmts/blackbox/run.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace pmts::blackbox {
namespace {

constexpr qint64 kClockWasSet_ms = 2000;

QDateTime utcIn(const QCborMap& session) {
    return QDateTime::fromString(session.value(QStringLiteral("utc")).toString(), Qt::ISODateWithMs);
}

qint64 milliseconds(core::Duration span) { return std::chrono::duration_cast<std::chrono::milliseconds>(span).count(); }

/// What says how things stood at the beginning comes first; then everything since.
struct Found {
    const Recording* recording = nullptr;
    Entry entry;
};

std::vector<Found> chosenOf(const std::vector<std::shared_ptr<const Recording>>& recordings, core::Duration since, bool pictures) {
    std::map<Kind, Found> before;
    std::vector<Found> chosen;
    QDateTime utc_of_zero;
    for (const auto& recording : recordings) {
        for (const Entry& entry : recording->entries()) {
            const bool is_old = entry.at < since;
            if (is_old && holdsOn(entry.kind)) {
                before[entry.kind] = {recording.get(), entry};
            }
            bool is_repeated_head = entry.kind == Kind::kSession && !before.empty();
            if (entry.kind == Kind::kSession) {  // again where the clock was set: the time of day is counted from the last one
                const QDateTime zero = utcIn(recording->body(entry)).addMSecs(-milliseconds(entry.at));
                const QDateTime known = std::exchange(utc_of_zero, zero);
                is_repeated_head = is_repeated_head && std::abs(known.msecsTo(zero)) < kClockWasSet_ms;
            }
            if (!is_old && !is_repeated_head && (pictures || entry.kind != Kind::kFrame)) {
                chosen.push_back({recording.get(), entry});
            }
        }
    }
    std::vector<Found> all;
    for (const auto& [kind, found] : before) {  // the session is the lowest kind
        all.push_back(found);
    }
    all.insert(all.end(), chosen.begin(), chosen.end());
    return all;
}

QByteArray bodyFor(const Found& found, const Scrubber& scrubber) {
    QCborMap map = found.recording->body(found.entry);
    if (found.entry.kind == Kind::kSession) {
        map[QStringLiteral("excerpt")] = true;
    }
    if (found.entry.kind != Kind::kFrame) {
        return bodyOf(scrubber.scrubbed(QCborValue(map)).toMap());
    }
    return bodyOf(map);
}

}  // namespace

Excerpt excerptOf(const std::vector<std::shared_ptr<const Recording>>& recordings, const ExcerptOrder& order) {
    Excerpt excerpt;
    core::Duration newest{std::numeric_limits<core::Duration::rep>::min()};
    for (const auto& recording : recordings) {
        newest = std::max(newest, recording->entries().back().at);
    }
    excerpt.bytes.append(kFileHead.data(), static_cast<qsizetype>(kFileHead.size()));
    for (const Found& found : chosenOf(recordings, newest - order.last, order.pictures)) {
        excerpt.bytes += encoded({.kind = found.entry.kind, .at = found.entry.at, .body = bodyFor(found, order.scrubber)});
        excerpt.records[found.entry.kind] += 1;
        if (found.entry.kind == Kind::kSession) {
            const QDateTime utc = utcIn(found.recording->body(found.entry));
            if (!excerpt.from_utc.isValid()) {
                excerpt.from_utc = utc.addMSecs(std::max<qint64>(0, milliseconds(newest - order.last - found.entry.at)));
            }
            excerpt.to_utc = utc.addMSecs(milliseconds(newest - found.entry.at));
        }
    }
    return excerpt;
}

}  // namespace pmts::blackbox
