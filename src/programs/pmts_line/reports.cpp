#include "reports.hpp"

#include "pmts/app/line/talk_model.hpp"
#include "pmts/protocol/seen_routine.hpp"

#include <QFileInfo>

#include <algorithm>

namespace pmts::line {
namespace {

using namespace protocol;

constexpr std::size_t kShownAround = 40;  ///< characters from the place that was searched for

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

QString framingText(const app::LineFindings& findings, const app::FoundLine& line) {
    QString text = QStringLiteral("Line %1: %2, %3 samples for each bit")
                       .arg(line.activity.line)
                       .arg(app::framingWords(*line.framing))
                       .arg(line.framing->samples_per_bit, 0, 'f', 2);
    if (const auto baud = findings.baudOf(*line.framing)) {
        text += QStringLiteral(", %1 baud").arg(*baud, 0, 'f', 0);
    }
    if (const auto score = line.score()) {
        text += QStringLiteral(", score %1").arg(*score, 0, 'f', 2);
    }
    return text + QLatin1Char('\n');
}

/// With times: each line with its own; without: block by block, a CR within a block does not end the line.
QString talkText(const app::LineFindings& findings, const Request& request) {
    QString text;
    for (std::size_t i = 0; i < findings.talk.size(); ++i) {
        const TalkLine& line = findings.talk[i];
        const auto characters = std::span(findings.characters).subspan(line.first, line.count);
        if (request.times) {
            text += QStringLiteral("%1  %2  ")
                        .arg(app::sampleTimeText(characters.front().sample, findings.recording->samples_per_s), 16)
                        .arg(app::sideText(characters.front().side), -6);
        }
        text += QString::fromStdString(textOf(characters));
        const bool is_last = i + 1 == findings.talk.size();
        const bool goes_on = !is_last && characters.back().value == '\r' &&
                             findings.characters[findings.talk[i + 1].first].side == characters.back().side;
        text += request.times || !goes_on ? QStringLiteral("\n") : QString();
    }
    return request.hex ? text + QString::fromStdString(hexOf(findings.characters)) + QLatin1Char('\n') : text;
}

QString doubtText(const LineCapture& capture) {
    QString text;
    for (const CaptureDoubt& doubt : capture.doubts) {
        text += QStringLiteral("%1 run %2: %3\n").arg(doubt.mended ? u"Mended," : u"Doubt,").arg(doubt.run).arg(doubt.what);
    }
    return text;
}

/// The framing that was asked for on a line, or the best found one that fits what was asked for.
core::Result<app::LineChoices> choicesFor(const app::LineFindings& findings, const Request& request) {
    app::LineChoices choices;
    if (!findings.recording->hasLevels() || (!request.line && !request.form && !request.baud)) {
        return choices;
    }
    const int line = request.line.value_or(app::busiestLine(findings).value_or(0));
    for (const app::FoundLine& other : findings.lines) {
        choices[other.activity.line].is_decoded = other.activity.line == line;
    }
    const auto rate = findings.recording->samples_per_s;
    if (request.form && (request.baud || !rate)) {
        Framing given = *request.form;
        given.samples_per_bit = request.baud && rate ? *rate / *request.baud : 1.0;
        choices[line].framing = given;
        return choices;
    }
    const auto fits = [&](const FramingScore& score) {
        const bool form = !request.form || (score.framing.text() == request.form->text() &&
                                            score.framing.idle_high == request.form->idle_high);
        return form && (!request.baud || std::abs(score.baud / *request.baud - 1.0) < 0.04);
    };
    const auto found = findFraming(findings.recording->capture, line);
    const auto best = std::ranges::find_if(found, fits);
    if (best == found.end()) {
        return core::fail(core::ErrorKind::kUndefined, QStringLiteral("Line %1 says nothing that has this form.").arg(line),
                          QStringLiteral("Try another line, or give --form and --baud."));
    }
    choices[line].framing = best->framing;
    return choices;
}

QString pinReport(const app::LineFindings& findings) {
    if (!findings.recording->hasLevels()) {
        return QStringLiteral("This file holds bytes: it has no pins.\n");
    }
    const LineCapture& capture = findings.recording->capture;
    QString text = QStringLiteral("line  use        changes    high  name\n");
    for (const app::FoundLine& line : findings.lines) {
        text += QStringLiteral("%1  %2 %3  %4 %  %5\n")
                    .arg(line.activity.line, 4)
                    .arg(useText(line.activity.use), -9)
                    .arg(line.activity.changes, 8)
                    .arg(100.0 * line.activity.high_share, 4, 'f', 0)
                    .arg(capture.names.value(line.activity.line));
    }
    text += portText(findings.port);
    if (findings.repeats) {
        text += QStringLiteral("Each bit was sampled about %1 times.\n").arg(*findings.repeats);
    }
    return text + doubtText(capture);
}

QString decodeReport(const app::LineFindings& findings, const Request& request) {
    QString text;
    for (const app::FoundLine& line : findings.lines) {
        text += line.is_decoded && line.framing ? framingText(findings, line) : QString();
    }
    text += talkText(findings, request);
    text += QStringLiteral("%1 characters, %2 not sure\n").arg(findings.characters.size()).arg(findings.unsure);
    return text + doubtText(findings.recording->capture);
}

core::Result<QString> correlationReport(const app::LineFindings& findings, const Request& request) {
    const auto matches = correlated(request.panel, findings.values);
    PMTS_TRY(matches);
    if (matches->empty()) {
        return QStringLiteral("None of %1 values of the stream fits %2.\n").arg(findings.values.size()).arg(request.panel);
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

core::Result<QString> searchReport(const app::LineFindings& findings, const Request& request) {
    const auto wanted = searchedBytes(request.wanted.toLatin1().toStdString());
    PMTS_TRY(wanted);
    QString text;
    std::size_t places = 0;
    for (std::size_t at = findings.bytes.find(*wanted); at != std::string::npos; at = findings.bytes.find(*wanted, at + 1)) {
        const auto characters = std::span(findings.characters).subspan(at, std::min(kShownAround, findings.characters.size() - at));
        text += QStringLiteral("%1  %2\n")
                    .arg(app::sampleTimeText(characters.front().sample, findings.recording->samples_per_s), 16)
                    .arg(QString::fromStdString(textOf(characters)));
        ++places;
    }
    return text + QStringLiteral("“%1” is at %2 places.\n").arg(request.wanted).arg(places);
}

core::Result<QString> tableReport(const app::LineFindings& findings, const Request& request) {
    const auto seen = seenRoutine(findings.characters, request.routine.toStdString(), "Seen in a recording, unverified.");
    std::vector<std::string> remarks{"Seen in " + QFileInfo(request.path).fileName().toStdString() + '.'};
    for (const QString& sentence : seen.left_out) {
        remarks.push_back("Left out: " + sentence.toStdString());
    }
    if (seen.routine.steps.empty()) {
        return core::fail(core::ErrorKind::kUndefined, QStringLiteral("The recording holds no commands that can be a routine."),
                          QStringLiteral("Record both ways of the line."));
    }
    const std::string text = instructionTableText({&seen.routine, 1}, remarks);
    if (const auto table = readInstructionTable(text); !table.problems.empty()) {
        return core::fail(core::ErrorKind::kBadInput, table.problems.front().sentence, QStringLiteral("Give another --name."));
    }
    return QString::fromStdString(text);
}

}  // namespace

core::Result<QString> reportOf(const Request& request, const Progress& progress) {
    auto recording = app::readLineRecording(request.path, request.format, request.samples_per_s, progress);
    PMTS_TRY(recording);
    auto examined = app::examined(std::move(*recording), progress);
    PMTS_TRY(examined);
    if (request.command == Command::kPins) {
        return pinReport(*examined);
    }
    const auto choices = choicesFor(*examined, request);
    PMTS_TRY(choices);
    const auto findings = app::decoded(std::move(*examined), *choices, progress);
    PMTS_TRY(findings);
    switch (request.command) {
        case Command::kCorrelate:
            return correlationReport(*findings, request);
        case Command::kSearch:
            return searchReport(*findings, request);
        case Command::kTable:
            return tableReport(*findings, request);
        default:
            return decodeReport(*findings, request);
    }
}

}  // namespace pmts::line
