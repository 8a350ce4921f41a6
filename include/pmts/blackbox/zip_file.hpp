#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <vector>

namespace pmts::blackbox {

struct ZipEntry {
    QString name;
    QByteArray bytes;
};

/// A zip archive of files as they are, not compressed (APPNOTE 6.3, method 0): any archive program opens it. Names are UTF-8.
/// Below 4 GB in all.
[[nodiscard]] QByteArray zipOf(const std::vector<ZipEntry>& entries, const QDateTime& time);

}  // namespace pmts::blackbox
