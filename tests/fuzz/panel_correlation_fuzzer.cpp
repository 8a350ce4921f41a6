#include "fuzz_input.hpp"

#include "pmts/protocol/panel_correlation.hpp"

#include <cmath>

using namespace pmts::protocol;
using pmts::fuzz::demand;

/// The first line is what somebody typed, the rest what came over the bus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = pmts::fuzz::textOf(data, size);
    const std::size_t cut = std::min(text.find('\n'), text.size());
    std::vector<DecodedCharacter> characters;
    for (const char byte : text.substr(cut)) {
        characters.push_back({.value = static_cast<unsigned char>(byte), .sample = characters.size()});
    }
    const auto values = streamValues(characters);
    for (const StreamValue& value : values) {
        demand(std::isfinite(value.value), "a value of the stream is finite");
    }
    const auto typed = QString::fromLatin1(text.data(), static_cast<qsizetype>(cut));
    if (const auto matches = correlated(typed, values)) {
        demand(matches->size() <= 10, "at most ten candidates");
        for (const PanelMatch& match : *matches) {
            demand(match.score >= 0.0 && match.score <= 1.0, "a score is from 0 to 1");
        }
    }
    return 0;
}
