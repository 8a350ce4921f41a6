#include "fuzz_input.hpp"

#include "pmts/protocol/command.hpp"

#include <algorithm>
#include <string>

using namespace pmts::protocol;
using pmts::fuzz::demand;

/// Whatever a console is given: no text that the instrument may read as an erasing or service command passes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view line = pmts::fuzz::textOf(data, size);
    if (!checkDenyList(line)) {
        return 0;
    }
    // Each CR ends a command; LF and blanks before one are passed over by the instrument.
    std::string_view rest = line;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\r'), rest.size());
        std::string_view command = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::size_t begin = command.find_first_not_of(" \n");
        if (begin == std::string_view::npos) {
            continue;
        }
        command.remove_prefix(begin);
        demand(command[0] != 'K', "an erasing command passed");
        demand(!command.starts_with("LV") && !command.starts_with("OV"), "a service command passed");
    }
    return 0;
}
