#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QIODevice>
#include <QString>

#include <functional>
#include <vector>

namespace pmts::blackbox {

struct ZipEntry {
    QString name;
    QByteArray bytes;
};

/// A zip archive of files as they are, not compressed (APPNOTE 6.3, method 0): any archive program opens it. Names are UTF-8.
/// Below 4 GB in all.
[[nodiscard]] QByteArray zipOf(const std::vector<ZipEntry>& entries, const QDateTime& time);

/// The same into a device, without a second copy of it all. `goes_on` is asked with the part that is done, from 0 to 1; its
/// `false` ends the writing. False when it was ended or the device took less.
[[nodiscard]] bool writeZip(QIODevice& device, const std::vector<ZipEntry>& entries, const QDateTime& time,
                            const std::function<bool(double done)>& goes_on = {});

}  // namespace pmts::blackbox
