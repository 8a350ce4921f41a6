#include "file_store.hpp"

#include "label_store.hpp"

#include <algorithm>

namespace pmts::simulator {
namespace {

constexpr std::size_t kLongestName = 15;
constexpr std::string_view kAlwaysThere = "MI";  // job 0 and area 0

/// Label of the lines of a directory listing; the manual does not print it, the job and area labels are
/// likely.
std::string nameLine(char directory, const std::string& name) {
    return (directory == 'I' ? "15=" : "50=") + name;
}

int checkLine(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
        return kBadSeparator;
    }
    const std::string_view label = line.substr(0, equals);
    const bool is_label = !label.empty() && label.size() <= 3 &&
                          label.find_first_not_of("0123456789") == std::string_view::npos;
    return is_label && equals + 1 < line.size() ? kAccepted : kBadData;
}

int sizeOf(const std::vector<std::string>& lines) {
    int bytes = 0;
    for (const std::string& line : lines) {
        bytes += static_cast<int>(line.size()) + 1;
    }
    return bytes;
}

}  // namespace

bool FileStore::isName(std::string_view name) { return !name.empty() && name.size() <= kLongestName; }

void FileStore::eraseAll() {
    files_.clear();
    for (const char directory : kAlwaysThere) {
        files_[directory]["0"];
    }
}

std::vector<std::string> FileStore::list(char directory) const {
    std::vector<std::string> names;
    for (const auto& [folder, files] : files_) {
        if (folder != directory && directory != '*') {
            continue;
        }
        std::ranges::transform(files, std::back_inserter(names),
                               [&](const auto& file) { return nameLine(folder, file.first); });
    }
    return names;
}

std::optional<std::vector<std::string>> FileStore::lines(char directory, const std::string& name) const {
    const auto folder = files_.find(directory);
    if (folder == files_.end()) {
        return std::nullopt;
    }
    const auto file = folder->second.find(name);
    return file == folder->second.end() ? std::nullopt : std::optional(file->second);
}

int FileStore::add(char directory, const std::string& name, const std::vector<std::string>& lines) {
    if (exists(directory, name)) {
        return kFileExists;
    }
    for (const std::string& line : lines) {
        if (const int code = checkLine(line); code != kAccepted) {
            return code;
        }
    }
    return append(directory, name, lines);
}

int FileStore::append(char directory, const std::string& name, const std::vector<std::string>& lines) {
    if (sizeOf(lines) > freeBytes()) {
        return kMemoryFull;
    }
    auto& file = files_[directory][name];
    file.insert(file.end(), lines.begin(), lines.end());
    return kAccepted;
}

int FileStore::erase(char directory, const std::optional<std::string>& name) {
    if (directory == '*') {
        eraseAll();
        return kAccepted;
    }
    if (!name) {
        files_.erase(directory);
    } else if (!exists(directory, *name)) {
        return kNotFound;
    } else {
        files_[directory].erase(*name);
    }
    if (kAlwaysThere.find(directory) != std::string_view::npos) {
        files_[directory]["0"];
    }
    return kAccepted;
}

int FileStore::freeBytes() const {
    int used = 0;
    for (const auto& [folder, files] : files_) {
        for (const auto& [name, lines] : files) {
            used += sizeOf(lines);
        }
    }
    return capacity_bytes_ - used;
}

}  // namespace pmts::simulator
