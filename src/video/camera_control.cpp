#include "pmts/video/camera_control.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::video {

ControlValue allowed(const ControlRange& range, const ControlValue& wish) {
    ControlValue value = wish;
    value.automatic = range.has_auto && (wish.automatic || !range.has_value);
    value.value = std::clamp(wish.value, range.minimum, range.maximum);
    if (range.step > 0.0) {
        const double steps = std::round((value.value - range.minimum) / range.step);
        value.value = std::min(range.minimum + steps * range.step, range.maximum);
    }
    return value;
}

}  // namespace pmts::video
