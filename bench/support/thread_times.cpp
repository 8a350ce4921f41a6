#include "thread_times.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace pmts::bench {
namespace {

struct ThreadTime {
    std::string name;
    double seconds = 0.0;
};

/// Fields 14 and 15 of /proc/self/task/<id>/stat, counted after the name in brackets.
ThreadTime timeOf(const std::filesystem::path& task) {
    std::ifstream file(task / "stat");
    const std::string line((std::istreambuf_iterator<char>(file)), {});
    const auto open = line.find('(');
    const auto close = line.rfind(')');
    if (open == std::string::npos || close == std::string::npos) {
        return {};  // the thread ended meanwhile
    }
    std::istringstream fields(line.substr(close + 2));
    std::string skipped;
    for (int field = 3; field < 14; ++field) {
        fields >> skipped;
    }
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return {line.substr(open + 1, close - open - 1),
            (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK))};
}

}  // namespace

double cpuSecondsWithout(const std::vector<std::string>& left_out) {
    double total = 0.0;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        const ThreadTime time = timeOf(task.path());
        const bool counts = std::ranges::none_of(
            left_out, [&](const std::string& name) { return time.name.starts_with(name); });
        total += counts ? time.seconds : 0.0;
    }
    return total;
}

double cpuSecondsOf(const std::string& name) { return cpuSecondsWithout({}) - cpuSecondsWithout({name}); }

double residentMemoryMb() {
    std::ifstream file("/proc/self/statm");
    double size_pages = 0.0, resident_pages = 0.0;
    file >> size_pages >> resident_pages;
    return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

}  // namespace pmts::bench
