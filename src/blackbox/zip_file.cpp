#include "pmts/blackbox/zip_file.hpp"

#include "pmts/blackbox/record.hpp"

#include <QBuffer>
#include <QtEndian>

#include <algorithm>

namespace pmts::blackbox {
namespace {

constexpr std::uint16_t kVersion = 20, kUtf8Names = 1 << 11, kStored = 0;
constexpr qsizetype kPiece = qsizetype{1} << 20;  ///< between two questions whether to go on

class Little {
public:
    explicit Little(QByteArray& bytes) : bytes_(bytes) {}

    Little& u16(std::uint32_t number) { return put(static_cast<std::uint16_t>(number)); }
    Little& u32(std::uint32_t number) { return put(number); }

private:
    template <class Number>
    Little& put(Number number) {
        const Number little = qToLittleEndian(number);
        bytes_.append(reinterpret_cast<const char*>(&little), sizeof little);
        return *this;
    }

    QByteArray& bytes_;
};

/// Two seconds are the unit of the format.
std::uint32_t dosTime(const QTime& time) {
    return static_cast<std::uint32_t>(time.hour() << 11 | time.minute() << 5 | time.second() / 2);
}

std::uint32_t dosDate(const QDate& date) {
    return static_cast<std::uint32_t>((date.year() - 1980) << 9 | date.month() << 5 | date.day());
}

/// What local header and directory have in common.
void putFacts(Little to, const ZipEntry& entry, std::uint32_t check, const QDateTime& time) {
    const auto size = static_cast<std::uint32_t>(entry.bytes.size());
    to.u16(kVersion).u16(kUtf8Names).u16(kStored).u16(dosTime(time.time())).u16(dosDate(time.date()));
    to.u32(check).u32(size).u32(size).u16(static_cast<std::uint32_t>(entry.name.toUtf8().size())).u16(0);
}

}  // namespace

QByteArray zipOf(const std::vector<ZipEntry>& entries, const QDateTime& time) {
    QBuffer archive;
    archive.open(QIODevice::WriteOnly);
    (void)writeZip(archive, entries, time);  // memory takes it all
    return archive.data();
}

bool writeZip(QIODevice& device, const std::vector<ZipEntry>& entries, const QDateTime& time,
              const std::function<bool(double done)>& goes_on) {
    qint64 written = 0, total = 1;
    for (const ZipEntry& entry : entries) {
        total += entry.bytes.size();
    }
    const auto put = [&](const QByteArray& bytes) {
        for (qsizetype at = 0; at < bytes.size(); at += kPiece) {
            const qsizetype size = std::min(kPiece, bytes.size() - at);
            const bool is_put = device.write(bytes.constData() + at, size) == size;
            written += size;
            if (!is_put || (goes_on && !goes_on(std::min(1.0, static_cast<double>(written) / static_cast<double>(total))))) {
                return false;
            }
        }
        return true;
    };
    QByteArray directory;
    for (const ZipEntry& entry : entries) {
        const auto offset = static_cast<std::uint32_t>(written);
        const std::uint32_t check = crc32({entry.bytes.constData(), static_cast<std::size_t>(entry.bytes.size())});
        QByteArray head;
        Little(head).u32(0x04034B50);
        putFacts(Little(head), entry, check, time);
        if (!put(head + entry.name.toUtf8()) || !put(entry.bytes)) {
            return false;
        }
        Little(directory).u32(0x02014B50).u16(kVersion);
        putFacts(Little(directory), entry, check, time);
        Little(directory).u16(0).u16(0).u16(0).u32(0).u32(offset);  // comment, disk, attributes
        directory += entry.name.toUtf8();
    }
    const auto begins = static_cast<std::uint32_t>(written);
    const auto count = static_cast<std::uint32_t>(entries.size());
    QByteArray end = directory;
    Little(end).u32(0x06054B50).u16(0).u16(0).u16(count).u16(count).u32(static_cast<std::uint32_t>(directory.size()));
    Little(end).u32(begins).u16(0);
    return put(end);
}

}  // namespace pmts::blackbox
