#include "memory_import.hpp"

#include "pmts/app/line/memory_document.hpp"
#include "pmts/app/desk/whole_file.hpp"

#include <QCoreApplication>
#include <QFileInfo>

namespace pmts::app {
namespace {

QString tr(const char* sentence) { return QCoreApplication::translate("MemoryImport", sentence); }

}  // namespace

bool isMemoryFile(const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    return ending == QLatin1String("job") || ending == QLatin1String("are");
}

core::Result<std::vector<survey::PlannedPoint>> plannedFromMemoryFile(const QString& path) {
    const auto bytes = readWhole(path, kLargestMemoryFile);
    PMTS_TRY(bytes);
    const MemoryDocument document(QFileInfo(path).completeBaseName(), bytes->toStdString());
    if (!document.file().bad.empty()) {
        const auto& bad = document.file().bad.front();
        return core::fail(
            core::ErrorKind::kBadInput,
            tr("Line %1 of the file cannot be read: “%2”.").arg(bad.number).arg(QString::fromLatin1(bad.text)),
            tr("Correct the line and import the file again; nothing was taken from it."));
    }
    if (!document.units()) {
        return core::fail(core::ErrorKind::kBadInput, tr("The file does not say its units (label 23)."),
                          tr("Open it on the page Memory of the workspace Line and choose them there."));
    }
    auto points = document.points();
    if (points.empty()) {
        return core::fail(core::ErrorKind::kBadInput, tr("No point of the file has N, E and elevation."),
                          tr("Labels 37, 38 and 39 say where a point is."));
    }
    return points;
}

}  // namespace pmts::app
