#include "probe_verdict.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace pmts::app {

using instrument::LineEvidence;
using instrument::LineSymptom;
using instrument::ProbedPort;

namespace {

constexpr int kUsualMark = '>';

QString tr(const char* text) { return QCoreApplication::translate("ProbePresenter", text); }

QString markSentence(const LineEvidence& evidence) {
    if (evidence.label_79 == 0 || (!evidence.label_79 && !evidence.end_mark)) {
        return tr("Its answers have no end mark: set label 79 = 62, or each answer waits for silence.");
    }
    if (evidence.label_79 && *evidence.label_79 != kUsualMark) {
        return tr("Its end mark is label 79 = %1; PMTS lives with it, 62 is usual.").arg(*evidence.label_79);
    }
    return {};
}

StatusItem foundItem(const ProbedPort& port) {
    if (port.evidence.symptom == LineSymptom::kBusStream) {
        return {.state = DeviceState::kGood,
                .text = tr("The bus under the panel is on %1 at %2.").arg(port.line.port_name, port.line.lineText()),
                .details = tr("Its angles come by themselves; everything else is a routine of the instruction table.")};
    }
    QStringList notes;
    if (port.evidence.symptom == LineSymptom::kUnasked) {
        notes.append(tr("It sends by itself: set its output to Request (menu 4 1)."));
    }
    if (port.evidence.echoes) {
        notes.append(tr("What PMTS sends comes back first: switch the adapter's echo off."));
    }
    if (const QString mark = markSentence(port.evidence); !mark.isEmpty() && port.evidence.symptom == LineSymptom::kAnswer) {
        notes.append(mark);
    }
    return {.state = notes.isEmpty() ? DeviceState::kGood : DeviceState::kWarning,
            .text = tr("An instrument answers on %1 at %2.").arg(port.line.port_name, port.line.lineText()),
            .details = notes.join(u' ')};
}

StatusItem troubleItem(const ProbedPort& port) {
    const QString& name = port.line.port_name;
    if (port.trouble) {
        return {.state = DeviceState::kFailed, .text = port.trouble->happened, .details = port.trouble->remedy};
    }
    switch (port.evidence.symptom) {
        case LineSymptom::kModem:
            return {.state = DeviceState::kFailed, .text = tr("A modem answers on %1.").arg(name),
                    .details = tr("Choose the port of the instrument.")};
        case LineSymptom::kOtherDevice:
            return {.state = DeviceState::kFailed,
                    .text = tr("Another device talks on %1: \"%2\".")
                                .arg(name, QString::fromLatin1(port.heard.data(), static_cast<qsizetype>(port.heard.size()))
                                               .simplified()
                                               .left(30)),
                    .details = tr("Choose the port of the instrument.")};
        case LineSymptom::kGarbled:
            return {.state = DeviceState::kFailed,
                    .text = tr("Bytes come on %1, but no setting that was tried makes text of them.").arg(name),
                    .details = tr("Set label 78 = 1.8.0.9600 on the instrument; a loose cable or wrong levels do this too.")};
        case LineSymptom::kEcho:
            return {.state = DeviceState::kFailed, .text = tr("On %1 only what PMTS sends comes back.").arg(name),
                    .details = tr("The cable joins its two data wires, or the adapter echoes and the instrument is off.")};
        default: break;
    }
    return {.state = DeviceState::kFailed, .text = tr("No byte comes on %1 at any setting.").arg(name),
            .details = tr("Switch the instrument on and choose its serial interface (menu 4 1); check the plug at its foot; "
                          "a cable with crossed data wires is silent too.")};
}

}  // namespace

StatusItem probeVerdict(const instrument::ProbeOutcome& outcome) {
    if (outcome.found) {
        return foundItem(*outcome.found);
    }
    if (outcome.ports.empty()) {
        return {.state = DeviceState::kWarning, .text = tr("There is no port to look at."),
                .details = tr("Plug the adapter in, then press Look again.")};
    }
    const auto telling = std::ranges::max_element(outcome.ports, {}, [](const ProbedPort& port) {
        return std::pair(port.evidence.symptom, !port.trouble.has_value());
    });
    return troubleItem(*telling);
}

}  // namespace pmts::app
