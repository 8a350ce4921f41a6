#pragma once

#include "pmts/app/desk/file_saving.hpp"
#include "pmts/app/line/line_words.hpp"

#include <vector>

namespace pmts::gui {

/// Events as a table with a head: UTC, words, waits in ms, bytes. For any thread; stops early when told to.
[[nodiscard]] QByteArray timelineCsv(const std::vector<app::LineEvent>& events, const app::LineWords& words,
                                     const app::FileSaving::Progress& progress);

}  // namespace pmts::gui
