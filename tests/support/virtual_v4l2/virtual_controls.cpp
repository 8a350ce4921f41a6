#include "virtual_controls.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>

namespace pmts::virtual_v4l2 {

VirtualControls& VirtualControls::of(const std::string& path) {
    static auto* const mutex = new std::mutex;  // never destroyed: programs use cameras until their very end
    static auto* const known = new std::map<std::string, VirtualControls>;
    const std::lock_guard lock(*mutex);
    return (*known)[path];
}

std::vector<VirtualControls::Control> VirtualControls::fresh() {
    const auto number = [](__u32 id, const char* name, int minimum, int maximum, int step, int usual) {
        return Control{id, name, V4L2_CTRL_TYPE_INTEGER, minimum, maximum, step, usual, usual};
    };
    const auto onOff = [](__u32 id, const char* name) {
        return Control{id, name, V4L2_CTRL_TYPE_BOOLEAN, 0, 1, 1, 1, 1};
    };
    return {{V4L2_CID_EXPOSURE_AUTO, "Auto Exposure", V4L2_CTRL_TYPE_MENU, 0, 3, 1, 3, 3},
            number(V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure Time, Absolute", 3, 2047, 1, 250),
            number(V4L2_CID_GAIN, "Gain", 0, 255, 1, 16),
            onOff(V4L2_CID_AUTO_WHITE_BALANCE, "White Balance, Automatic"),
            number(V4L2_CID_WHITE_BALANCE_TEMPERATURE, "White Balance Temperature", 2000, 7500, 10, 4000),
            onOff(V4L2_CID_FOCUS_AUTO, "Focus, Automatic Continuous"),
            number(V4L2_CID_FOCUS_ABSOLUTE, "Focus, Absolute", 0, 255, 5, 0)};
}

VirtualControls::Control* VirtualControls::find(__u32 id) {
    const auto found = std::find_if(controls_.begin(), controls_.end(), [id](const Control& c) { return c.id == id; });
    return found == controls_.end() ? nullptr : &*found;
}

void VirtualControls::forget() {
    const std::lock_guard lock(mutex_);
    controls_ = fresh();
}

int VirtualControls::answer(unsigned long request, void* argument) {
    const std::lock_guard lock(mutex_);
    if (request == VIDIOC_QUERYCTRL) {
        auto& query = *static_cast<v4l2_queryctrl*>(argument);
        const Control* const control = find(query.id);
        if (control == nullptr) {
            return EINVAL;
        }
        query = {};
        query.id = control->id;
        query.type = control->type;
        std::snprintf(reinterpret_cast<char*>(query.name), sizeof query.name, "%s", control->name);
        query.minimum = control->minimum;
        query.maximum = control->maximum;
        query.step = control->step;
        query.default_value = control->usual;
        return 0;
    }
    auto& value = *static_cast<v4l2_control*>(argument);
    Control* const control = find(value.id);
    if (control == nullptr) {
        return EINVAL;
    }
    if (request == VIDIOC_G_CTRL) {
        value.value = control->value;
        return 0;
    }
    const bool unknown_mode = control->id == V4L2_CID_EXPOSURE_AUTO && value.value != V4L2_EXPOSURE_MANUAL &&
                              value.value != V4L2_EXPOSURE_APERTURE_PRIORITY;
    if (unknown_mode || value.value < control->minimum || value.value > control->maximum) {
        return unknown_mode ? EINVAL : ERANGE;
    }
    const __u32 automatic = control->id == V4L2_CID_EXPOSURE_ABSOLUTE             ? V4L2_CID_EXPOSURE_AUTO
                            : control->id == V4L2_CID_WHITE_BALANCE_TEMPERATURE ? V4L2_CID_AUTO_WHITE_BALANCE
                            : control->id == V4L2_CID_FOCUS_ABSOLUTE            ? V4L2_CID_FOCUS_AUTO
                                                                                : 0;
    const Control* const governor = find(automatic);
    const int off = automatic == V4L2_CID_EXPOSURE_AUTO ? V4L2_EXPOSURE_MANUAL : 0;
    if (governor != nullptr && governor->value != off) {
        return EACCES;  // an automatic has it in hand, as the UVC driver answers
    }
    control->value = control->minimum + (value.value - control->minimum) / control->step * control->step;
    return 0;
}

}  // namespace pmts::virtual_v4l2
