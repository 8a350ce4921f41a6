#pragma once

#include "pmts/blackbox/record.hpp"
#include "pmts/core/result.hpp"

#include <QDateTime>
#include <QFile>
#include <QString>

#include <memory>
#include <vector>

namespace pmts::blackbox {

/// Where a whole record stands in a file.
struct Entry {
    Kind kind = Kind::kLog;
    core::Duration at{0};
    qint64 offset = 0;  ///< of the record
    std::uint32_t body_size = 0;
};

/// Bytes that belong to no whole record.
struct Damage {
    qint64 offset = 0;
    qint64 size = 0;
};

/// A black box file, opened for reading: every whole record of it, also behind damage. Reading the entries takes as long
/// as the disk needs for the file: not on the GUI thread. Afterwards any thread may ask for bodies.
class Recording {
public:
    /// kFile when it cannot be read or holds no whole record.
    [[nodiscard]] static core::Result<std::shared_ptr<const Recording>> open(const QString& path);

    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    [[nodiscard]] const std::vector<Damage>& damages() const { return damages_; }
    [[nodiscard]] QByteArray bodyBytes(const Entry& entry) const;
    [[nodiscard]] QCborMap body(const Entry& entry) const { return mapOf(bodyBytes(entry)); }
    [[nodiscard]] QString path() const { return file_.fileName(); }

private:
    explicit Recording(const QString& path) : file_(path) {}
    void findEntries();

    QFile file_;
    std::string_view bytes_;  ///< the file, mapped
    std::vector<Entry> entries_;
    std::vector<Damage> damages_;
};

/// The black box files of a folder, oldest first.
[[nodiscard]] QStringList recordingsIn(const QString& folder);

/// What the next file is called: the time of day and a number, always behind those that are there. A clock that was set
/// back goes on with the newest name, so that the order of the names stays the order of writing.
[[nodiscard]] QString nextRecordingName(const QStringList& present, const QDateTime& utc);

}  // namespace pmts::blackbox
