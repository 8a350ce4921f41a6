#include "pmts/protocol/line_talk.hpp"

#include "pmts/protocol/seen_routine.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace pmts::protocol {
namespace {

constexpr std::uint32_t kLongestLine = 32;
constexpr std::string_view kDigits = "0123456789ABCDEF";
constexpr std::array<std::pair<unsigned char, std::string_view>, 6> kNames{
    {{'\r', "<CR>"}, {'\n', "<LF>"}, {0x04, "<EOT>"}, {0x02, "<STX>"}, {0x03, "<ETX>"}, {'\t', "<TAB>"}}};

std::string nameOf(unsigned char value) {
    const auto* const known = std::ranges::find(kNames, value, &std::pair<unsigned char, std::string_view>::first);
    if (known != kNames.end()) {
        return std::string(known->second);
    }
    return value >= 0x20 && value < 0x7F ? std::string(1, static_cast<char>(value))
                                         : std::string{'<', kDigits[value >> 4], kDigits[value & 15], '>'};
}

/// A line's end marks stay together: `0.8<CR><EOT>`, `7=10.2345<CR><LF>>`.
bool endsLine(std::span<const DecodedCharacter> characters, std::size_t at) {
    const unsigned char value = characters[at].value;
    const unsigned char next = at + 1 < characters.size() ? characters[at + 1].value : 0;
    const bool goes_on = next == 0x04 || next == '>' || (value == '\r' && next == '\n');
    return value == 0x04 || value == '>' || ((value == '\r' || value == '\n') && !goes_on);
}

std::optional<unsigned char> hexByte(std::string_view digits) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    const bool whole = error == std::errc() && end == digits.data() + digits.size() && digits.size() == 2;
    return whole ? std::optional(static_cast<unsigned char>(value)) : std::nullopt;
}

/// `0D 41`; absent when it is anything else. One pair alone is text.
std::optional<std::string> hexBytes(std::string_view typed) {
    std::string bytes;
    while (!typed.empty()) {
        const std::size_t end = std::min(typed.find(' '), typed.size());
        const auto byte = hexByte(typed.substr(0, end));
        if (!byte) {
            return std::nullopt;
        }
        bytes += static_cast<char>(*byte);
        typed.remove_prefix(std::min(end + 1, typed.size()));
    }
    return bytes.size() > 1 ? std::optional(bytes) : std::nullopt;
}

/// The byte that `<CR>` or `<0D>` at the beginning names, and the length of its name; length 0: it names none.
std::pair<char, std::size_t> namedByte(std::string_view typed) {
    for (const auto& [value, name] : kNames) {
        if (typed.starts_with(name)) {
            return {static_cast<char>(value), name.size()};
        }
    }
    if (typed.size() >= 4 && typed[0] == '<' && typed[3] == '>') {
        if (const auto byte = hexByte(typed.substr(1, 2))) {
            return {static_cast<char>(*byte), 4};
        }
    }
    return {};
}

}  // namespace

std::string shownCharacter(const DecodedCharacter& character) {
    const std::string shown = nameOf(character.value);
    return character.isSure() ? shown : "[?" + shown + "]";
}

std::string shownBytes(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) {
        text += nameOf(static_cast<unsigned char>(byte));
    }
    return text;
}

std::string textOf(std::span<const DecodedCharacter> characters) {
    std::string text;
    for (const DecodedCharacter& character : characters) {
        text += shownCharacter(character);
    }
    return text;
}

std::string hexOf(std::span<const DecodedCharacter> characters) {
    std::string text;
    for (const DecodedCharacter& character : characters) {
        text += text.empty() ? "" : " ";
        text += kDigits[character.value >> 4];
        text += kDigits[character.value & 15];
        text += character.isSure() ? "" : "?";
    }
    return text;
}

std::vector<DecodedCharacter> charactersOf(std::string_view bytes, TalkSide side, std::uint64_t first_sample) {
    std::vector<DecodedCharacter> characters;
    characters.reserve(bytes.size());
    for (const char byte : bytes) {
        characters.push_back({.value = static_cast<unsigned char>(byte), .side = side, .sample = first_sample++});
    }
    return characters;
}

std::vector<DecodedCharacter> mergedTalk(const std::vector<DecodedCharacter>& a, const std::vector<DecodedCharacter>& b) {
    std::vector<DecodedCharacter> all;
    all.reserve(a.size() + b.size());
    std::ranges::merge(a, b, std::back_inserter(all), {}, &DecodedCharacter::sample, &DecodedCharacter::sample);
    return all;
}

std::vector<TalkLine> talkLines(std::span<const DecodedCharacter> characters, double pause_samples) {
    std::vector<TalkLine> lines;
    bool is_new = true;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        if (i > 0 && !is_new) {
            const auto& before = characters[i - 1];
            const auto gap = static_cast<double>(characters[i].sample - before.sample);
            is_new = characters[i].side != before.side || gap > pause_samples || lines.back().count == kLongestLine;
        }
        if (is_new) {
            lines.push_back({.first = i});
        }
        ++lines.back().count;
        lines.back().unsure += characters[i].isSure() ? 0U : 1U;
        is_new = endsLine(characters, i);
    }
    return lines;
}

TalkSide likelySide(std::span<const DecodedCharacter> characters) {
    std::size_t commands = 0, others = 0;
    std::string line;
    for (const DecodedCharacter& character : characters) {
        if (character.value >= 0x20 && character.value != '>') {
            line += static_cast<char>(character.value);
        } else if (!line.empty()) {
            ++(isSeenCommand(line) ? commands : others);
            line.clear();
        }
    }
    if (commands + others == 0) {
        return TalkSide::kUnknown;
    }
    return commands > others ? TalkSide::kToInstrument : TalkSide::kFromInstrument;
}

core::Result<std::string> searchedBytes(std::string_view typed) {
    if (typed.empty()) {
        return core::fail(core::ErrorKind::kBadInput, QCoreApplication::translate("LineTalk", "There is nothing to look for."),
                          QCoreApplication::translate("LineTalk", "Type text, <CR>, or bytes such as 0D 41."));
    }
    if (auto bytes = hexBytes(typed)) {
        return *bytes;
    }
    std::string bytes;
    while (!typed.empty()) {
        const auto [byte, length] = namedByte(typed);
        bytes += length > 0 ? byte : typed.front();
        typed.remove_prefix(std::max<std::size_t>(1, length));
    }
    return bytes;
}

}  // namespace pmts::protocol
