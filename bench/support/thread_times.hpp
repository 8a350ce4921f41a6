#pragma once

#include <string>
#include <vector>

namespace pmts::bench {

/// Processor time this process has used so far, without the threads whose name begins with one of `left_out`.
[[nodiscard]] double cpuSecondsWithout(const std::vector<std::string>& left_out);

/// The same of those threads only.
[[nodiscard]] double cpuSecondsOf(const std::string& name);

/// Resident memory now, in MB of 10^6 bytes.
[[nodiscard]] double residentMemoryMb();

}  // namespace pmts::bench
