#include "pmts/app/desk/whole_file.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QSaveFile>

namespace pmts::app {
namespace {

QString say(const char* text) { return QCoreApplication::translate("WholeFile", text); }

}  // namespace

tl::unexpected<core::Error> cannotWrite(const QString& path, const QString& why) {
    return core::fail(core::ErrorKind::kFile, say("“%1” cannot be written: %2.").arg(QDir::toNativeSeparators(path), why),
                      say("Choose another folder or make room on the disk."));
}

core::Result<void> writeWhole(const QString& path, const QByteArray& bytes) {
    return writeWhole(path, [&bytes](QIODevice& file) { return file.write(bytes) == bytes.size(); });
}

core::Result<void> writeWhole(const QString& path, const std::function<bool(QIODevice&)>& write) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !write(file) || !file.commit()) {
        return cannotWrite(path, file.errorString());
    }
    return {};
}

/// The size is counted, not asked for: a device or a pipe says 0.
core::Result<QByteArray> readWhole(const QString& path, qint64 most_bytes) {
    const QString shown = QDir::toNativeSeparators(path);
    QFile file(path);
    QByteArray bytes;
    if (file.open(QIODevice::ReadOnly)) {
        bytes = file.read(most_bytes + 1);
    }
    if (bytes.size() > most_bytes) {
        return core::fail(core::ErrorKind::kFile,
                          say("“%1” is too large: %2 at the most.").arg(shown, QLocale().formattedDataSize(most_bytes)),
                          say("Choose another file."));
    }
    if (!file.isOpen() || file.error() != QFileDevice::NoError) {
        return core::fail(core::ErrorKind::kFile, say("“%1” cannot be read: %2.").arg(shown, file.errorString()),
                          say("Check its name and your permission to read it."));
    }
    return bytes;
}

}  // namespace pmts::app
