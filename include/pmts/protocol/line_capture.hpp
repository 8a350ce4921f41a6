#pragma once

#include "pmts/core/result.hpp"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace pmts::protocol {

/// Told the share that is done, 0 to 1; false ends the work early.
using Progress = std::function<bool(double)>;

/// Equal samples of all lines in a row. Bit i of `levels` is line i. Eight bytes, because dense captures have millions.
struct LevelRun {
    std::uint32_t levels = 0;
    std::uint32_t samples = 0;

    [[nodiscard]] bool operator==(const LevelRun&) const = default;
};

/// Something in a capture that is not as its own rules want it.
struct CaptureDoubt {
    std::size_t run = 0;  ///< where it begins, in LineCapture::runs
    QString what;         ///< one sentence
    bool mended = false;  ///< the capture's own redundancy said what was meant
};

/// What was sampled on a bundle of lines, run-length coded. Neighbouring runs differ, unless the first is as long as a run
/// can be.
struct LineCapture {
    static constexpr std::size_t kMostRuns = 1U << 26;  ///< 512 MB of them
    static constexpr std::uint64_t kLongestStretch = std::uint64_t{1} << 44;  ///< samples of one level: five hours at 1 GHz

    int lines = 0;  ///< at most 32
    std::vector<LevelRun> runs;
    std::size_t most_runs = kMostRuns;
    bool is_cut = false;  ///< more was sampled than is kept
    std::optional<double> samples_per_s;  ///< absent: a sample is one bit, or nobody wrote it down
    QStringList names;                    ///< of the lines, as far as the file names them
    std::vector<CaptureDoubt> doubts;

    /// Joined to the last run when nothing has changed; past `most_runs`, or a stretch that is too long,
    /// nothing more is taken, and a doubt says so.
    void append(std::uint32_t levels, std::uint64_t samples);
    [[nodiscard]] std::uint64_t samples() const;

private:
    void cut(const QString& why);
};

// Files may have 2 GB: the readers ask `progress` once in 65 536 lines or samples, and fail with kCancelled when it says false.

/// The thesis's printed log (3.5.3.4.1): `level-count` pairs, after each group the sum of its counts. Typing slips are
/// expected: a count that is missing is mended from the sum, a sum glued to the next level is taken apart, a wrong
/// sum becomes a doubt. Levels are masks of sampled pins; lines that never move are kept. kBadInput without any pair.
[[nodiscard]] core::Result<LineCapture> captureFromRunText(std::string_view text, const Progress& progress = {});
/// sigrok's CSV: comments after `;`, a row of names when there is one, then a row of 0 and 1 for each sample.
/// kBadInput names the line that cannot be read.
[[nodiscard]] core::Result<LineCapture> captureFromCsv(std::string_view text, const Progress& progress = {});
/// IEEE 1364 value change dump: one-bit wires and vectors up to 32 lines in all. x and z count as low, with a doubt.
[[nodiscard]] core::Result<LineCapture> captureFromVcd(std::string_view text, const Progress& progress = {});
/// One to four bytes are a sample of eight lines each, the lowest first: sigrok's binary output, and what is inside its
/// session files. A torn last sample is left out. Whoever's `progress` says false gets a part of it.
[[nodiscard]] LineCapture captureFromSamples(std::string_view bytes, std::optional<double> samples_per_s,
                                             int bytes_per_sample = 1, const Progress& progress = {});

/// kSession is the log of PMTS's own recorder, kBytes what a terminal program stored: both hold bytes, not levels.
enum class CaptureFormat { kRunText, kCsv, kVcd, kSamples, kSession, kBytes };
/// By the first bytes. Text that is none of the others is kBytes, and so is what looks like a dialogue (mostly text with
/// ends of lines or blocks); other bytes are kSamples.
[[nodiscard]] CaptureFormat guessCaptureFormat(std::string_view bytes);

}  // namespace pmts::protocol
