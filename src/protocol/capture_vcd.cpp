#include "pmts/protocol/line_capture.hpp"
#include "text_lines.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>

namespace pmts::protocol {
namespace {

QString say(const char* text) { return QCoreApplication::translate("LineCapture", text); }

/// Where the bits of a VCD variable go.
struct Wire {
    int first_line = 0;
    int width = 1;
};

/// `$timescale 1 us $end` in seconds.
std::optional<double> timescaleOf(std::string_view number, std::string_view unit) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc()) {
        return std::nullopt;
    }
    if (unit.empty()) {
        unit = number.substr(static_cast<std::size_t>(end - number.data()));
    }
    const std::map<std::string_view, double> units{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"ps", 1e-12}};
    const auto found = units.find(unit);
    return found == units.end() ? std::nullopt : std::optional(value * found->second);
}

class VcdReader {
public:
    core::Result<void> read(std::size_t number, std::string_view line) {
        std::vector<std::string_view> words;
        while (!(line = trimmed(line)).empty()) {
            const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
            words.push_back(line.substr(0, end));
            line.remove_prefix(end);
        }
        for (const std::string_view word : words) {
            if (!take(word)) {
                return unreadableLine(number, word);
            }
        }
        return {};
    }
    LineCapture end() {
        capture_.lines = next_line_;
        capture_.append(levels_, 1);  // the last change lasts at least one unit of time
        return std::move(capture_);
    }

private:
    bool take(std::string_view word) {
        if (in_section_) {
            return takeSection(word);
        }
        if (word.front() == '$') {
            section_ = word == "$end" || word == "$dumpvars" || word == "$dumpall" || word == "$dumpon" || word == "$dumpoff"
                           ? std::string_view()
                           : word;
            in_section_ = !section_.empty();
            return true;
        }
        if (vector_) {
            const std::string bits = *std::exchange(vector_, std::nullopt);
            return setVector(bits, word);
        }
        switch (word.front()) {
            case '#':
                return setTime(word.substr(1));
            case 'b':
            case 'B':
                vector_ = std::string(word.substr(1));
                return true;
            case 'r':
            case 'R':
                vector_ = std::string();  // a real number: no line
                return true;
            default:
                return setVector(std::string(word.substr(0, 1)), word.substr(1));
        }
    }
    bool takeSection(std::string_view word) {
        if (word != "$end") {
            arguments_.emplace_back(word);
            return true;
        }
        in_section_ = false;
        const std::vector<std::string> arguments = std::exchange(arguments_, {});
        if (section_ == "$timescale" && !arguments.empty()) {
            if (const auto unit = timescaleOf(arguments[0], arguments.size() > 1 ? arguments[1] : std::string_view())) {
                capture_.samples_per_s = 1.0 / *unit;
            }
        } else if (section_ == "$var" && arguments.size() >= 4) {
            return addWire(arguments);
        }
        return true;
    }
    bool addWire(const std::vector<std::string>& arguments) {
        int width = 0;
        std::from_chars(arguments[1].data(), arguments[1].data() + arguments[1].size(), width);
        if (width < 1 || wires_.contains(arguments[2])) {
            return true;  // a real, or another name of the same wire
        }
        if (next_line_ + width > static_cast<int>(kMostLines)) {
            return true;  // more than can be looked at; the first ones are kept
        }
        wires_[arguments[2]] = {next_line_, width};
        for (int bit = 0; bit < width; ++bit) {
            const QString name = QString::fromStdString(arguments[3]);
            capture_.names << (width == 1 ? name : QStringLiteral("%1[%2]").arg(name).arg(bit));
        }
        next_line_ += width;
        return true;
    }
    bool setTime(std::string_view digits) {
        std::uint64_t time = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), time);
        if (error != std::errc() || (time_ && time < *time_)) {
            return false;
        }
        if (time_) {
            capture_.append(levels_, time - *time_);
        }
        time_ = time;
        return true;
    }
    bool setVector(const std::string& bits, std::string_view id) {
        const auto wire = wires_.find(std::string(id));
        if (wire == wires_.end()) {
            return bits.find_first_not_of("01xXzZuUwWlLhH-") == std::string::npos;
        }
        for (int bit = 0; bit < wire->second.width; ++bit) {
            const std::size_t from_end = static_cast<std::size_t>(bit) + 1;
            const char c = from_end <= bits.size() ? bits[bits.size() - from_end] : '0';
            if (std::string_view("01xXzZ").find(c) == std::string_view::npos) {
                return false;
            }
            const std::uint32_t mask = 1U << (wire->second.first_line + bit);
            levels_ = c == '1' ? levels_ | mask : levels_ & ~mask;
            doubtUnknown(c);
        }
        return true;
    }
    void doubtUnknown(char c) {
        if (c != '0' && c != '1' && !unknown_told_) {
            unknown_told_ = true;
            capture_.doubts.push_back(
                {capture_.runs.size(), say("Some levels were not known when this was recorded; they count as low."), false});
        }
    }

    LineCapture capture_;
    std::map<std::string, Wire> wires_;
    int next_line_ = 0;
    bool in_section_ = false;
    std::string section_;
    std::vector<std::string> arguments_;
    std::optional<std::string> vector_;
    std::optional<std::uint64_t> time_;
    std::uint32_t levels_ = 0;
    bool unknown_told_ = false;
};

}  // namespace

core::Result<LineCapture> captureFromVcd(std::string_view text, const Progress& progress) {
    VcdReader reader;
    PMTS_TRY(eachLine(text, [&reader](std::size_t number, std::string_view line) { return reader.read(number, line); }, progress));
    LineCapture capture = reader.end();
    if (capture.lines == 0) {
        return core::fail(core::ErrorKind::kBadInput, say("This file declares no wires."),
                          say("Choose a value change dump of logic channels."));
    }
    return capture;
}

}  // namespace pmts::protocol
