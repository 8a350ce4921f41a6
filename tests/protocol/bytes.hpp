#pragma once

#include <sstream>
#include <string>

namespace pmts::test {

/// `52 47 0D` -> bytes, as the protocol page prints its vectors.
inline std::string bytesFromHex(const std::string& hex) {
    std::string bytes;
    std::istringstream in(hex);
    for (std::string pair; in >> pair;) {
        bytes += static_cast<char>(std::stoi(pair, nullptr, 16));
    }
    return bytes;
}

}  // namespace pmts::test
