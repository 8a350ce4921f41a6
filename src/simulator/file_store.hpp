#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::simulator {

/// Info codes of the file commands (protocol page 2.7).
inline constexpr int kNotFound = 32, kFileExists = 33, kBadSeparator = 34, kMemoryFull = 36;

/// The instrument's files: jobs (M), areas (I), user sequences (U). Job 0 and area 0 always exist.
class FileStore {
public:
    explicit FileStore(int capacity_bytes) : capacity_bytes_(capacity_bytes) { eraseAll(); }

    /// `directory` is M, I, U or D; `*` for all of them. One `label=name` line a file.
    [[nodiscard]] std::vector<std::string> list(char directory) const;
    [[nodiscard]] std::optional<std::vector<std::string>> lines(char directory,
                                                                const std::string& name) const;
    [[nodiscard]] bool exists(char directory, const std::string& name) const {
        return lines(directory, name).has_value();
    }
    /// Info code: 0, 33 it exists, 34 a line without `=`, 35 a line without label or value, 36 no room.
    int add(char directory, const std::string& name, const std::vector<std::string>& lines);
    /// More lines for a file, which is made when missing. Info code: 0 or 36.
    int append(char directory, const std::string& name, const std::vector<std::string>& lines);
    /// Info code: 0 or 32. Without a name every file of the directory; `*` as directory everything.
    int erase(char directory, const std::optional<std::string>& name);
    [[nodiscard]] int freeBytes() const;

    [[nodiscard]] static bool isName(std::string_view name);  ///< 1 to 15 characters

private:
    void eraseAll();

    int capacity_bytes_;
    std::map<char, std::map<std::string, std::vector<std::string>>> files_;
};

}  // namespace pmts::simulator
