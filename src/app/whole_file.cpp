#include "pmts/app/whole_file.hpp"

#include <QCoreApplication>
#include <QDir>
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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return cannotWrite(path, file.errorString());
    }
    return {};
}

}  // namespace pmts::app
