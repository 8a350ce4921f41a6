#include "pmts/blackbox/excerpt.hpp"

#include <algorithm>
#include <limits>

namespace pmts::blackbox {
namespace {

bool holdsOn(Kind kind) {
    return kind == Kind::kSession || kind == Kind::kConnection || kind == Kind::kControl || kind == Kind::kAir;
}

/// What says how things stood at the beginning comes first; then everything since.
struct Found {
    const Recording* recording = nullptr;
    Entry entry;
};

std::vector<Found> chosenOf(const std::vector<std::shared_ptr<const Recording>>& recordings, core::Duration since, bool pictures) {
    std::map<Kind, Found> before;
    std::vector<Found> chosen;
    for (const auto& recording : recordings) {
        for (const Entry& entry : recording->entries()) {
            const bool is_old = entry.at < since;
            if (is_old && holdsOn(entry.kind)) {
                before[entry.kind] = {recording.get(), entry};
            }
            const bool is_repeated_head = entry.kind == Kind::kSession && !before.empty();
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
    const QCborMap map = found.recording->body(found.entry);
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
            const QDateTime utc = QDateTime::fromString(
                found.recording->body(found.entry).value(QStringLiteral("utc")).toString(), Qt::ISODateWithMs);
            const auto ms = [&](core::Duration at) {
                return std::chrono::duration_cast<std::chrono::milliseconds>(at - found.entry.at).count();
            };
            excerpt.from_utc = utc.addMSecs(std::max<qint64>(0, ms(newest - order.last)));
            excerpt.to_utc = utc.addMSecs(ms(newest));
        }
    }
    return excerpt;
}

}  // namespace pmts::blackbox
