#include "pmts/app/line/line_findings.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {
namespace {

using protocol::LineUse;
using protocol::Progress;

constexpr double kPause_bits = 30.0;           ///< between two lines of a dialogue
constexpr double kSessionPause_samples = 1e5;  ///< 0.1 s in a session log
constexpr double kSamePace = 1e-6;
constexpr double kExamined = 0.1;  ///< of the work: what comes after the file is read

QString say(const char* text) { return QCoreApplication::translate("LineFindings", text); }

bool goesOn(const Progress& progress, double share) { return !progress || progress(share); }

/// Lines to look at when nobody has chosen: those of a serial port, the busiest of a parallel one.
std::vector<int> usualLines(const LineFindings& findings) {
    std::vector<int> lines;
    for (const FoundLine& line : findings.lines) {
        if (line.activity.use == LineUse::kData && findings.port == protocol::PortKind::kSerial) {
            lines.push_back(line.activity.line);
        }
    }
    if (const auto busiest = busiestLine(findings); lines.empty() && busiest) {
        lines.push_back(*busiest);
    }
    return lines;
}

LineChoice choiceOf(const LineChoices& choices, int line) {
    const auto found = choices.find(line);
    return found == choices.end() ? LineChoice() : found->second;
}

/// Takes the choices into the lines; searches framings where one is wanted and none was searched for.
void prepare(LineFindings& findings, const LineChoices& choices) {
    const std::vector<int> usual = usualLines(findings);
    for (FoundLine& line : findings.lines) {
        const LineChoice choice = choiceOf(choices, line.activity.line);
        const bool is_usual = std::ranges::find(usual, line.activity.line) != usual.end();
        line.is_decoded = choice.is_decoded.value_or(is_usual || choice.framing.has_value());
        if (line.is_decoded && !choice.framing && line.scores.empty()) {
            line.scores = protocol::findFraming(findings.recording->capture, line.activity.line);
        }
        line.framing = choice.framing;
        if (!line.framing && !line.scores.empty()) {
            line.framing = line.scores.front().framing;
        }
        if (line.framing) {
            line.framing->line = line.activity.line;
        }
        line.characters = line.unsure = 0;
    }
}

std::vector<protocol::DecodedCharacter> charactersOf(FoundLine& line, const LineFindings& findings,
                                                     const LineChoice& choice, const Progress& progress) {
    auto characters = protocol::decodeLine(findings.recording->capture, *line.framing, progress);
    line.side = choice.side.value_or(protocol::likelySide(characters));
    line.characters = characters.size();
    for (protocol::DecodedCharacter& character : characters) {
        character.side = line.side;
        line.unsure += character.isSure() ? 0U : 1U;
    }
    return characters;
}

/// Of one line, or of the instrument's side: the other side may speak in between.
void addValues(LineFindings& findings, std::span<const protocol::DecodedCharacter> characters) {
    const auto values = protocol::streamValues(characters);
    findings.values.insert(findings.values.end(), values.begin(), values.end());
}

std::vector<SeenVariable> variablesOf(const std::vector<protocol::StreamValue>& values) {
    std::map<std::pair<char, int>, SeenVariable> seen;
    for (const protocol::StreamValue& value : values) {
        auto& variable = seen[{value.unit, value.variable}];
        variable = {.unit = value.unit, .variable = value.variable, .times = variable.times + 1, .last = value.value};
    }
    std::vector<SeenVariable> variables;
    for (const auto& [key, variable] : seen) {
        variables.push_back(variable);
    }
    return variables;
}

core::Result<double> decodeLevels(LineFindings& findings, const LineChoices& choices, const Progress& progress) {
    prepare(findings, choices);
    double pause = 0.0;
    bool stopped = false;
    const Progress watched = [&](double share) { return !(stopped = stopped || !goesOn(progress, share)); };
    for (FoundLine& line : findings.lines) {
        if (!line.is_decoded || !line.framing) {
            continue;
        }
        auto characters = charactersOf(line, findings, choiceOf(choices, line.activity.line), watched);
        addValues(findings, characters);
        pause = std::max(pause, kPause_bits * line.framing->samples_per_bit);
        findings.characters =
            findings.characters.empty() ? std::move(characters) : protocol::mergedTalk(findings.characters, characters);
    }
    if (stopped) {
        return core::cancelled();
    }
    return pause;
}

}  // namespace

std::optional<double> FoundLine::score() const {
    const auto same = [this](const protocol::FramingScore& score) {
        return framing && score.framing.text() == framing->text() && score.framing.idle_high == framing->idle_high &&
               score.framing.least_significant_first == framing->least_significant_first &&
               std::abs(score.framing.samples_per_bit / framing->samples_per_bit - 1.0) < kSamePace;
    };
    const auto found = std::ranges::find_if(scores, same);
    return found == scores.end() ? std::nullopt : std::optional(found->score);
}

std::uint64_t LineFindings::samples() const {
    return signal ? signal->samples() : characters.empty() ? 0 : characters.back().sample + 1;
}

std::optional<double> LineFindings::baudOf(const protocol::Framing& framing) const {
    const auto rate = recording ? recording->samples_per_s : std::nullopt;
    return rate ? std::optional(*rate / framing.samples_per_bit) : std::nullopt;
}

std::optional<int> busiestLine(const LineFindings& findings) {
    const auto busiest = std::ranges::max_element(findings.lines, {}, [](const FoundLine& line) {
        return std::pair(line.activity.use == LineUse::kData, line.activity.changes);
    });
    const bool moves = busiest != findings.lines.end() && busiest->activity.changes > 0;
    return moves ? std::optional(busiest->activity.line) : std::nullopt;
}

core::Result<LineFindings> examined(LineRecording recording, const Progress& progress) {
    LineFindings findings;
    findings.recording = std::make_shared<const LineRecording>(std::move(recording));
    if (!findings.recording->hasLevels()) {
        return findings;
    }
    const protocol::LineCapture& capture = findings.recording->capture;
    const auto wanted = [&progress] { return goesOn(progress, kExamined); };
    if (!wanted()) {
        return core::cancelled();
    }
    const auto activities = protocol::lineActivities(capture);
    for (const protocol::LineActivity& activity : activities) {
        findings.lines.push_back({.activity = activity, .scores = {}, .framing = {}});
    }
    findings.port = protocol::portKind(activities);
    if (!wanted()) {
        return core::cancelled();
    }
    findings.repeats = protocol::repeatCount(capture);
    if (!wanted()) {
        return core::cancelled();
    }
    findings.signal = std::make_shared<const SignalIndex>(capture);
    for (const int line : usualLines(findings)) {
        if (!wanted()) {
            return core::cancelled();
        }
        findings.lines[static_cast<std::size_t>(line)].scores = protocol::findFraming(capture, line);
    }
    return findings;
}

core::Result<LineFindings> decoded(LineFindings findings, const LineChoices& choices, const Progress& progress) {
    findings.characters.clear();
    findings.values.clear();
    double pause = kSessionPause_samples;
    if (findings.recording->hasLevels()) {
        if (!busiestLine(findings)) {
            return core::fail(core::ErrorKind::kUndefined, say("No line of this capture moves."),
                              say("Check the probes, then capture again."));
        }
        const auto levels = decodeLevels(findings, choices, progress);
        PMTS_TRY(levels);
        pause = *levels;
    } else {
        findings.characters = findings.recording->said;
        std::vector<protocol::DecodedCharacter> said;
        std::ranges::copy_if(findings.characters, std::back_inserter(said),
                             [](const auto& c) { return c.side != protocol::TalkSide::kToInstrument; });
        addValues(findings, said);
    }
    if (!goesOn(progress, 1.0)) {
        return core::cancelled();
    }
    findings.talk = protocol::talkLines(findings.characters, pause);
    findings.variables = variablesOf(findings.values);
    findings.bytes.clear();
    findings.doubt_marks.clear();
    findings.bytes.reserve(findings.characters.size());
    findings.doubt_marks.reserve(findings.characters.size());
    findings.unsure = 0;
    for (const protocol::DecodedCharacter& character : findings.characters) {
        findings.bytes += static_cast<char>(character.value);
        findings.doubt_marks += character.isSure() ? ' ' : '?';
        findings.unsure += character.isSure() ? 0U : 1U;
    }
    return findings;
}

QString framingWords(const protocol::Framing& framing) {
    const QString order = framing.least_significant_first ? say("least significant bit first") : say("most significant bit first");
    return QStringLiteral("%1, %2, %3").arg(framing.text(), order, framing.idle_high ? say("rests high") : say("rests low"));
}

}  // namespace pmts::app
