#include "pmts/protocol/line_capture.hpp"
#include "watch.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <charconv>
#include <set>
#include <string>
#include <utility>

namespace pmts::protocol {
namespace {

QString say(const char* text) { return QCoreApplication::translate("LineCapture", text); }

/// `level-count`, `level-` or a sum, as it is printed.
struct Word {
    std::string_view level, count, sum;
};

/// Comments out, breaks inside a pair closed.
std::string joined(std::string_view text, Watch& watch) {
    std::string out;
    bool comment = false;
    for (std::size_t i = 0; i < text.size() && watch.goesOn(i, i, text.size()); ++i) {
        comment = text[i] == '#' || (comment && text[i] != '\n');
        if (comment) {
            continue;
        }
        const bool is_break = text[i] == ' ' || text[i] == '\n' || text[i] == '\r' || text[i] == '\t';
        if (is_break && !out.empty() && out.back() == '-') {
            continue;  // the pair goes on after the page break
        }
        out += is_break || text[i] == ';' ? ',' : text[i];
    }
    return out;
}

/// Views into `flat`.
std::vector<Word> wordsOf(std::string_view flat, Watch& watch) {
    std::vector<Word> words;
    std::size_t at = 0;
    for (std::size_t turn = 0; at < flat.size() && watch.goesOn(turn, at, flat.size()); ++turn) {
        const std::size_t end = std::min(flat.find(',', at), flat.size());
        const std::string_view token = flat.substr(at, end - at);
        at = end + 1;
        const std::size_t dash = token.find('-');
        if (dash != std::string::npos) {
            words.push_back({token.substr(0, dash), token.substr(dash + 1), {}});
        } else if (!token.empty()) {
            words.push_back({{}, {}, token});
        }
    }
    return words;
}

std::optional<std::uint64_t> number(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size() && !text.empty();
    return whole ? std::optional(value) : std::nullopt;
}

/// Takes apart a sum that was printed without the comma before the next level: `715-1` after counts that add up to 7.
std::vector<Word> unglued(std::vector<Word> words, Watch& watch) {
    std::set<std::string_view> levels;
    for (const Word& word : words) {
        levels.insert(word.level);
    }
    std::vector<Word> apart;
    apart.reserve(words.size());
    std::uint64_t counted = 0;
    for (Word word : words) {
        if (!watch.goesOn(apart.size(), apart.size(), 2 * words.size())) {
            break;
        }
        const std::string sum = std::to_string(counted);
        if (word.level.size() > sum.size() && counted > 0 && word.level.starts_with(sum) &&
            levels.contains(word.level.substr(sum.size()))) {
            apart.push_back({{}, {}, word.level.substr(0, sum.size())});
            word.level.remove_prefix(sum.size());
            counted = 0;
        }
        counted = word.level.empty() ? 0 : counted + number(word.count).value_or(0);
        apart.push_back(word);
    }
    return apart;
}

/// The runs of one group, until its sum.
class Group {
public:
    explicit Group(LineCapture& capture) : capture_(capture) {}

    void add(const Word& word) { words_.push_back(word); }
    [[nodiscard]] bool isEmpty() const { return words_.empty(); }

    void close(std::optional<std::uint64_t> sum) {
        std::uint64_t known = 0;
        int missing = 0;
        for (const Word& word : words_) {
            const auto count = number(word.count);
            known += count.value_or(0);
            missing += count ? 0 : 1;
        }
        const bool mendable = sum && missing == 1 && *sum > known;
        for (const Word& word : words_) {
            take(word, mendable ? std::optional(*sum - known) : std::nullopt);
        }
        if (sum && missing == 0 && *sum != known) {
            doubt(say("The counts of a group add up to %1, printed is %2.").arg(known).arg(*sum), false);
        }
        words_.clear();
    }

private:
    void take(const Word& word, std::optional<std::uint64_t> mended) {
        const auto level = number(word.level);
        auto count = number(word.count);
        if (!count) {
            doubt(mended ? say("A count is missing; the sum of its group says %1.").arg(*mended)
                         : say("A count is missing and nothing says what it was; 1 is taken."),
                  mended.has_value());
            count = mended.value_or(1);
        }
        if (!level || *level > 0xFFFFFFFFU) {
            doubt(say("“%1” is no level.").arg(QString::fromLatin1(word.level)), false);
            return;
        }
        capture_.append(static_cast<std::uint32_t>(*level), *count);
    }
    void doubt(const QString& what, bool mended) {
        capture_.doubts.push_back({capture_.runs.empty() ? 0 : capture_.runs.size() - 1, what, mended});
    }

    LineCapture& capture_;
    std::vector<Word> words_;
};

}  // namespace

core::Result<LineCapture> captureFromRunText(std::string_view text, const Progress& progress) {
    Watch watch(progress);
    watch.setStage(0.0, 0.3);
    const std::string flat = joined(text, watch);
    watch.setStage(0.3, 0.5);
    std::vector<Word> read = wordsOf(flat, watch);
    watch.setStage(0.5, 0.9);
    const std::vector<Word> words = unglued(std::move(read), watch);
    watch.setStage(0.7, 1.0);
    LineCapture capture;
    Group group(capture);
    std::size_t turn = 0;
    for (const Word& word : words) {
        if (!watch.goesOn(turn, turn, words.size())) {
            break;
        }
        ++turn;
        if (!word.level.empty()) {
            group.add(word);
        } else if (!group.isEmpty()) {
            group.close(number(word.sum));
        }
    }
    if (watch.hasStopped()) {
        return core::cancelled();
    }
    group.close(std::nullopt);
    if (capture.runs.empty()) {
        return core::fail(core::ErrorKind::kBadInput, say("This file holds no runs such as “15-2”."),
                          say("Choose a file of level-count pairs, or another format."));
    }
    std::uint32_t all = 0;
    for (const LevelRun& run : capture.runs) {
        all |= run.levels;
    }
    capture.lines = std::max(1, static_cast<int>(std::bit_width(all)));
    return capture;
}

}  // namespace pmts::protocol
