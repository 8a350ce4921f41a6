#include "pmts/app/line_recording.hpp"

#include "pmts/job/archive.hpp"
#include "pmts/protocol/line_talk.hpp"
#include "pmts/transport/session_log.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace pmts::app {
namespace {

using protocol::CaptureFormat;
using protocol::LineCapture;
using protocol::Progress;

constexpr double kSessionUnits_per_s = 1e6;  ///< times of a session log are whole microseconds
constexpr qint64 kMostBytes = qint64{2} << 30;

QString say(const char* text) { return QCoreApplication::translate("LineRecording", text); }

QString entry(const QByteArray& metadata, const char* name) {
    const QRegularExpression pattern(QStringLiteral("^\\s*%1\\s*=\\s*(.+?)\\s*$").arg(QLatin1String(name)),
                                     QRegularExpression::MultilineOption);
    return pattern.match(QString::fromUtf8(metadata)).captured(1);
}

/// `1 MHz`, `500 kHz`, `115200`.
std::optional<double> rateFrom(const QString& text) {
    static const QRegularExpression kPattern(QStringLiteral("^([0-9.]+)\\s*([GMk]?)"));
    const auto match = kPattern.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const QString unit = match.captured(2);
    const double scale = unit == u"G" ? 1e9 : unit == u"M" ? 1e6 : unit == u"k" ? 1e3 : 1.0;
    return match.captured(1).toDouble() * scale;
}

core::Result<QByteArray> sigrokSamples(const QString& path, const QByteArray& metadata, const Progress& progress) {
    const QString base = entry(metadata, "capturefile");
    const auto wanted = [&progress] { return !progress || progress(0.0); };
    QByteArray samples;
    for (int chunk = 1; samples.size() <= kMostBytes; ++chunk) {
        const auto part = job::archivedFile(path, QStringLiteral("%1-%2").arg(base).arg(chunk), wanted);
        if (!wanted()) {
            return core::cancelled();
        }
        if (!part) {
            break;
        }
        samples += *part;
    }
    if (samples.isEmpty()) {
        samples = job::archivedFile(path, base, wanted).value_or(QByteArray());  // version 1: one chunk without a number
    }
    return samples;
}

core::Result<LineRecording> readSigrok(const QString& path, const Progress& progress) {
    const auto metadata = job::archivedFile(path, QStringLiteral("metadata"));
    if (!metadata) {
        return core::fail(core::ErrorKind::kBadInput, say("%1 is no sigrok session.").arg(QFileInfo(path).fileName()),
                          say("Save the session again, or export it as CSV or VCD."));
    }
    const auto samples = sigrokSamples(path, *metadata, progress);
    PMTS_TRY(samples);
    const int unit_size = std::max(1, entry(*metadata, "unitsize").toInt());
    LineRecording recording;
    recording.capture = protocol::captureFromSamples({samples->constData(), static_cast<std::size_t>(samples->size())},
                                                     rateFrom(entry(*metadata, "samplerate")), unit_size);
    for (int line = 1; line <= recording.capture.lines; ++line) {
        recording.capture.names << entry(*metadata, qPrintable(QStringLiteral("probe%1").arg(line)));
    }
    return recording;
}

/// Sessions one behind the other, a second between them.
core::Result<LineRecording> readSession(const QString& path) {
    const auto sessions = transport::readSessionLog(path);
    PMTS_TRY(sessions);
    LineRecording recording;
    recording.samples_per_s = kSessionUnits_per_s;
    std::uint64_t begin = 0, last = 0;
    for (const transport::Session& session : *sessions) {
        for (const transport::SessionEvent& event : session.events) {
            if (event.direction == transport::Direction::kLost) {
                continue;
            }
            const auto at = std::chrono::duration_cast<std::chrono::microseconds>(event.at).count();
            last = std::max(last, begin + static_cast<std::uint64_t>(std::max<std::int64_t>(0, at)));
            const auto side = event.direction == transport::Direction::kSent ? protocol::TalkSide::kToInstrument
                                                                             : protocol::TalkSide::kFromInstrument;
            const auto characters = protocol::charactersOf(event.bytes, side, last);
            recording.said.insert(recording.said.end(), characters.begin(), characters.end());
            last += event.bytes.size();
        }
        begin = last + static_cast<std::uint64_t>(kSessionUnits_per_s);
    }
    return recording;
}

core::Result<LineRecording> parsed(std::string_view bytes, CaptureFormat format, std::optional<double> samples_per_s) {
    LineRecording recording;
    if (format == CaptureFormat::kBytes) {
        recording.said = protocol::charactersOf(bytes);
        return recording;
    }
    auto capture = format == CaptureFormat::kRunText ? protocol::captureFromRunText(bytes)
                   : format == CaptureFormat::kCsv   ? protocol::captureFromCsv(bytes)
                   : format == CaptureFormat::kVcd
                       ? protocol::captureFromVcd(bytes)
                       : core::Result<LineCapture>(protocol::captureFromSamples(bytes, samples_per_s));
    PMTS_TRY(capture);
    recording.capture = std::move(*capture);
    return recording;
}

/// The bytes of a file without a copy of them where the system can.
class MappedFile {
public:
    explicit MappedFile(QFile& file) {
        if (const uchar* const mapped = file.map(0, file.size())) {
            view_ = {reinterpret_cast<const char*>(mapped), static_cast<std::size_t>(file.size())};
        } else {
            copy_ = file.readAll();
            view_ = {copy_.constData(), static_cast<std::size_t>(copy_.size())};
        }
    }
    [[nodiscard]] std::string_view view() const { return view_; }

private:
    QByteArray copy_;
    std::string_view view_;
};

core::Result<LineRecording> readOpen(QFile& file, std::optional<CaptureFormat>& format,
                                     std::optional<double> samples_per_s, const Progress& progress) {
    const MappedFile bytes(file);
    if (!format && bytes.view().starts_with("PK")) {
        format = CaptureFormat::kSamples;
        return readSigrok(file.fileName(), progress);
    }
    format = format.value_or(protocol::guessCaptureFormat(bytes.view()));
    return format == CaptureFormat::kSession ? readSession(file.fileName()) : parsed(bytes.view(), *format, samples_per_s);
}

core::Result<void> usable(const QFile& file) {
    const QString name = QFileInfo(file).fileName();
    if (!file.isOpen()) {
        return core::fail(core::ErrorKind::kFile, say("%1 cannot be read.").arg(file.fileName()),
                          say("Check its name and your permission to read it."), file.errorString());
    }
    if (file.size() > kMostBytes) {
        return core::fail(core::ErrorKind::kBadInput, say("%1 is larger than 2 GB.").arg(name), say("Cut it into parts."));
    }
    return {};
}

}  // namespace

core::Result<LineRecording> readLineRecording(const QString& path, std::optional<CaptureFormat> format,
                                              std::optional<double> samples_per_s, const Progress& progress) {
    QFile file(path);
    (void)file.open(QIODevice::ReadOnly);
    PMTS_TRY(usable(file));
    auto recording = readOpen(file, format, samples_per_s, progress);
    PMTS_TRY(recording);
    if (recording->capture.runs.empty() && recording->said.empty()) {
        return core::fail(core::ErrorKind::kBadInput, say("%1 is empty.").arg(QFileInfo(path).fileName()),
                          say("Record again, or choose another file."));
    }
    recording->path = path;
    recording->format = *format;
    recording->samples_per_s = recording->samples_per_s ? recording->samples_per_s : recording->capture.samples_per_s;
    if (samples_per_s && recording->hasLevels()) {
        recording->samples_per_s = recording->capture.samples_per_s = samples_per_s;
    }
    return recording;
}

}  // namespace pmts::app
