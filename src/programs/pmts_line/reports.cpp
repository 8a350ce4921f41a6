#include "reports.hpp"

#include "pmts/protocol/panel_correlation.hpp"

#include <algorithm>

namespace pmts::line {
namespace {

using namespace protocol;

QString useText(LineUse use) {
    switch (use) {
        case LineUse::kConstant:
            return QStringLiteral("constant");
        case LineUse::kSwitching:
            return QStringLiteral("switching");
        case LineUse::kData:
            break;
    }
    return QStringLiteral("data");
}

QString portText(PortKind kind) {
    switch (kind) {
        case PortKind::kNone:
            return QStringLiteral("No line carries data.\n");
        case PortKind::kSerial:
            return QStringLiteral("Few busy lines: a serial port.\n");
        case PortKind::kParallel:
            break;
    }
    return QStringLiteral("Many busy lines: a parallel port.\n");
}

QString framingText(const FramingScore& found) {
    const Framing& framing = found.framing;
    QString text = QStringLiteral("Line %1: %2, %3 bit first, rests %4, %5 samples for each bit")
                       .arg(framing.line)
                       .arg(framing.text(), framing.least_significant_first ? QStringLiteral("least") : QStringLiteral("most"),
                            framing.idle_high ? QStringLiteral("high") : QStringLiteral("low"))
                       .arg(framing.samples_per_bit, 0, 'f', 2);
    if (found.baud > 0.0) {
        text += QStringLiteral(", %1 baud").arg(found.baud, 0, 'f', 0);
    }
    return text + QStringLiteral(", score %1\n").arg(found.score, 0, 'f', 2);
}

QString hexOf(const std::vector<DecodedCharacter>& characters) {
    QString text;
    for (const DecodedCharacter& character : characters) {
        text += QStringLiteral("%1%2 ").arg(character.value, 2, 16, QLatin1Char('0')).arg(character.isSure() ? u"" : u"?");
    }
    return text.trimmed().toUpper() + QLatin1Char('\n');
}

/// Each block on a line of its own.
QString linesOf(const std::vector<DecodedCharacter>& characters) {
    QString text = QString::fromStdString(textOf(characters));
    for (const char* end : {"<CR><LF>", "<EOT>"}) {
        const QString mark = QString::fromLatin1(end);
        text.replace(mark, mark + QLatin1Char('\n'));
    }
    return text.endsWith(QLatin1Char('\n')) ? text : text + QLatin1Char('\n');
}

QString doubtText(const LineCapture& capture) {
    QString text;
    for (const CaptureDoubt& doubt : capture.doubts) {
        text += QStringLiteral("%1 run %2: %3\n").arg(doubt.mended ? u"Mended," : u"Doubt,").arg(doubt.run).arg(doubt.what);
    }
    return text;
}

}  // namespace

core::Result<int> busiestLine(const LineCapture& capture) {
    const auto lines = lineActivities(capture);
    const auto busiest = std::ranges::max_element(lines, {}, [](const LineActivity& line) {
        return std::pair(line.use == LineUse::kData, line.changes);
    });
    if (busiest == lines.end() || busiest->changes == 0) {
        return core::fail(core::ErrorKind::kUndefined, QStringLiteral("No line of this capture moves."),
                          QStringLiteral("Check the probes, then capture again."));
    }
    return busiest->line;
}

core::Result<FramingScore> framingFor(const LineCapture& capture, const Request& request) {
    const auto line = request.line ? core::Result<int>(*request.line) : busiestLine(capture);
    PMTS_TRY(line);
    if (request.form && (request.baud || !capture.samples_per_s)) {
        FramingScore given{.framing = *request.form};
        given.framing.line = *line;
        given.baud = request.baud.value_or(0.0);
        if (request.baud && capture.samples_per_s) {
            given.framing.samples_per_bit = *capture.samples_per_s / *request.baud;
        }
        return given;
    }
    const auto found = findFraming(capture, *line);
    const auto fits = [&](const FramingScore& score) {
        const bool form = !request.form || (score.framing.text() == request.form->text() &&
                                            score.framing.idle_high == request.form->idle_high);
        return form && (!request.baud || std::abs(score.baud / *request.baud - 1.0) < 0.04);
    };
    const auto best = std::ranges::find_if(found, fits);
    if (best == found.end()) {
        return core::fail(core::ErrorKind::kUndefined, QStringLiteral("Line %1 says nothing that has this form.").arg(*line),
                          QStringLiteral("Try another line, or give --form and --baud."));
    }
    return *best;
}

QString pinReport(const LineCapture& capture) {
    QString text = QStringLiteral("line  use        changes    high  name\n");
    const auto lines = lineActivities(capture);
    for (const LineActivity& line : lines) {
        text += QStringLiteral("%1  %2 %3  %4 %  %5\n")
                    .arg(line.line, 4)
                    .arg(useText(line.use), -9)
                    .arg(line.changes, 8)
                    .arg(100.0 * line.high_share, 4, 'f', 0)
                    .arg(capture.names.value(line.line));
    }
    return text + portText(portKind(lines)) + doubtText(capture);
}

core::Result<QString> decodeReport(const LineCapture& capture, const Request& request) {
    const auto framing = framingFor(capture, request);
    PMTS_TRY(framing);
    const auto characters = decodeLine(capture, framing->framing);
    const auto unsure = std::ranges::count_if(characters, [](const auto& c) { return !c.isSure(); });
    QString text = framingText(*framing) + linesOf(characters);
    if (request.hex) {
        text += hexOf(characters);
    }
    text += QStringLiteral("%1 characters, %2 not sure\n").arg(characters.size()).arg(unsure);
    return text + doubtText(capture);
}

core::Result<QString> correlationReport(const LineCapture& capture, const Request& request) {
    const auto framing = framingFor(capture, request);
    PMTS_TRY(framing);
    const auto values = streamValues(decodeLine(capture, framing->framing));
    const auto matches = correlated(request.panel, values);
    PMTS_TRY(matches);
    if (matches->empty()) {
        return QStringLiteral("None of %1 values of the stream fits %2.\n").arg(values.size()).arg(request.panel);
    }
    QString text = QStringLiteral("variable       value  shown         score  units\n");
    for (const PanelMatch& match : *matches) {
        text += QStringLiteral("%1,%2  %3  %4  %5  %6\n")
                    .arg(QLatin1Char(match.stream.unit))
                    .arg(match.stream.variable, -5)
                    .arg(match.stream.value, 10, 'f', 5)
                    .arg(match.shown, -12)
                    .arg(match.score, 5, 'f', 2)
                    .arg(match.units);
    }
    return text;
}

}  // namespace pmts::line
