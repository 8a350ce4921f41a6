#include "pmts/instrument/line_symptom.hpp"

#include "bus_stream.hpp"
#include "pmts/protocol/reply.hpp"

#include <algorithm>
#include <bit>
#include <charconv>

namespace pmts::instrument {
namespace {

constexpr unsigned kSevenBits = 0x7F;
constexpr double kLeastReadable = 0.8;
constexpr std::size_t kLeastText = 4;

bool isReadable(char c) { return (c >= 0x20 && c <= 0x7E) || c == '\r' || c == '\n'; }

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsIn(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isDigit) - text.begin());
}

/// `79=62`: the label.
std::optional<int> labelOf(std::string_view line) {
    const auto digits = digitsIn(line);
    if (digits < 1 || digits > 3 || digits == line.size() || line[digits] != '=') {
        return std::nullopt;
    }
    int label = 0;
    std::from_chars(line.data(), line.data() + digits, label);
    return label;
}

std::optional<int> numberBehind(std::string_view line) {
    const auto data = line.substr(line.find('=') + 1);
    int number = 0;
    const auto read = std::from_chars(data.data(), data.data() + data.size(), number);
    return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// The lines of a block and what stands behind the last of them.
struct Block {
    bool is_grammar = false;
    bool is_answer = false;  ///< a status or label 79
    std::optional<int> label_79;
    std::string_view rest;
};

Block blockIn(std::string_view text) {
    constexpr int kAsked = 79;
    Block block;
    while (!text.empty() && (text.front() == '>' || text.front() == '\n')) {
        text.remove_prefix(1);  // left over from before
    }
    for (auto end = text.find('\r'); end != std::string_view::npos; end = text.find('\r')) {
        const auto line = text.substr(0, end);
        const auto label = labelOf(line);
        if (!label && !protocol::parseStatus(line)) {
            return {};
        }
        block.is_grammar = true;
        if (label == kAsked) {
            block.label_79 = numberBehind(line);
        }
        block.is_answer = block.is_answer || !label || label == kAsked;
        text.remove_prefix(end + 1);
        while (!text.empty() && text.front() == '\n') {
            text.remove_prefix(1);
        }
    }
    block.rest = text;
    return block.rest.size() <= 1 ? block : Block{};
}

bool soundsLikeModem(std::string_view text) {
    return text.find("OK\r") != std::string_view::npos || text.find("ERROR\r") != std::string_view::npos ||
           text.find("NO CARRIER") != std::string_view::npos;
}

/// One whole block of the angle stream; the first heard may be the end of one.
bool isBusStream(std::string_view text) {
    using protocol::kBusBlockEnd;
    for (auto end = text.find(kBusBlockEnd); end != std::string_view::npos; end = text.find(kBusBlockEnd)) {
        if (pointingOfStream(text.substr(0, end))) {
            return true;
        }
        text.remove_prefix(end + 1);
    }
    return false;
}

bool isText(std::string_view heard) {
    const auto readable = static_cast<double>(std::ranges::count_if(heard, isReadable));
    return heard.size() >= kLeastText && readable >= kLeastReadable * static_cast<double>(heard.size());
}

LineEvidence judgeText(std::string_view text) {
    LineEvidence evidence;
    if (const Block block = blockIn(text); block.is_grammar) {
        evidence.symptom = block.is_answer ? LineSymptom::kAnswer : LineSymptom::kUnasked;
        evidence.label_79 = block.label_79;
        evidence.end_mark = block.rest.empty() ? std::nullopt : std::optional(block.rest.front());
    } else if (isBusStream(text)) {
        evidence.symptom = LineSymptom::kBusStream;
    } else if (soundsLikeModem(text)) {
        evidence.symptom = LineSymptom::kModem;
    } else {
        evidence.symptom = isText(text) ? LineSymptom::kOtherDevice : LineSymptom::kGarbled;
    }
    return evidence;
}

/// The text without its top bits, and the parity that they are.
std::optional<transport::Parity> parityOnTop(std::string_view heard) {
    const auto ones = [](char c) { return std::popcount(static_cast<unsigned>(static_cast<unsigned char>(c))) % 2; };
    const auto odd = std::ranges::count_if(heard, [ones](char c) { return ones(c) == 1; });
    if (odd == 0) {
        return transport::Parity::kEven;
    }
    return static_cast<std::size_t>(odd) == heard.size() ? std::optional(transport::Parity::kOdd) : std::nullopt;
}

bool isEcho(std::string_view sent, std::string_view heard) {
    return !sent.empty() && heard.starts_with(sent.substr(0, sent.size() - 1));
}

}  // namespace

LineEvidence judgeLine(std::string_view sent, std::string_view heard) {
    if (heard.empty()) {
        return {};
    }
    if (isEcho(sent, heard)) {
        heard.remove_prefix(std::min(sent.size(), heard.size()));
        while (!heard.empty() && (heard.front() == '\r' || heard.front() == '\n')) {
            heard.remove_prefix(1);  // some echo a line end of their own
        }
        LineEvidence evidence = judgeText(heard);
        if (heard.empty()) {
            evidence.symptom = LineSymptom::kEcho;
        }
        evidence.echoes = true;
        return evidence;
    }
    LineEvidence evidence = judgeText(heard);
    if (!evidence.isOurs()) {
        std::string seven(heard);
        std::ranges::transform(seven, seven.begin(),
                               [](char c) { return static_cast<char>(static_cast<unsigned char>(c) & kSevenBits); });
        if (judgeText(seven).isOurs()) {
            evidence.symptom = LineSymptom::kGarbled;
            evidence.seven_bits_with = parityOnTop(heard);
        }
    }
    return evidence;
}

}  // namespace pmts::instrument
