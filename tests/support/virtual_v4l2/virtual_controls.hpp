#pragma once

#include <linux/videodev2.h>
#include <mutex>
#include <string>
#include <vector>

namespace pmts::virtual_v4l2 {

/// The controls of one camera. They outlive the open file, as in a real camera; an unplugged one forgets them.
class VirtualControls {
public:
    [[nodiscard]] static VirtualControls& of(const std::string& path);

    /// VIDIOC_QUERYCTRL, G_CTRL or S_CTRL: 0 or an error number.
    [[nodiscard]] int answer(unsigned long request, void* argument);
    void forget();  ///< back to what the maker set

private:
    struct Control {
        __u32 id;
        const char* name;
        __u32 type;
        int minimum, maximum, step, usual;
        int value;
    };
    static std::vector<Control> fresh();
    Control* find(__u32 id);

    std::mutex mutex_;
    std::vector<Control> controls_ = fresh();
};

}  // namespace pmts::virtual_v4l2
