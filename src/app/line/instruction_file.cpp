#include "pmts/app/line/instruction_file.hpp"

#include "pmts/app/desk/whole_file.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>

static void nameInstructions() { Q_INIT_RESOURCE(instructions); }  // outside every namespace, as the macro wants

namespace pmts::app {
namespace {

/// An editor writes a file in several steps: emptied, written, renamed.
constexpr core::Duration kSettle = std::chrono::milliseconds(300);

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
    if (path_.isEmpty() || !QFile::exists(path_)) {
        return take(shippedText(), true);
    }
    const auto bytes = readWhole(path_, kLargest);
    if (!bytes) {
        trouble_ = bytes.error();
        Q_EMIT problemReported(*trouble_);
        return;
    }
    take(QString::fromUtf8(*bytes), false);
}

void InstructionFile::take(const QString& text, bool is_shipped) {
    const bool is_new = text != text_ || is_shipped != is_shipped_ || trouble_.has_value();
    trouble_.reset();
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
    if (trouble_) {
        return core::fail(core::ErrorKind::kFile,
                          tr("What is in “%1” could not be read; it is not replaced by this text.").arg(QDir::toNativeSeparators(path_)),
                          tr("Make the file readable or move it away, then save again. Export keeps the text elsewhere."),
                          trouble_->happened);
    }
    const QByteArray bytes = text.toUtf8();
    if (bytes.size() > kLargest) {  // it could not be read again
        return core::fail(core::ErrorKind::kBadInput, tr("The instruction table is larger than 1 MB."),
                          tr("Take out what is no instruction, then save again."));
    }
    PMTS_TRY(writeWhole(path_, bytes));
    take(text, false);
    watch();
    return {};
}

}  // namespace pmts::app
