#include "fuzz_input.hpp"

#include "pmts/protocol/line_decoding.hpp"
#include "pmts/protocol/panel_correlation.hpp"

#include <algorithm>
#include <cmath>

using namespace pmts::protocol;
using pmts::fuzz::demand;

namespace {

constexpr std::uint64_t kMostSamples = 20'000;  ///< a count in a text may claim any number of them
constexpr int kMostLines = 2;                   ///< each is decoded in every framing: the first ones do
constexpr std::size_t kMostRuns = 200;          ///< that the search looks at

void checkRuns(const LineCapture& capture) {
    for (std::size_t i = 0; i < capture.runs.size(); ++i) {
        demand(capture.runs[i].samples > 0, "no run is empty");
        demand(i == 0 || capture.runs[i].levels != capture.runs[i - 1].levels || capture.runs[i - 1].samples == UINT32_MAX,
               "neighbouring runs differ");
    }
    for (const CaptureDoubt& doubt : capture.doubts) {
        demand(!doubt.what.isEmpty(), "a doubt has a sentence");
    }
}

void decode(const LineCapture& capture, int line) {
    for (const FramingScore& found : findFraming(capture, line, kMostRuns)) {
        demand(std::isfinite(found.score) && found.score >= 0.0 && found.score <= 1.0, "a score is from 0 to 1");
        const auto characters = decodeLine(capture, found.framing);
        (void)textOf(characters);
        (void)streamValues(characters);
    }
}

void examine(const LineCapture& capture) {
    checkRuns(capture);
    if (capture.samples() > kMostSamples) {
        return;
    }
    (void)portKind(lineActivities(capture));
    if (const auto bits = dereplicated(capture)) {
        checkRuns(*bits);
    }
    for (int line = 0; line < std::min(capture.lines, kMostLines); ++line) {
        decode(capture, line);
    }
}

}  // namespace

/// Every reader of captures, whatever the bytes look like, and what is found in the result.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = pmts::fuzz::textOf(data, size);
    (void)guessCaptureFormat(bytes);
    for (const auto& read : {captureFromRunText, captureFromCsv, captureFromVcd}) {
        if (const auto capture = read(bytes, {})) {
            examine(*capture);
        } else {
            demand(!capture.error().sentence().isEmpty(), "a refusal has a sentence");
        }
    }
    examine(captureFromSamples(bytes, std::nullopt, 1 << (size % 3)));
    return 0;
}
