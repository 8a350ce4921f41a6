#include "bus_stream.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pmts::instrument {
namespace {

constexpr int kVaLabel = 166, kHaLabel = 165;
constexpr std::size_t kDecimals = 5;
constexpr double kFullCircle_gon = 400.0;
/// Noise of a standing instrument and a knob touched lightly.
constexpr core::Angle kStill = core::Angle::fromCc(20);
/// Faster than any of these instruments turns.
constexpr double kFastestGonPerSecond = 80.0;
constexpr core::Duration kNoisyLasts = std::chrono::seconds(30);
constexpr int kInRow = 1, kInRowWhenNoisy = 3;

struct Line {
    int label = 0;
    core::Angle angle;
};

std::optional<Line> lineOf(std::string_view text) {
    const auto equals = text.find('=');
    const auto point = text.find('.');
    if (!text.starts_with("A,") || equals == std::string_view::npos || point == std::string_view::npos ||
        text.size() - point - 1 != kDecimals || text.substr(equals + 1).starts_with('-')) {
        return std::nullopt;
    }
    Line line;
    double gon = 0;
    const auto* const label_end = text.data() + equals;
    const auto* const end = text.data() + text.size();
    const auto label = std::from_chars(text.data() + 2, label_end, line.label);
    const auto number = std::from_chars(label_end + 1, end, gon, std::chars_format::fixed);
    if (label.ec != std::errc() || label.ptr != label_end || number.ec != std::errc() || number.ptr != end ||
        !(gon >= 0.0 && gon < kFullCircle_gon)) {
        return std::nullopt;
    }
    line.angle = core::Angle::fromGon(gon);
    return line;
}

core::Angle apart(const geometry::Pointing& a, const geometry::Pointing& b) {
    return std::max(core::abs(core::normalizedSigned(a.ha - b.ha)), core::abs(core::normalizedSigned(a.va - b.va)));
}

core::Angle reach(core::Duration span) {
    return kStill + core::Angle::fromGon(kFastestGonPerSecond * std::chrono::duration<double>(span).count());
}

}  // namespace

std::optional<geometry::Pointing> pointingOfStream(std::string_view block) {
    std::optional<core::Angle> ha, va;
    while (!block.empty()) {
        const auto end = std::min(block.find_first_of("\r\n"), block.size());
        if (end > 0) {
            const auto line = lineOf(block.substr(0, end));
            const bool known = line && (line->label == kVaLabel || line->label == kHaLabel);
            auto& place = known && line->label == kVaLabel ? va : ha;
            if (!known || place) {
                return std::nullopt;
            }
            place = line->angle;
        }
        block.remove_prefix(std::min(end + 1, block.size()));
    }
    return ha && va ? std::optional(geometry::Pointing{.ha = *ha, .va = *va}) : std::nullopt;
}

std::optional<geometry::Pointing> BusStream::take(std::string_view block, core::Duration at) {
    const auto pointing = pointingOfStream(block);
    if (!pointing) {
        damaged_at_ = at;
        return std::nullopt;
    }
    const auto isNear = [&](const std::optional<Reading>& other, core::Angle limit) {
        return other && apart(*pointing, other->pointing) <= limit;
    };
    const bool stands = isNear(believed_, kStill);
    const bool possible = !believed_ || isNear(believed_, reach(at - believed_->at));
    const bool goes_on = is_turning_ && possible && !isNoisy(at);
    const bool fits = possible && doubtful_ && isNear(doubtful_, reach(at - doubtful_->at));
    in_row_ = fits ? in_row_ + 1 : 0;
    if (!stands && !goes_on && in_row_ < (isNoisy(at) ? kInRowWhenNoisy : kInRow)) {
        doubtful_ = Reading{.pointing = *pointing, .at = at};
        return std::nullopt;
    }
    is_turning_ = !stands && !(fits && isNear(doubtful_, kStill));
    believed_ = Reading{.pointing = *pointing, .at = at};
    doubtful_.reset();
    in_row_ = 0;
    return pointing;
}

bool BusStream::isNoisy(core::Duration at) const { return damaged_at_ && at - *damaged_at_ < kNoisyLasts; }

}  // namespace pmts::instrument
