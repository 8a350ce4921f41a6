#include "pmts/blackbox/zip_file.hpp"

#include "pmts/blackbox/record.hpp"

#include <QtEndian>

namespace pmts::blackbox {
namespace {

constexpr std::uint16_t kVersion = 20, kUtf8Names = 1 << 11, kStored = 0;

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
void putFacts(Little to, const ZipEntry& entry, const QDateTime& time) {
    const auto size = static_cast<std::uint32_t>(entry.bytes.size());
    const std::uint32_t check = crc32({entry.bytes.constData(), static_cast<std::size_t>(entry.bytes.size())});
    to.u16(kVersion).u16(kUtf8Names).u16(kStored).u16(dosTime(time.time())).u16(dosDate(time.date()));
    to.u32(check).u32(size).u32(size).u16(static_cast<std::uint32_t>(entry.name.toUtf8().size())).u16(0);
}

}  // namespace

QByteArray zipOf(const std::vector<ZipEntry>& entries, const QDateTime& time) {
    QByteArray archive, directory;
    for (const ZipEntry& entry : entries) {
        const auto offset = static_cast<std::uint32_t>(archive.size());
        Little(archive).u32(0x04034B50);
        putFacts(Little(archive), entry, time);
        archive += entry.name.toUtf8() + entry.bytes;
        Little(directory).u32(0x02014B50).u16(kVersion);
        putFacts(Little(directory), entry, time);
        Little(directory).u16(0).u16(0).u16(0).u32(0).u32(offset);  // comment, disk, attributes
        directory += entry.name.toUtf8();
    }
    const auto begins = static_cast<std::uint32_t>(archive.size());
    const auto count = static_cast<std::uint32_t>(entries.size());
    archive += directory;
    Little(archive).u32(0x06054B50).u16(0).u16(0).u16(count).u16(count).u32(static_cast<std::uint32_t>(directory.size()));
    Little(archive).u32(begins).u16(0);
    return archive;
}

}  // namespace pmts::blackbox
