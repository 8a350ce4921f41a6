#pragma once

#include "test_picture.hpp"

#include <condition_variable>
#include <deque>
#include <linux/videodev2.h>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pmts::virtual_v4l2 {

/// One opened camera node: formats, buffers in a memory file, and a thread that fills them 30 times a second.
class VirtualDevice {
public:
    /// `event_fd` becomes readable for each filled buffer; the device writes to it but does not own it.
    VirtualDevice(std::string path, int event_fd, bool nonblocking);
    ~VirtualDevice();
    VirtualDevice(const VirtualDevice&) = delete;
    VirtualDevice& operator=(const VirtualDevice&) = delete;

    /// Answers an ioctl: 0 or an error number.
    [[nodiscard]] int control(unsigned long request, void* argument);
    [[nodiscard]] int memoryFd() const { return memory_fd_; }

private:
    enum class Owner { kProgram, kDriver, kFilled };
    struct Buffer {
        Owner owner = Owner::kProgram;
        std::uint32_t sequence = 0;
        timeval captured_at{};
        std::uint32_t filled_bytes = 0;
    };

    bool hasControls() const;
    int queryCapability(v4l2_capability& capability) const;
    int enumerateFormat(v4l2_fmtdesc& format) const;
    static int enumerateSize(v4l2_frmsizeenum& size);
    static int enumerateInterval(v4l2_frmivalenum& interval);
    int format(unsigned long request, v4l2_format& format);
    int parameters(unsigned long request, v4l2_streamparm& parameters);
    int requestBuffers(v4l2_requestbuffers& request);
    int queryBuffer(v4l2_buffer& buffer) const;
    int queueBuffer(v4l2_buffer& buffer);
    int dequeueBuffer(v4l2_buffer& buffer);
    int streamOn();
    int streamOff();

    void produce();
    std::uint32_t fill(std::uint32_t sequence, std::uint8_t* pixels) const;
    bool produceFrame(std::uint32_t sequence);
    void describe(std::uint32_t index, v4l2_buffer& buffer) const;
    void signal() const;
    void releaseMemory();

    const std::string path_;
    const int event_fd_;
    const bool nonblocking_;
    int memory_fd_ = -1;
    PictureShape shape_;
    std::vector<std::string> jpegs_;
    std::uint32_t rate_hz_ = 30;
    std::uint8_t* memory_ = nullptr;
    std::size_t stride_ = 0;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Buffer> buffers_;
    std::deque<std::uint32_t> queued_;
    std::deque<std::uint32_t> filled_;
    bool streaming_ = false;
    bool unplugged_ = false;
    std::thread producer_;
};

}  // namespace pmts::virtual_v4l2
