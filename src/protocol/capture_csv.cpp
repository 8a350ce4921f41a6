#include "pmts/protocol/line_capture.hpp"
#include "text_lines.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <string>

namespace pmts::protocol {
namespace {

QString say(const char* text) { return QCoreApplication::translate("LineCapture", text); }

std::vector<std::string_view> fields(std::string_view line) {
    std::vector<std::string_view> out;
    while (true) {
        const std::size_t comma = std::min(line.find(','), line.size());
        out.push_back(trimmed(line.substr(0, comma)));
        if (comma == line.size()) {
            return out;
        }
        line.remove_prefix(comma + 1);
    }
}

/// `1 MHz`, `500 kHz`, `115200`.
std::optional<double> rateOf(std::string_view text) {
    text = trimmed(text);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value <= 0.0) {
        return std::nullopt;
    }
    const std::string_view unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    const char scale = unit.empty() ? ' ' : unit.front();
    return value * (scale == 'G' ? 1e9 : scale == 'M' ? 1e6 : scale == 'k' || scale == 'K' ? 1e3 : 1.0);
}

void readComment(std::string_view line, LineCapture& capture) {
    const std::size_t at = line.find("amplerate");
    const std::size_t colon = at == std::string_view::npos ? at : line.find(':', at);
    if (colon != std::string_view::npos) {
        capture.samples_per_s = rateOf(line.substr(colon + 1));
    }
}

bool isBit(std::string_view field) { return field == "0" || field == "1"; }

/// The columns of a CSV file that are lines; a column of times is none.
class CsvReader {
public:
    core::Result<void> read(std::size_t number, std::string_view line) {
        if (line.empty()) {
            return {};
        }
        if (line.front() == ';') {
            readComment(line, capture);
            return {};
        }
        const auto cells = fields(line);
        if (!columns_.empty() || std::ranges::any_of(cells, isBit)) {
            return readSample(number, line, cells);
        }
        names_.assign(cells.begin(), cells.end());
        return {};
    }

    LineCapture capture;

private:
    core::Result<void> readSample(std::size_t number, std::string_view line, const std::vector<std::string_view>& cells) {
        if (columns_.empty()) {
            findColumns(cells);
        }
        std::uint32_t levels = 0;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            if (columns_[i] >= cells.size() || !isBit(cells[columns_[i]])) {
                return unreadableLine(number, line);
            }
            levels |= cells[columns_[i]] == "1" ? 1U << i : 0U;
        }
        capture.append(levels, 1);
        return {};
    }
    void findColumns(const std::vector<std::string_view>& cells) {
        for (std::size_t i = 0; i < cells.size() && columns_.size() < kMostLines; ++i) {
            const bool time = i < names_.size() && QByteArray::fromStdString(names_[i]).toLower().startsWith("time");
            if (isBit(cells[i]) && !time) {
                columns_.push_back(i);
                capture.names << (i < names_.size() ? QString::fromStdString(names_[i]) : QString::number(i));
            }
        }
        capture.lines = static_cast<int>(columns_.size());
    }

    std::vector<std::string> names_;
    std::vector<std::size_t> columns_;
};

}  // namespace

core::Result<LineCapture> captureFromCsv(std::string_view text, const Progress& progress) {
    CsvReader reader;
    PMTS_TRY(eachLine(text, [&reader](std::size_t number, std::string_view line) { return reader.read(number, line); }, progress));
    if (reader.capture.runs.empty()) {
        return core::fail(core::ErrorKind::kBadInput, say("This file holds no rows of 0 and 1."),
                          say("Export the logic channels as CSV, one row for each sample."));
    }
    return std::move(reader.capture);
}

}  // namespace pmts::protocol
