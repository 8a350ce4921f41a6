#include "pmts/blackbox/recording.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace pmts::blackbox {
namespace {

QString say(const char* text) { return QCoreApplication::translate("BlackBox", text); }

}  // namespace

core::Result<std::shared_ptr<const Recording>> Recording::open(const QString& path) {
    std::shared_ptr<Recording> recording(new Recording(path));
    QFile& file = recording->file_;
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile, say("The black box file “%1” cannot be read.").arg(path),
                          say("Check that the file exists and may be read."), file.errorString());
    }
    const uchar* const mapped = file.size() > 0 ? file.map(0, file.size()) : nullptr;
    if (mapped != nullptr) {
        recording->bytes_ = {reinterpret_cast<const char*>(mapped), static_cast<std::size_t>(file.size())};
        recording->findEntries();
    }
    if (recording->entries_.empty()) {
        return core::fail(core::ErrorKind::kFile, say("“%1” holds no record of a black box.").arg(path),
                          say("Choose a file that ends in .pmtsbox."));
    }
    return std::shared_ptr<const Recording>(std::move(recording));
}

/// From each place where no whole record begins, the next marker is looked for.
void Recording::findEntries() {
    constexpr std::string_view kFirstOfMarker = "\xB1";
    std::size_t at = bytes_.starts_with(kFileHead) ? kFileHead.size() : 0;
    while (at < bytes_.size()) {
        const std::string_view rest = bytes_.substr(at);
        const auto head = headAt(rest);
        if (head && isWhole(rest, *head)) {
            entries_.push_back({.kind = head->kind, .at = head->at, .offset = static_cast<qint64>(at), .body_size = head->body_size});
            at += kRecordFrame + head->body_size;
            continue;
        }
        const std::size_t next = std::min(bytes_.find(kFirstOfMarker, at + 1), bytes_.size());
        const auto skipped = static_cast<qint64>(next - at);
        if (!damages_.empty() && damages_.back().offset + damages_.back().size == static_cast<qint64>(at)) {
            damages_.back().size += skipped;
        } else {
            damages_.push_back({.offset = static_cast<qint64>(at), .size = skipped});
        }
        at = next;
    }
}

QByteArray Recording::bodyBytes(const Entry& entry) const {
    return {bytes_.data() + entry.offset + static_cast<qint64>(kHeadSize), static_cast<qsizetype>(entry.body_size)};
}

QStringList recordingsIn(const QString& folder) {
    QStringList paths;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.pmtsbox")}, QDir::Files, QDir::Name)) {
        paths.append(dir.filePath(name));
    }
    return paths;
}

QString nextRecordingName(const QStringList& present, const QDateTime& utc) {
    static const QRegularExpression kOurs(QStringLiteral(R"(^pmts-(\d{8}T\d{6})Z-(\d{4})\.pmtsbox$)"));
    constexpr int kHighestNumber = 9999;
    const QString time_format = QStringLiteral("yyyyMMdd'T'HHmmss");
    QString time = utc.toUTC().toString(time_format);
    int number = 0;
    for (const QString& path : present) {
        const auto name = kOurs.match(QFileInfo(path).fileName());
        if (name.hasMatch() && name.captured(1) >= time) {
            number = name.captured(1) == time ? std::max(number, name.captured(2).toInt() + 1) : name.captured(2).toInt() + 1;
            time = name.captured(1);
        }
    }
    if (number > kHighestNumber) {
        number = 0;
        time = QDateTime::fromString(time, time_format).addSecs(1).toString(time_format);
    }
    return QStringLiteral("pmts-%1Z-%2.pmtsbox").arg(time).arg(number, 4, 10, QChar(u'0'));
}

}  // namespace pmts::blackbox
