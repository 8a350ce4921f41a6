#pragma once

#include "pmts/protocol/line_capture.hpp"

#include <cmath>
#include <random>
#include <string>
#include <string_view>

namespace pmts::protocol::test {

/// How a line is sampled in a test; written from EIA-404, not from the decoder.
struct Sampling {
    double samples_per_bit = 16.0;
    double flipped = 0.0;  ///< share of the samples that read the other level
    int data_bits = 8;
    char parity = 'N';
    bool idle_high = true;
    bool least_first = true;
    double pause_bits = 40.0;  ///< before, and after the text
    unsigned seed = 1;
};

/// Samples of a text on line 0, one byte each.
inline std::string samplesOf(std::string_view text, const Sampling& how) {
    std::string levels;  // one bit each, '1' or '0', line levels
    const auto put = [&](bool one) { levels += one == how.idle_high ? '1' : '0'; };
    std::string bits(static_cast<std::size_t>(how.pause_bits), how.idle_high ? '1' : '0');
    for (const char c : text) {
        put(false);
        int ones = 0;
        for (int i = 0; i < how.data_bits; ++i) {
            const int place = how.least_first ? i : how.data_bits - 1 - i;
            const bool one = (static_cast<unsigned char>(c) >> place) & 1;
            ones += one ? 1 : 0;
            put(one);
        }
        if (how.parity != 'N') {
            put((ones % 2 != 0) == (how.parity == 'E'));
        }
        put(true);
    }
    const std::string all = bits + levels + bits;
    std::mt19937 random(how.seed);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    std::string samples;
    const auto count = static_cast<std::size_t>(std::floor(static_cast<double>(all.size()) * how.samples_per_bit));
    for (std::size_t i = 0; i < count; ++i) {
        const auto bit = static_cast<std::size_t>(static_cast<double>(i) / how.samples_per_bit);
        const bool high = (all[std::min(bit, all.size() - 1)] == '1') != (chance(random) < how.flipped);
        samples += high ? '\x01' : '\x00';
    }
    return samples;
}

}  // namespace pmts::protocol::test
