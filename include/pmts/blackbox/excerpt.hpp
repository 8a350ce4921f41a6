#pragma once

#include "pmts/blackbox/recording.hpp"
#include "pmts/blackbox/scrubber.hpp"

#include <QDateTime>

#include <map>

namespace pmts::blackbox {

/// The newest records of some recordings as one file.
struct Excerpt {
    QByteArray bytes;
    std::map<Kind, int> records;  ///< how many of each kind are in it
    QDateTime from_utc, to_utc;
};

struct ExcerptOrder {
    core::Duration last{std::chrono::minutes(10)};  ///< before the newest record
    bool pictures = true;
    Scrubber scrubber;
};

/// Records of one run of the program, oldest file first (all share a clock). What holds on (connection, control) is kept
/// even when it was said before. Pictures are not scrubbed.
[[nodiscard]] Excerpt excerptOf(const std::vector<std::shared_ptr<const Recording>>& recordings, const ExcerptOrder& order);

}  // namespace pmts::blackbox
