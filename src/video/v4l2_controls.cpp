#include "v4l2_controls.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <linux/videodev2.h>
#include <optional>
#include <sys/ioctl.h>

namespace pmts::video {
namespace {

/// How a control is spoken of in V4L2: one number for its value, one for the automatic.
struct KnownControl {
    CameraControl control;
    std::uint32_t value_id;
    std::uint32_t auto_id;  ///< 0: none
    double unit;            ///< ours for one of the driver's
    int manual;             ///< what the automatic's control says when it is off
};

constexpr std::array<KnownControl, 5> kControls{{
    {CameraControl::kExposure, V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_EXPOSURE_AUTO, 0.1, V4L2_EXPOSURE_MANUAL},
    {CameraControl::kGain, V4L2_CID_GAIN, V4L2_CID_AUTOGAIN, 1.0, 0},
    {CameraControl::kWhiteBalance, V4L2_CID_WHITE_BALANCE_TEMPERATURE, V4L2_CID_AUTO_WHITE_BALANCE, 1.0, 0},
    {CameraControl::kFocus, V4L2_CID_FOCUS_ABSOLUTE, V4L2_CID_FOCUS_AUTO, 1.0, 0},
    {CameraControl::kZoom, V4L2_CID_ZOOM_ABSOLUTE, 0, 1.0, 0},
}};

bool ask(int fd, unsigned long request, void* argument) {
    int outcome = 0;
    do {
        outcome = ::ioctl(fd, request, argument);
    } while (outcome == -1 && errno == EINTR);
    return outcome == 0;
}

std::optional<v4l2_queryctrl> describe(int fd, std::uint32_t id) {
    v4l2_queryctrl query{};
    query.id = id;
    const bool is_there = id != 0 && ask(fd, VIDIOC_QUERYCTRL, &query) && (query.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
    return is_there ? std::optional(query) : std::nullopt;
}

std::optional<int> valueOf(int fd, std::uint32_t id) {
    v4l2_control value{};
    value.id = id;
    return ask(fd, VIDIOC_G_CTRL, &value) ? std::optional(value.value) : std::nullopt;
}

bool set(int fd, std::uint32_t id, int value) {
    v4l2_control wish{};
    wish.id = id;
    wish.value = value;
    return ask(fd, VIDIOC_S_CTRL, &wish);
}

/// Cameras differ in what they call automatic exposure: most webcams know aperture priority only.
void setAutomatic(int fd, const KnownControl& known, bool automatic) {
    if (known.auto_id == 0) {
        return;
    }
    if (!automatic) {
        (void)set(fd, known.auto_id, known.manual);
    } else if (known.control != CameraControl::kExposure) {
        (void)set(fd, known.auto_id, 1);
    } else if (!set(fd, known.auto_id, V4L2_EXPOSURE_APERTURE_PRIORITY)) {
        (void)set(fd, known.auto_id, V4L2_EXPOSURE_AUTO);
    }
}

std::optional<CameraControlState> stateOf(int fd, const KnownControl& known) {
    const auto value = describe(fd, known.value_id);
    const auto automatic = describe(fd, known.auto_id);
    if (!value && !automatic) {
        return std::nullopt;
    }
    CameraControlState state;
    state.range = {.control = known.control, .has_auto = automatic.has_value(), .has_value = value.has_value()};
    state.value = {.control = known.control};
    if (value) {
        state.range.minimum = value->minimum * known.unit;
        state.range.maximum = value->maximum * known.unit;
        state.range.step = std::max(1, value->step) * known.unit;
        state.range.usual = value->default_value * known.unit;
        state.value.value = valueOf(fd, known.value_id).value_or(value->default_value) * known.unit;
    }
    if (automatic) {
        state.value.automatic = valueOf(fd, known.auto_id).value_or(known.manual) != known.manual;
    }
    return state;
}

}  // namespace

std::vector<CameraControlState> v4l2Controls(int fd) {
    std::vector<CameraControlState> all;
    for (const KnownControl& known : kControls) {
        if (const auto state = stateOf(fd, known)) {
            all.push_back(*state);
        }
    }
    return all;
}

void setV4l2Control(int fd, const ControlValue& wish) {
    const auto known = std::ranges::find(kControls, wish.control, &KnownControl::control);
    const auto state = known == kControls.end() ? std::nullopt : stateOf(fd, *known);
    if (!state) {
        return;
    }
    ControlValue next = allowed(state->range, wish);
    if (wish.hold) {
        next = {.control = wish.control, .automatic = false, .value = state->value.value};
    }
    setAutomatic(fd, *known, next.automatic);
    if (!next.automatic && state->range.has_value) {
        (void)set(fd, known->value_id, static_cast<int>(std::lround(next.value / known->unit)));
    }
}

}  // namespace pmts::video
