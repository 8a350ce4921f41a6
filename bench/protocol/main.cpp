#include "pmts/protocol/panel_correlation.hpp"
#include "support/figure.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <string>
#include <sys/resource.h>

// What the lab waits for: 100 MB of samples from the file in memory to text, pins and framing included. Once as a probe
// at 1 MHz sees the running stream of dialect B, once without a pause at eight samples for each bit with 2 % of the samples
// flipped, and once as dense as a line can be: one sample for each bit, never at rest.
namespace {

using namespace pmts;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBytes = 100'000'000;
constexpr std::string_view kBlock = "A,166=96.16838\rA,165=177.56115\x04";
constexpr double kTarget_s = 5.0;
constexpr int kRounds = 3;

/// Samples of the block with a pause after it, over and over.
std::string captureOf(double samples_per_bit, int pause_bits, double flipped) {
    std::string bits;
    for (const char c : kBlock) {
        bits += '0';
        for (int i = 0; i < 8; ++i) {
            bits += (static_cast<unsigned char>(c) >> i) & 1 ? '1' : '0';
        }
        bits += '1';
    }
    bits.append(static_cast<std::size_t>(pause_bits), '1');
    std::string samples(kBytes, '\0');
    std::mt19937 random(7);
    const auto limit = static_cast<std::mt19937::result_type>(flipped * static_cast<double>(std::mt19937::max()));
    for (std::size_t i = 0; i < kBytes; ++i) {
        const auto bit = static_cast<std::size_t>(static_cast<double>(i) / samples_per_bit) % bits.size();
        const bool flip = flipped > 0.0 && random() < limit;
        samples[i] = (bits[bit] == '1') != flip ? '\x1F' : '\x0F';
    }
    return samples;
}

struct Outcome {
    double seconds = 0.0;
    double right_share = 0.0;  ///< of the values that were sent
    double wrong = 0.0;        ///< values that are sure and were never sent
};

Outcome decode(const std::string& samples, double sent_values) {
    const auto begin = Clock::now();
    const auto capture = protocol::captureFromSamples(samples, 1e6);
    const auto pins = protocol::lineActivities(capture);
    const auto data = std::ranges::find(pins, protocol::LineUse::kData, &protocol::LineActivity::use);
    const auto framing = protocol::findFraming(capture, data == pins.end() ? 0 : data->line);
    const auto characters = framing.empty() ? std::vector<protocol::DecodedCharacter>()
                                            : protocol::decodeLine(capture, framing.front().framing);
    const auto values = protocol::streamValues(characters);
    Outcome outcome{.seconds = std::chrono::duration<double>(Clock::now() - begin).count()};
    const auto right = std::ranges::count_if(values, [](const protocol::StreamValue& value) {
        return (value.variable == 166 && value.value == 96.16838) || (value.variable == 165 && value.value == 177.56115);
    });
    outcome.right_share = static_cast<double>(right) / sent_values;
    outcome.wrong = static_cast<double>(values.size()) - static_cast<double>(right);
    return outcome;
}

void report(const std::string& name, double samples_per_bit, int pause_bits, double flipped, double least_share) {
    const std::string samples = captureOf(samples_per_bit, pause_bits, flipped);
    const double block_bits = 10.0 * static_cast<double>(kBlock.size()) + pause_bits;
    const double sent_values = 2.0 * static_cast<double>(kBytes) / (samples_per_bit * block_bits);
    std::vector<double> seconds;
    Outcome outcome;
    for (int round = 0; round < kRounds; ++round) {
        outcome = decode(samples, sent_values);
        seconds.push_back(outcome.seconds);
    }
    bench::figure("protocol.decode_100MB_" + name, bench::median(seconds), "s", bench::Wanted::kAtMost, kTarget_s);
    bench::figure("protocol.right_values_" + name, 100.0 * outcome.right_share, "%", bench::Wanted::kAtLeast, least_share);
    bench::figure("protocol.wrong_values_" + name, outcome.wrong, "values", bench::Wanted::kAtMost, 0);
}

/// Most memory this process ever had, less the samples themselves.
double peakMemory_MB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0 - static_cast<double>(kBytes) / 1e6;
}

}  // namespace

int main() {
    report("stream", 1e6 / 9600.0, 2500, 0.0, 99.0);
    // A bit is five or six samples then: every second value has one that two flips make unsure.
    report("dense_2_percent_flipped", 8.0, 0, 0.02, 40.0);
    report("one_sample_a_bit", 1.0, 0, 0.0, 99.0);
    bench::figure("protocol.memory_of_100MB", peakMemory_MB(), "MB", bench::Wanted::kAtMost, 1000);
}
