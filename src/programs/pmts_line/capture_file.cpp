#include "capture_file.hpp"

#include <QFile>
#include <QRegularExpression>
#include <cpl_vsi.h>

#include <memory>

namespace pmts::line {
namespace {

using protocol::CaptureFormat;
using protocol::LineCapture;

/// A file inside an archive, through GDAL's file system; absent when there is none of that name.
std::optional<QByteArray> archived(const QString& archive, const QString& name) {
    const QByteArray path = QStringLiteral("/vsizip/{%1}/%2").arg(archive, name).toUtf8();
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(path.constData(), "rb"), &VSIFCloseL);
    if (!file) {
        return std::nullopt;
    }
    constexpr qsizetype kBlock = 1 << 20;
    QByteArray bytes;
    for (std::size_t got = 1; got > 0;) {
        const qsizetype size = bytes.size();
        bytes.resize(size + kBlock);
        got = VSIFReadL(bytes.data() + size, 1, kBlock, file.get());
        bytes.resize(size + static_cast<qsizetype>(got));
    }
    return bytes;
}

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

core::Result<LineCapture> readSession(const QString& path, std::optional<double> samples_per_s) {
    const auto metadata = archived(path, QStringLiteral("metadata"));
    if (!metadata) {
        return core::fail(core::ErrorKind::kBadInput, QStringLiteral("%1 is no sigrok session.").arg(path),
                          QStringLiteral("Save the session again, or export it as CSV or VCD."));
    }
    const QString base = entry(*metadata, "capturefile");
    const int unit_size = std::max(1, entry(*metadata, "unitsize").toInt());
    QByteArray samples;
    for (int chunk = 1;; ++chunk) {
        const auto part = archived(path, QStringLiteral("%1-%2").arg(base).arg(chunk));
        if (!part) {
            break;
        }
        samples += *part;
    }
    if (samples.isEmpty()) {
        samples = archived(path, base).value_or(QByteArray());  // sessions of version 1 have one chunk without a number
    }
    LineCapture capture = protocol::captureFromSamples({samples.constData(), static_cast<std::size_t>(samples.size())},
                                                       rateFrom(entry(*metadata, "samplerate")), unit_size);
    capture.samples_per_s = samples_per_s ? samples_per_s : capture.samples_per_s;
    for (int line = 1; line <= capture.lines; ++line) {
        capture.names << entry(*metadata, qPrintable(QStringLiteral("probe%1").arg(line)));
    }
    return capture;
}

core::Result<LineCapture> parsed(const QByteArray& bytes, CaptureFormat format, std::optional<double> samples_per_s) {
    const std::string_view view(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    switch (format) {
        case CaptureFormat::kRunText:
            return protocol::captureFromRunText(view);
        case CaptureFormat::kCsv:
            return protocol::captureFromCsv(view);
        case CaptureFormat::kVcd:
            return protocol::captureFromVcd(view);
        case CaptureFormat::kSamples:
            break;
    }
    return protocol::captureFromSamples(view, samples_per_s);
}

}  // namespace

core::Result<LineCapture> readCapture(const QString& path, std::optional<CaptureFormat> format,
                                      std::optional<double> samples_per_s) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile, QStringLiteral("%1 cannot be read.").arg(path),
                          QStringLiteral("Check its name and your permission to read it."), file.errorString());
    }
    const QByteArray bytes = file.readAll();
    if (!format && bytes.startsWith("PK")) {
        return readSession(path, samples_per_s);
    }
    const std::string_view view(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    auto capture = parsed(bytes, format.value_or(protocol::guessCaptureFormat(view)), samples_per_s);
    if (capture && samples_per_s) {
        capture->samples_per_s = samples_per_s;
    }
    return capture;
}

}  // namespace pmts::line
