#include "pmts/transport/session_log.hpp"

#include <QFile>

#include <charconv>
#include <cmath>

namespace pmts::transport {
namespace {

constexpr char kDirectionSigns[] = {'>', '<', '!'};
constexpr const char* kHexDigits = "0123456789ABCDEF";

std::string escapedByte(char byte) {
    switch (byte) {
        case '\r':
            return "\\r";
        case '\n':
            return "\\n";
        case '\t':
            return "\\t";
        case '\\':
            return "\\\\";
        default:
            break;
    }
    if (byte >= 0x20 && byte <= 0x7E) {
        return {byte};
    }
    const auto value = static_cast<unsigned char>(byte);
    return {'\\', 'x', kHexDigits[value >> 4], kHexDigits[value & 15]};
}

std::optional<char> plainEscape(char letter) {
    switch (letter) {
        case 'r':
            return '\r';
        case 'n':
            return '\n';
        case 't':
            return '\t';
        case '\\':
            return '\\';
        default:
            return std::nullopt;
    }
}

std::optional<char> hexEscape(std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool whole = digits.size() == 2 && error == std::errc{} && end == digits.data() + 2 && value >= 0;
    return whole ? std::optional(static_cast<char>(value)) : std::nullopt;
}

std::optional<Direction> directionOf(char sign) {
    for (const auto direction : {Direction::kSent, Direction::kReceived, Direction::kLost}) {
        if (kDirectionSigns[static_cast<int>(direction)] == sign) {
            return direction;
        }
    }
    return std::nullopt;
}

/// `      52.083 < 0\r\n`
std::optional<SessionEvent> eventOf(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    double ms = 0.0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), ms);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (error != std::errc{} || line.size() < 3 || line[0] != ' ' || line[2] != ' ') {
        return std::nullopt;
    }
    const auto direction = directionOf(line[1]);
    auto bytes = bytesFromEscaped(line.substr(3));
    if (!direction || !bytes) {
        return std::nullopt;
    }
    return SessionEvent{.at = std::chrono::microseconds(std::llround(ms * 1e3)),
                        .direction = *direction,
                        .bytes = std::move(*bytes)};
}

/// `@ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1`
Session sessionOf(const QString& line) {
    const QString text = line.mid(2);
    return {.began_utc = QDateTime::fromString(text.section(u' ', 0, 0), Qt::ISODateWithMs),
            .link = text.section(u' ', 1),
            .events = {}};
}

core::Result<std::vector<Session>> sessionsOf(QFile& log, const std::function<bool()>& wanted) {
    constexpr std::size_t kLinesBetween = std::size_t{1} << 16;
    std::vector<Session> sessions;
    for (std::size_t number = 0; !log.atEnd(); ++number) {
        if (number % kLinesBetween == 0 && wanted && !wanted()) {
            return core::cancelled();
        }
        QByteArray line = log.readLine();
        if (!line.endsWith('\n')) {
            break;  // half written
        }
        line.chop(1);
        if (line.startsWith("@ ")) {
            sessions.push_back(sessionOf(QString::fromUtf8(line)));
        } else if (!sessions.empty()) {
            if (auto event = eventOf({line.constData(), static_cast<std::size_t>(line.size())})) {
                sessions.back().events.push_back(std::move(*event));
            }
        }
    }
    return sessions;
}

}  // namespace

std::string escapedBytes(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) {
        text += escapedByte(byte);
    }
    if (text.ends_with(' ')) {
        text.replace(text.size() - 1, 1, "\\x20");
    }
    return text;
}

std::optional<std::string> bytesFromEscaped(std::string_view text) {
    std::string bytes;
    while (!text.empty()) {
        if (text[0] != '\\') {
            bytes += text[0];
            text.remove_prefix(1);
            continue;
        }
        const bool hex = text.size() > 1 && text[1] == 'x';
        const auto byte = hex ? hexEscape(text.substr(2, 2)) : plainEscape(text.size() > 1 ? text[1] : '\0');
        if (!byte) {
            return std::nullopt;
        }
        bytes += *byte;
        text.remove_prefix(hex ? 4 : 2);
    }
    return bytes;
}

std::string sessionLine(const SessionEvent& event) {
    const auto us = std::chrono::duration_cast<std::chrono::microseconds>(event.at).count();
    const QString ms = QStringLiteral("%1.%2").arg(us / 1000).arg(us % 1000, 3, 10, QChar(u'0'));
    return ms.rightJustified(12).toStdString() + ' ' + kDirectionSigns[static_cast<int>(event.direction)] +
           ' ' + escapedBytes(event.bytes) + '\n';
}

core::Result<std::vector<Session>> readSessionLog(const QString& path, const std::function<bool()>& wanted) {
    QFile log(path);
    if (!log.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile,
                          QStringLiteral("The session log %1 cannot be read.").arg(path),
                          QStringLiteral("Check that the file exists and may be read."), log.errorString());
    }
    auto sessions = sessionsOf(log, wanted);
    PMTS_TRY(sessions);
    if (sessions->empty()) {
        return core::fail(core::ErrorKind::kFile, QStringLiteral("%1 holds no recorded session.").arg(path),
                          QStringLiteral("Choose a file that PMTS has recorded."));
    }
    return sessions;
}

}  // namespace pmts::transport
