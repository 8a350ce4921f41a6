#include "pmts/app/line/line_recording.hpp"

#include "line_sessions.hpp"
#include "pmts/job/archive.hpp"
#include "pmts/protocol/line_talk.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include <cmath>

namespace pmts::app {
namespace {

using protocol::CaptureFormat;
using protocol::LineCapture;
using protocol::Progress;

constexpr qint64 kMostBytes = qint64{2} << 30;
constexpr qint64 kMostMetadata = qint64{1} << 20;
constexpr double kReadingShare = 0.1;  ///< of the work on a recording: decoding is longer

QString say(const char* text) { return QCoreApplication::translate("LineRecording", text); }

QString entry(const QByteArray& metadata, const char* name) {
    const QRegularExpression pattern(QStringLiteral("^\\s*%1\\s*=\\s*(.+?)\\s*$").arg(QLatin1String(name)),
                                     QRegularExpression::MultilineOption);
    return pattern.match(QString::fromUtf8(metadata)).captured(1);
}

core::Result<QByteArray> sigrokSamples(const QString& path, const QByteArray& metadata, const Progress& progress) {
    const QString base = entry(metadata, "capturefile");
    const auto wanted = [&progress] { return !progress || progress(0.0); };
    QByteArray samples;
    for (int chunk = 1; samples.size() < kMostBytes; ++chunk) {
        const auto part = job::archivedFile(path, QStringLiteral("%1-%2").arg(base).arg(chunk), kMostBytes - samples.size(), wanted);
        if (!wanted()) {
            return core::cancelled();
        }
        if (!part) {
            break;
        }
        samples += *part;
    }
    if (samples.isEmpty()) {
        // version 1: one chunk without a number
        samples = job::archivedFile(path, base, kMostBytes, wanted).value_or(QByteArray());
    }
    return samples;
}

core::Result<LineRecording> readSigrok(const QString& path, const Progress& progress) {
    const auto metadata = job::archivedFile(path, QStringLiteral("metadata"), kMostMetadata);
    if (!metadata) {
        return core::fail(core::ErrorKind::kBadInput, say("%1 is no sigrok session.").arg(QFileInfo(path).fileName()),
                          say("Save the session again, or export it as CSV or VCD."));
    }
    const auto samples = sigrokSamples(path, *metadata, progress);
    PMTS_TRY(samples);
    const int unit_size = std::max(1, entry(*metadata, "unitsize").toInt());
    LineRecording recording;
    recording.capture = protocol::captureFromSamples({samples->constData(), static_cast<std::size_t>(samples->size())},
                                                     sampleRateFrom(entry(*metadata, "samplerate")), unit_size, progress);
    if (samples->size() >= kMostBytes) {
        recording.capture.doubts.push_back({recording.capture.runs.size(), say("The session is larger than 2 GB; what comes after is left out."), false});
    }
    for (int line = 1; line <= recording.capture.lines; ++line) {
        recording.capture.names << entry(*metadata, qPrintable(QStringLiteral("probe%1").arg(line)));
    }
    return recording;
}

core::Result<LineRecording> parsed(std::string_view bytes, CaptureFormat format, std::optional<double> samples_per_s,
                                   const Progress& progress) {
    LineRecording recording;
    if (format == CaptureFormat::kBytes) {
        recording.said = protocol::charactersOf(bytes);
        return recording;
    }
    auto capture = format == CaptureFormat::kRunText ? protocol::captureFromRunText(bytes, progress)
                   : format == CaptureFormat::kCsv   ? protocol::captureFromCsv(bytes, progress)
                   : format == CaptureFormat::kVcd
                       ? protocol::captureFromVcd(bytes, progress)
                       : core::Result<LineCapture>(protocol::captureFromSamples(bytes, samples_per_s, 1, progress));
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
    if (!format.has_value() && isBlackBox(bytes.view())) {
        format = CaptureFormat::kSession;
    }
    format = format.value_or(protocol::guessCaptureFormat(bytes.view()));
    if (format != CaptureFormat::kSession) {
        return parsed(bytes.view(), *format, samples_per_s, progress);
    }
    return isBlackBox(bytes.view()) ? readBlackBox(file.fileName(), progress) : readSessions(file.fileName(), progress);
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

std::optional<double> sampleRateFrom(const QString& text) {
    static const QRegularExpression kPattern(QStringLiteral("^\\s*([0-9]+(?:[.,][0-9]*)?(?:e[0-9]+)?)\\s*([gmk]?)(?:hz|sa?/s)?\\s*$"),
                                             QRegularExpression::CaseInsensitiveOption);
    const auto match = kPattern.match(text);
    const QString unit = match.captured(2).toLower();  // a sample takes no thousand seconds: m is mega too
    const double scale = unit == u"g" ? 1e9 : unit == u"m" ? 1e6 : unit == u"k" ? 1e3 : 1.0;
    const double rate = match.captured(1).replace(u',', u'.').toDouble() * scale;
    return rate > 0.0 && std::isfinite(rate) ? std::optional(rate) : std::nullopt;
}

core::Result<LineRecording> readLineRecording(const QString& path, std::optional<CaptureFormat> format,
                                              std::optional<double> samples_per_s, const Progress& progress) {
    QFile file(path);
    (void)file.open(QIODevice::ReadOnly);
    PMTS_TRY(usable(file));
    bool stopped = false;
    const Progress reading = [&](double share) {
        stopped = stopped || (progress && !progress(kReadingShare * share));
        return !stopped;
    };
    auto recording = readOpen(file, format, samples_per_s, reading);
    if (stopped) {
        return core::cancelled();
    }
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
