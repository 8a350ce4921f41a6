#include "pmts/app/line/line_words.hpp"

#include "pmts/app/line/variable_names.hpp"
#include "pmts/protocol/line_talk.hpp"
#include "pmts/protocol/wire_words.hpp"

#include <QCoreApplication>

namespace pmts::app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Timeline", text); }

double seconds(core::Duration span) { return std::chrono::duration<double>(span).count(); }

protocol::Reply replyOf(const scheduler::TransactionRecord& record) {
    return protocol::parseReply(record.received, protocol::shapeOfAnswerTo(record.sent));
}

protocol::NameOf nameOf(const QMap<QString, QString>& names) {
    if (names.isEmpty()) {
        return nullptr;
    }
    return [names](char unit, int number) { return names.value(variableKey(unit, number)); };
}

QString strayText(scheduler::StrayKind kind) {
    switch (kind) {
        case scheduler::StrayKind::kLate: return tr("an answer that came too late");
        case scheduler::StrayKind::kDoubled: return tr("the same answer once more");
        case scheduler::StrayKind::kNoise: return tr("noise");
        case scheduler::StrayKind::kUnsolicited: break;
    }
    return tr("came unasked");
}

}  // namespace

QString bytesText(const std::string& bytes) { return QString::fromStdString(protocol::shownBytes(bytes)); }

QString spanText(core::Duration span) {
    const double s = seconds(span);
    if (s < 0.00095) {
        return s < 0.00005 ? QStringLiteral("0") : QStringLiteral("%1 ms").arg(s * 1e3, 0, 'f', 1);
    }
    if (s < 0.9995) {
        return QStringLiteral("%1 ms").arg(s * 1e3, 0, 'f', s < 0.01 ? 1 : 0);
    }
    return s < 99.95 ? QStringLiteral("%1 s").arg(s, 0, 'f', 1) : QStringLiteral("%1 min").arg(s / 60.0, 0, 'f', 1);
}

QDateTime LineWords::utcOf(core::Duration at) const {
    return utc_of_zero.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(at).count());
}

QString LineWords::timeOfDay(const LineEvent& event) const {
    return utcOf(event.sent).toLocalTime().toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString LineWords::who(const LineEvent& event) const {
    switch (event.kind) {
        case LineEvent::Kind::kGap: return tr("Camera");
        case LineEvent::Kind::kControl: return tr("Control");
        case LineEvent::Kind::kConnection: return tr("Link");
        case LineEvent::Kind::kUnasked:
        case LineEvent::Kind::kStream: return tr("Instrument");
        case LineEvent::Kind::kMissing: return tr("Recording");
        case LineEvent::Kind::kAir: return tr("Air");
        case LineEvent::Kind::kTransaction: break;
    }
    return event.record.master == scheduler::Master::kPanel ? tr("Panel") : tr("PMTS");
}

QString LineWords::what(const LineEvent& event) const {
    if (event.kind == LineEvent::Kind::kStream) {
        return tr("angle stream, readings: %1").arg(event.count);
    }
    if (event.kind == LineEvent::Kind::kUnasked) {
        const QString stray = strayText(event.stray);
        return event.count == 1 ? stray : tr("%1, %2 times").arg(stray).arg(event.count);
    }
    if (event.kind != LineEvent::Kind::kTransaction) {
        return event.text;
    }
    return protocol::commandInWords(event.record.sent, units, nameOf(names)).value_or(bytesText(event.record.sent));
}

QString LineWords::answer(const LineEvent& event) const {
    if (event.kind == LineEvent::Kind::kStream && event.pointing) {
        return tr("HA %1 gon, VA %2 gon").arg(event.pointing->ha.gon(), 0, 'f', 5).arg(event.pointing->va.gon(), 0, 'f', 5);
    }
    if (event.kind == LineEvent::Kind::kUnasked && event.stray == scheduler::StrayKind::kNoise) {
        return event.record.received.empty() ? tr("a block end alone") : bytesText(event.record.received);
    }
    if (event.kind == LineEvent::Kind::kUnasked) {
        return protocol::replyInWords({}, protocol::parseReply(event.record.received), units, nameOf(names));
    }
    if (event.kind != LineEvent::Kind::kTransaction || event.record.outcome == scheduler::Outcome::kSwallowed) {
        return {};
    }
    if (event.record.received.empty()) {
        return event.record.outcome == scheduler::Outcome::kAnswered ? tr("done") : QString();
    }
    if (!protocol::commandInWords(event.record.sent) || event.record.outcome != scheduler::Outcome::kAnswered) {
        return bytesText(event.record.received);
    }
    return protocol::replyInWords(event.record.sent, replyOf(event.record), units, nameOf(names));
}

QString LineWords::outcome(const LineEvent& event) const {
    if (event.kind != LineEvent::Kind::kTransaction) {
        return {};
    }
    switch (event.record.outcome) {
        case scheduler::Outcome::kTimedOut:
            return (event.record.may_stay_silent ? tr("No answer within %1, as it may be.") : tr("No answer within %1."))
                .arg(spanText(event.onWire()));
        case scheduler::Outcome::kCancelled: return tr("Cancelled after %1.").arg(spanText(event.ended - event.began));
        case scheduler::Outcome::kFailed: return tr("The line was lost or the command was refused.");
        case scheduler::Outcome::kSwallowed: return tr("Not passed on: the computer has control.");
        case scheduler::Outcome::kAnswered: break;
    }
    if (event.health == LineHealth::kFailed) {
        const protocol::Reply reply = replyOf(event.record);
        return tr("The instrument refused: info %1.").arg(reply.status ? reply.status->code : 0);
    }
    if (event.usual) {
        return tr("Answered, but slowly: usually %1.").arg(spanText(*event.usual));
    }
    return tr("Answered.");
}

QStringList LineWords::details(const LineEvent& event) const {
    const QString at = timeOfDay(event);
    if (event.kind == LineEvent::Kind::kUnasked || event.kind == LineEvent::Kind::kStream) {
        QStringList lines{tr("%1 %2: %3").arg(at, who(event), what(event)), answer(event)};
        if (!event.record.received.empty()) {
            lines.append(tr("Received: %1").arg(bytesText(event.record.received)));
        }
        return lines;
    }
    if (event.kind != LineEvent::Kind::kTransaction) {
        return {at + u' ' + who(event), event.text};
    }
    QStringList lines{tr("%1 %2: %3").arg(at, who(event), what(event))};
    if (const QString said = answer(event); !said.isEmpty()) {
        lines.append(tr("Answer: %1").arg(said));
    }
    lines.append(outcome(event));
    lines.append(tr("Waited %1 for its turn, %2 on the wire%3.")
                     .arg(spanText(event.waited()), spanText(event.onWire()),
                          event.record.video_paused ? tr(", video paused meanwhile") : QString()));
    lines.append(tr("Sent: %1").arg(bytesText(event.record.sent)));
    lines.append(tr("Received: %1").arg(event.record.received.empty() ? tr("nothing") : bytesText(event.record.received)));
    return lines;
}

}  // namespace pmts::app
