#pragma once

#include <QMetaType>

#include <optional>
#include <vector>

namespace pmts::video {

/// What of a camera can be set. Units: exposure in ms, white balance in K; gain, focus and zoom in the device's own.
enum class CameraControl { kExposure, kGain, kWhiteBalance, kFocus, kZoom };

/// One of them as a camera has it. What a camera does not have is not in its list.
struct ControlRange {
    CameraControl control = CameraControl::kExposure;
    double minimum = 0.0;
    double maximum = 0.0;
    double step = 1.0;
    double usual = 0.0;        ///< the device's default
    bool has_auto = false;     ///< the device can look after it by itself
    bool has_value = true;     ///< it can be set by hand

    [[nodiscard]] bool operator==(const ControlRange&) const = default;
};

/// A wish, or what the device says. The value of an automatic control is what the device has chosen, when it tells.
struct ControlValue {
    CameraControl control = CameraControl::kExposure;
    bool automatic = false;
    double value = 0.0;
    bool hold = false;  ///< a wish only: stop the automatic and keep what it has chosen; `value` does not count

    [[nodiscard]] bool operator==(const ControlValue&) const = default;
};

struct CameraControlState {
    ControlRange range;
    ControlValue value;

    [[nodiscard]] bool operator==(const CameraControlState&) const = default;
};

/// Replaces the wish for the same control, or adds it.
inline void remember(std::vector<ControlValue>& wishes, const ControlValue& wish) {
    for (ControlValue& known : wishes) {
        if (known.control == wish.control) {
            known = wish;
            return;
        }
    }
    wishes.push_back(wish);
}

/// The value that the range allows: within the limits, on a step, automatic only where there is an automatic.
[[nodiscard]] ControlValue allowed(const ControlRange& range, const ControlValue& wish);

}  // namespace pmts::video
