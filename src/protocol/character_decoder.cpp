#include "character_decoder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pmts::protocol {
namespace {

constexpr double kGlitch = 0.2;  ///< of a bit: what is shorter changes nothing
constexpr double kSkirt = 0.15;  ///< of a bit at each end: edges wander there
constexpr double kWholeCharacter = 13.0;  ///< bits: no framing has longer ones

}  // namespace

CharacterDecoder::CharacterDecoder(const LineRuns& runs, const Framing& framing)
    : runs_(runs), framing_(framing), edges_(withoutGlitches(runs, kGlitch * framing.samples_per_bit)) {}

/// To the next stretch that may be a start bit.
bool CharacterDecoder::toNextEdge() {
    while (edge_ < edges_.size() && edges_.isHigh(edge_) == framing_.idle_high) {
        ++edge_;
    }
    if (edge_ == edges_.size()) {
        return false;
    }
    while (run_ < runs_.size() && runs_.endOf(run_) <= edges_.begins[edge_]) {
        ++run_;
    }
    return true;
}

/// Samples at high level in [from, to), counted from the character's first stretch.
double CharacterDecoder::highTime(double from, double to) const {
    double high = 0.0;
    for (std::size_t run = run_; run < runs_.size() && static_cast<double>(runs_.begins[run]) < to; ++run) {
        if (runs_.isHigh(run)) {
            const double begin = std::max(from, static_cast<double>(runs_.begins[run]));
            const double end = std::min(to, static_cast<double>(runs_.endOf(run)));
            high += std::max(0.0, end - begin);
        }
    }
    if (to > static_cast<double>(runs_.end) && framing_.idle_high) {
        high += to - std::max(from, static_cast<double>(runs_.end));  // after the capture the line rests
    }
    return high;
}

CharacterDecoder::Bit CharacterDecoder::bitAt(double begin) const {
    const double bit = framing_.samples_per_bit;
    double from = begin + kSkirt * bit;
    double to = begin + (1.0 - kSkirt) * bit;
    if (to - from < 1.0) {  // one sample or two for each bit: the one in the middle
        from = std::floor(begin + 0.5 * bit);
        to = from + 1.0;
    }
    const double share = highTime(from, to) / (to - from);
    return {.high = share > 0.5, .margin = std::abs(2.0 * share - 1.0)};
}

DecodedCharacter CharacterDecoder::read(double begin) const {
    const double bit = framing_.samples_per_bit;
    DecodedCharacter character{.sample = static_cast<std::uint64_t>(begin)};
    unsigned value = 0;
    const auto take = [&](int place) {
        const Bit read = bitAt(begin + place * bit);
        character.margin = std::min(character.margin, static_cast<float>(read.margin));
        return read.high == framing_.idle_high;  // a one is the level of rest
    };
    for (int i = 0; i < framing_.data_bits; ++i) {
        const int weight = framing_.least_significant_first ? i : framing_.data_bits - 1 - i;
        value |= take(1 + i) ? 1U << weight : 0U;
    }
    character.value = static_cast<unsigned char>(value);
    int place = 1 + framing_.data_bits;
    if (framing_.parity != LineParity::kNone) {
        const bool odd_ones = (std::popcount(value) + (take(place++) ? 1 : 0)) % 2 != 0;
        character.parity_error = odd_ones != (framing_.parity == LineParity::kOdd);
    }
    character.framing_error = !take(place);
    return character;
}

void CharacterDecoder::goOnAfter(double sample) {
    while (edge_ < edges_.size() && static_cast<double>(edges_.endOf(edge_)) <= sample) {
        ++edge_;
    }
}

/// Every character that begins up to a sample.
void CharacterDecoder::readTo(double last_begin, std::vector<DecodedCharacter>& characters) {
    const int parity_bits = framing_.parity == LineParity::kNone ? 0 : 1;
    const double to_stop = (1.5 + framing_.data_bits + parity_bits) * framing_.samples_per_bit;
    while (toNextEdge()) {
        const auto begin = static_cast<double>(edges_.begins[edge_]);
        if (begin > last_begin) {
            return;
        }
        if (bitAt(begin).high == framing_.idle_high) {
            ++edge_;  // no start bit
            continue;
        }
        characters.push_back(read(begin));
        goOnAfter(characters.back().framing_error ? begin + framing_.samples_per_bit : begin + to_stop);
        if (edge_ < edges_.size() && static_cast<double>(edges_.begins[edge_]) <= begin) {
            ++edge_;  // a break: the line stays active
        }
    }
}

std::vector<DecodedCharacter> CharacterDecoder::all() {
    std::vector<DecodedCharacter> characters;
    readTo(static_cast<double>(runs_.end), characters);
    return characters;
}

std::uint64_t CharacterDecoder::readOn(std::vector<DecodedCharacter>& characters) {
    readTo(static_cast<double>(runs_.end) - kWholeCharacter * framing_.samples_per_bit, characters);
    const std::size_t rest = std::min(edge_, edges_.size() - 1);
    return edges_.begins[rest];
}

}  // namespace pmts::protocol
