#include "timeline_csv.hpp"

#include "parts/plot_widget.hpp"

namespace pmts::gui {
namespace {

constexpr std::size_t kToldEach = 256;  ///< rows between two looks at Cancel

QString milliseconds(core::Duration span) {
    return QString::number(std::chrono::duration<double, std::milli>(span).count(), 'f', 3);
}

/// For programs: not translated.
QString kindName(app::LineEvent::Kind kind) {
    using Kind = app::LineEvent::Kind;
    switch (kind) {
        case Kind::kTransaction: return QStringLiteral("transaction");
        case Kind::kControl: return QStringLiteral("control");
        case Kind::kGap: return QStringLiteral("picture gap");
        case Kind::kConnection: return QStringLiteral("connection");
        case Kind::kUnasked: return QStringLiteral("unasked");
        case Kind::kStream: return QStringLiteral("stream");
        case Kind::kMissing: return QStringLiteral("missing");
        case Kind::kAir: return QStringLiteral("air");
    }
    return {};
}

QString rowOf(const app::LineEvent& event, const app::LineWords& words) {
    const QStringList cells{words.utcOf(event.sent).toUTC().toString(Qt::ISODateWithMs),
                            csvCell(words.who(event)),
                            csvCell(words.what(event)),
                            csvCell(words.answer(event)),
                            milliseconds(event.waited()),
                            milliseconds(event.onWire()),
                            event.record.video_paused ? QStringLiteral("1") : QStringLiteral("0"),
                            csvCell(words.outcome(event)),
                            csvCell(app::bytesText(event.record.sent)),
                            csvCell(app::bytesText(event.record.received)),
                            kindName(event.kind)};
    return cells.join(u',') + u'\n';
}

}  // namespace

QByteArray timelineCsv(const std::vector<app::LineEvent>& events, const app::LineWords& words,
                       const app::FileSaving::Progress& progress) {
    QByteArray text = "utc,who,what,answer,waited_ms,on_wire_ms,video_paused,outcome,sent,received,kind\n";
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (i % kToldEach == 0 && !progress(static_cast<double>(i) / static_cast<double>(events.size()))) {
            break;
        }
        text += rowOf(events[i], words).toUtf8();
    }
    return text;
}

}  // namespace pmts::gui
