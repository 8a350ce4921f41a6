#pragma once

#include "pmts/blackbox/recording.hpp"

#include <memory>
#include <vector>

namespace pmts::blackbox {

/// The black box files of the run that a file belongs to, oldest first: those beside it that share its `run` and so its
/// clock, whatever the time of day did meanwhile. The file alone when it says no run or is an excerpt.
[[nodiscard]] QStringList filesOfRun(const QString& path);

/// The files of one run as one recording. What was said again at the beginning of a file, and was so already, is left out.
class Run {
public:
    struct Place {
        std::size_t file = 0;
        Entry entry;
        bool is_distance = false;  ///< a reading with a distance
        bool is_toast = false;     ///< a message that does not stand
    };

    /// A file with all others of its run; kFile when the file itself cannot be read. Not on the GUI thread.
    [[nodiscard]] static core::Result<std::shared_ptr<const Run>> open(const QString& path);
    explicit Run(std::vector<std::shared_ptr<const Recording>> files, std::size_t chosen = 0);

    [[nodiscard]] const std::vector<Place>& places() const { return places_; }
    [[nodiscard]] QCborMap body(const Place& place) const { return files_[place.file]->body(place.entry); }
    [[nodiscard]] std::size_t chosen() const { return chosen_; }  ///< file that was asked for
    [[nodiscard]] std::size_t files() const { return files_.size(); }
    [[nodiscard]] int damages() const;

private:
    std::vector<std::shared_ptr<const Recording>> files_;
    std::size_t chosen_ = 0;
    std::vector<Place> places_;
};

/// Whether a record says how things stand, until the next of its kind.
[[nodiscard]] bool holdsOn(Kind kind);

}  // namespace pmts::blackbox
