#include "pmts/app/instruction_file.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

static void nameInstructions() { Q_INIT_RESOURCE(instructions); }  // outside every namespace, as the macro wants

namespace pmts::app {
namespace {

/// An editor writes a file in several steps: emptied, written, renamed.
constexpr core::Duration kSettle = std::chrono::milliseconds(300);
constexpr qint64 kLargest = 1 << 20;

core::Error fileTrouble(const QString& happened, const QString& path, const QString& why) {
    return {.kind = core::ErrorKind::kFile,
            .happened = happened,
            .remedy = InstructionFile::tr("Check that the folder exists, is writable and has room."),
            .info_code = std::nullopt,
            .detail = path + QStringLiteral(": ") + why};
}

}  // namespace

InstructionFile::InstructionFile(QString path, core::Clock& clock, QObject* parent)
    : QObject(parent), path_(std::move(path)), clock_(clock) {
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &InstructionFile::readSoon);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &InstructionFile::readSoon);
    read();
}

QString InstructionFile::shippedText() {
    nameInstructions();
    QFile file(QStringLiteral(":/pmts/instructions/geodimeter-bus.txt"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The folder too: an editor may replace the file by another one of its name.
void InstructionFile::watch() {
    if (path_.isEmpty()) {
        return;
    }
    const QString folder = QFileInfo(path_).absolutePath();
    if (!watcher_.directories().contains(folder) && QDir(folder).exists()) {
        watcher_.addPath(folder);
    }
    if (!watcher_.files().contains(path_) && QFile::exists(path_)) {
        watcher_.addPath(path_);
    }
}

void InstructionFile::readSoon() {
    settle_ = clock_.callAfter(kSettle, [this] { read(); });
}

void InstructionFile::read() {
    watch();
    QFile file(path_);
    if (path_.isEmpty() || !file.exists()) {
        take(shippedText(), true);
    } else if (file.size() > kLargest || !file.open(QIODevice::ReadOnly)) {
        Q_EMIT problemReported(fileTrouble(tr("The instruction table cannot be read."), path_, file.errorString()));
    } else {
        take(QString::fromUtf8(file.readAll()), false);
    }
}

void InstructionFile::take(const QString& text, bool is_shipped) {
    const bool is_new = text != text_ || is_shipped != is_shipped_;
    text_ = text;
    is_shipped_ = is_shipped;
    if (!is_new) {
        return;
    }
    auto table = protocol::readInstructionTable(text.toStdString());
    problems_ = table.problems;
    if (problems_.empty()) {
        good_ = std::move(table);
    }
    Q_EMIT changed();
}

core::Result<void> InstructionFile::save(const QString& text) {
    QSaveFile file(path_);
    const QByteArray bytes = text.toUtf8();
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return tl::unexpected(fileTrouble(tr("The instruction table could not be saved."), path_, file.errorString()));
    }
    take(text, false);
    watch();
    return {};
}

}  // namespace pmts::app
