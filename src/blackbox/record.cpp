#include "pmts/blackbox/record.hpp"

#include <QCborValue>
#include <QtEndian>

#include <array>
#include <stdexcept>

namespace pmts::blackbox {
namespace {

constexpr std::string_view kMarker("\xB1\x0B\xF8\x58", 4);
constexpr std::size_t kCheckedFrom = 4, kHeadCheckAt = 20;

constexpr std::array<std::uint32_t, 256> crcTable() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) {
            value = (value & 1) != 0 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
        }
        table[i] = value;
    }
    return table;
}

template <class Number>
void append(QByteArray& bytes, Number number) {
    const Number little = qToLittleEndian(number);
    bytes.append(reinterpret_cast<const char*>(&little), sizeof little);
}

template <class Number>
Number numberAt(std::string_view bytes, std::size_t at) {
    return qFromLittleEndian<Number>(bytes.data() + at);
}

std::string_view viewOf(const QByteArray& bytes) { return {bytes.constData(), static_cast<std::size_t>(bytes.size())}; }

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
    static constexpr auto kTable = crcTable();
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        value = kTable[(value ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (value >> 8);
    }
    return ~value;
}

QByteArray encoded(const Record& record) {
    if (static_cast<std::uint64_t>(record.body.size()) > kLargestBody) {
        throw std::logic_error("a record of the black box is larger than a reader takes");
    }
    QByteArray bytes(kMarker.data(), static_cast<qsizetype>(kMarker.size()));
    bytes.reserve(record.body.size() + static_cast<qsizetype>(kRecordFrame));
    append(bytes, static_cast<std::uint16_t>(record.kind));
    append(bytes, std::uint16_t{0});
    append(bytes, static_cast<std::uint32_t>(record.body.size()));
    append(bytes, static_cast<std::int64_t>(record.at.count()));
    append(bytes, crc32(viewOf(bytes).substr(kCheckedFrom)));
    bytes.append(record.body);
    append(bytes, crc32(viewOf(record.body)));
    return bytes;
}

std::optional<RecordHead> headAt(std::string_view bytes) {
    if (bytes.size() < kHeadSize || !bytes.starts_with(kMarker)) {
        return std::nullopt;
    }
    const auto checked = bytes.substr(kCheckedFrom, kHeadCheckAt - kCheckedFrom);
    const RecordHead head{.kind = static_cast<Kind>(numberAt<std::uint16_t>(bytes, 4)),
                          .at = core::Duration(numberAt<std::int64_t>(bytes, 12)),
                          .body_size = numberAt<std::uint32_t>(bytes, 8)};
    const bool is_sound = crc32(checked) == numberAt<std::uint32_t>(bytes, kHeadCheckAt) && head.body_size <= kLargestBody;
    return is_sound ? std::optional(head) : std::nullopt;
}

bool isWhole(std::string_view bytes, const RecordHead& head) {
    if (bytes.size() < kRecordFrame + head.body_size) {
        return false;
    }
    return crc32(bytes.substr(kHeadSize, head.body_size)) == numberAt<std::uint32_t>(bytes, kHeadSize + head.body_size);
}

QByteArray bodyOf(const QCborMap& map) { return map.toCborValue().toCbor(); }

QCborMap mapOf(const QByteArray& body) { return QCborValue::fromCbor(body).toMap(); }

}  // namespace pmts::blackbox
