// What the bench for unknown lines says about a recording, and what it keeps of it.
#include "pmts/app/line/line_bench_presenter.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/protocol/seen_routine.hpp"

#include <QDir>
#include <QFileInfo>

namespace pmts::app {
namespace {

constexpr int kMostRemarks = 5;  ///< commands that are named when they are left out

QString portText(protocol::PortKind port) {
    switch (port) {
        case protocol::PortKind::kNone:
            return LineBenchPresenter::tr("No line carries data.");
        case protocol::PortKind::kSerial:
            return LineBenchPresenter::tr("Few busy lines: a serial port.");
        case protocol::PortKind::kParallel:
            break;
    }
    return LineBenchPresenter::tr("Many busy lines: a parallel port; the busiest is decoded.");
}

QString baudText(const LineFindings& findings, const protocol::Framing& framing) {
    const auto baud = findings.baudOf(framing);
    return baud ? LineBenchPresenter::tr("%1 baud").arg(*baud, 0, 'f', 0)
                : LineBenchPresenter::tr("%1 samples for each bit").arg(framing.samples_per_bit, 0, 'f', 2);
}

/// Where a table comes from, for its head.
std::vector<std::string> remarksOf(const LineFindings& findings, const VariableNames& names, const QStringList& left_out) {
    QStringList remarks{LineBenchPresenter::tr("Seen in %1.").arg(QFileInfo(findings.recording->path).fileName())};
    for (const FoundLine& line : findings.lines) {
        if (line.is_decoded && line.framing) {
            remarks << LineBenchPresenter::tr("Line %1: %2, %3.")
                           .arg(line.activity.line)
                           .arg(baudText(findings, *line.framing), framingWords(*line.framing));
        }
    }
    for (auto name = names.all().constBegin(); name != names.all().constEnd(); ++name) {
        remarks << QStringLiteral("%1 = %2").arg(name.key(), name.value());
    }
    for (const QString& sentence : left_out) {
        remarks << LineBenchPresenter::tr("Left out: %1").arg(sentence);
    }
    std::vector<std::string> texts;
    for (const QString& remark : remarks) {
        texts.push_back(remark.toStdString());
    }
    return texts;
}

core::Result<void> written(const QString& path, const std::string& text) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    return writeWhole(path, QByteArray::fromStdString(text));
}

/// The text of the table, and what was left out of it. kBadInput when the name is none or there is nothing to save.
core::Result<std::pair<std::string, protocol::SeenRoutine>> tableOf(const LineFindings& findings, const VariableNames& names,
                                                                    const QString& routine) {
    const auto note = LineBenchPresenter::tr("Seen in a recording, unverified.").toStdString();
    auto seen = protocol::seenRoutine(findings.characters, routine.toStdString(), note);
    if (seen.routine.steps.empty() && names.all().isEmpty()) {
        return core::fail(core::ErrorKind::kBadInput, LineBenchPresenter::tr("The recording holds no commands, and no variable has a name."),
                          LineBenchPresenter::tr("Record both ways of the line, or name a variable first."));
    }
    const std::span<const protocol::TableRoutine> routines(&seen.routine, seen.routine.steps.empty() ? 0 : 1);
    const std::string text = protocol::instructionTableText(routines, remarksOf(findings, names, seen.left_out));
    if (const auto table = protocol::readInstructionTable(text); !table.problems.empty()) {
        return core::fail(core::ErrorKind::kBadInput, table.problems.front().sentence,
                          LineBenchPresenter::tr("Choose another name: letters, digits and _."));
    }
    return std::pair(text, std::move(seen));
}

}  // namespace

QString LineBenchPresenter::fileFilter() {
    return tr("Recordings (*.txt *.csv *.vcd *.sr *.bin *.raw *.log *.dat *.pmtsbox);;All files (*)");
}

QString LineBenchPresenter::summary() const {
    if (!findings_) {
        return tr("Import a recording: runs as text, CSV, VCD, a sigrok session, samples, a black box of PMTS, or bytes.");
    }
    QStringList sentences;
    if (findings_->recording->hasLevels()) {
        sentences << portText(findings_->port);
        if (findings_->repeats && *findings_->repeats > 1) {
            sentences << tr("Each bit was sampled about %1 times.").arg(*findings_->repeats);
        }
    }
    sentences << tr("%1 characters in %2 lines; %3").arg(findings_->characters.size()).arg(findings_->talk.size())
                     .arg(findings_->unsure == 0 ? tr("all are sure.") : tr("%1 are not sure and marked with ?.").arg(findings_->unsure));
    return sentences.join(u' ');
}

QStringList LineBenchPresenter::doubts() const {
    QStringList texts;
    if (findings_) {
        for (const protocol::CaptureDoubt& doubt : findings_->recording->capture.doubts) {
            texts << (doubt.mended ? tr("Mended: %1") : tr("In doubt: %1")).arg(doubt.what);
        }
    }
    return texts;
}

QString LineBenchPresenter::suggestedTablePath(const QString& routine) const {
    const QDir folder(QDir(data_folder_).filePath(QStringLiteral("instructions")));
    folder.mkpath(QStringLiteral("."));
    return folder.filePath(routine + QStringLiteral(".txt"));
}

void LineBenchPresenter::saveTable(const QString& path, const QString& routine) {
    if (!findings_) {
        return;
    }
    run(tr("Saving the instruction table"),
        [this, path, routine, findings = findings_, names = names_](const protocol::Progress&) -> Apply {
            auto table = tableOf(*findings, names, routine);
            const auto kept = table ? written(path, table->first) : core::Result<void>(tl::unexpected(table.error()));
            if (!kept) {
                return [this, error = kept.error()] { fail(error); };
            }
            return [this, path, seen = std::move(table->second)] {
                const auto steps = seen.routine.steps.size();
                const QString sentence = steps > 0 ? tr("Steps saved in %1: %2.").arg(path).arg(steps)
                                                   : tr("Names of variables saved in %1; the recording holds no commands.").arg(path);
                if (!seen.left_out.isEmpty()) {
                    messages_.warn(sentence + u' ' + tr("Commands left out: %1.").arg(seen.left_out.size()),
                                   seen.left_out.mid(0, kMostRemarks).join(u' '), MessageAction::kNone, QStringLiteral("line bench"));
                } else {
                    messages_.toast(sentence);
                }
                Q_EMIT saved(path);
            };
        });
}

}  // namespace pmts::app
