#include "line_sessions.hpp"

#include "pmts/blackbox/recording.hpp"
#include "pmts/protocol/line_talk.hpp"
#include "pmts/transport/session_log.hpp"

#include <QCborMap>
#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {
namespace {

using protocol::Progress;
using protocol::TalkSide;

constexpr double kUnits_per_s = 1e6;  ///< times are whole microseconds
constexpr std::size_t kEventsBetween = std::size_t{1} << 12;

QString say(const char* text) { return QCoreApplication::translate("LineRecording", text); }

/// Dialogues one behind the other on one scale of time.
class Dialogues {
public:
    void add(core::Duration at, TalkSide side, std::string_view bytes) {
        const auto us = std::chrono::duration_cast<std::chrono::microseconds>(at).count();
        last_ = std::max(last_, begin_ + static_cast<std::uint64_t>(std::max<std::int64_t>(0, us)));
        const auto characters = protocol::charactersOf(bytes, side, last_);
        recording.said.insert(recording.said.end(), characters.begin(), characters.end());
        last_ += bytes.size();
    }
    void endOfOne() { begin_ = last_ + static_cast<std::uint64_t>(kUnits_per_s); }

    LineRecording recording{.path = {}, .capture = {}, .said = {}, .samples_per_s = kUnits_per_s};

private:
    std::uint64_t begin_ = 0, last_ = 0;
};

/// What went over one port.
struct PortTalk {
    QString port;
    std::vector<transport::SessionEvent> events;
    std::size_t bytes = 0;
};

std::optional<TalkSide> sideOf(const QString& direction) {
    if (direction == u">") {
        return TalkSide::kToInstrument;
    }
    return direction == u"<" ? std::optional(TalkSide::kFromInstrument) : std::nullopt;  // `!` is a sentence
}

void take(std::vector<PortTalk>& ports, core::Duration at, const QCborMap& body) {
    const auto side = sideOf(body.value(QStringLiteral("dir")).toString());
    const QByteArray bytes = body.value(QStringLiteral("bytes")).toByteArray();
    if (!side || bytes.isEmpty()) {
        return;
    }
    const QString port = body.value(QStringLiteral("port")).toString();
    auto known = std::ranges::find(ports, port, &PortTalk::port);
    if (known == ports.end()) {
        known = ports.insert(ports.end(), {.port = port, .events = {}});
    }
    known->bytes += static_cast<std::size_t>(bytes.size());
    known->events.push_back({.at = at,
                             .direction = *side == TalkSide::kToInstrument ? transport::Direction::kSent
                                                                           : transport::Direction::kReceived,
                             .bytes = bytes.toStdString()});
}

core::Result<std::vector<PortTalk>> portsOf(const blackbox::Recording& box, const Progress& progress) {
    std::vector<PortTalk> ports;
    const auto& entries = box.entries();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i % kEventsBetween == 0 && progress && !progress(static_cast<double>(i) / static_cast<double>(entries.size()))) {
            return core::cancelled();
        }
        if (entries[i].kind == blackbox::Kind::kBytes) {
            take(ports, entries[i].at, box.body(entries[i]));
        }
    }
    return ports;
}

void doubt(LineRecording& recording, const QString& what) {
    recording.capture.doubts.push_back({.run = 0, .what = what, .mended = false});
}

}  // namespace

bool isBlackBox(std::string_view bytes) { return bytes.starts_with(blackbox::kFileHead); }

core::Result<LineRecording> readBlackBox(const QString& path, const Progress& progress) {
    const auto box = blackbox::Recording::open(path);
    PMTS_TRY(box);
    const auto ports = portsOf(**box, progress);
    PMTS_TRY(ports);
    Dialogues talk;
    QStringList names;
    for (const PortTalk& port : *ports) {
        for (const auto& event : port.events) {
            const bool is_sent = event.direction == transport::Direction::kSent;
            talk.add(event.at - port.events.front().at, is_sent ? TalkSide::kToInstrument : TalkSide::kFromInstrument, event.bytes);
        }
        talk.endOfOne();
        names << say("%1 (%2 bytes)").arg(port.port, QString::number(port.bytes));
    }
    if (names.size() > 1) {
        doubt(talk.recording, say("Several ports were recorded, here one behind the other: %1.").arg(names.join(QStringLiteral(", "))));
    }
    if (!(*box)->damages().empty()) {
        doubt(talk.recording, say("Damaged places of the file, passed over: %1.").arg((*box)->damages().size()));
    }
    return std::move(talk.recording);
}

core::Result<LineRecording> readSessions(const QString& path, const Progress& progress) {
    const auto wanted = [&progress](double share) { return !progress || progress(share); };
    const auto sessions = transport::readSessionLog(path, [&wanted] { return wanted(0.0); });
    PMTS_TRY(sessions);
    Dialogues talk;
    std::size_t events = 0;
    for (const transport::Session& session : *sessions) {
        for (const transport::SessionEvent& event : session.events) {
            if (events++ % kEventsBetween == 0 && !wanted(0.5)) {
                return core::cancelled();
            }
            if (event.direction != transport::Direction::kLost) {
                const bool is_sent = event.direction == transport::Direction::kSent;
                talk.add(event.at, is_sent ? TalkSide::kToInstrument : TalkSide::kFromInstrument, event.bytes);
            }
        }
        talk.endOfOne();
    }
    return std::move(talk.recording);
}

}  // namespace pmts::app
