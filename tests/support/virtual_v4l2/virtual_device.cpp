#include "virtual_device.hpp"

#include "camera_file.hpp"
#include "virtual_controls.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

namespace pmts::virtual_v4l2 {
namespace {

constexpr std::array<std::uint32_t, 3> kFormats{V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_NV12, V4L2_PIX_FMT_MJPEG};
constexpr std::array<const char*, 3> kFormatNames{"YUYV 4:2:2", "Y/CbCr 4:2:0", "Motion-JPEG"};
constexpr std::array<std::array<std::uint32_t, 2>, 3> kSizes{{{640, 480}, {1280, 720}, {1920, 1080}}};
constexpr std::array<std::uint32_t, 2> kRates_hz{30, 15};
constexpr std::uint32_t kMostBuffers = 32;

template <std::size_t size>
void copyText(__u8 (&target)[size], const std::string& text) {
    std::snprintf(reinterpret_cast<char*>(target), size, "%s", text.c_str());
}

std::uint8_t* mapShared(int fd, std::size_t size) {
    void* const start = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    return start == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(start);
}

}  // namespace

VirtualDevice::VirtualDevice(std::string path, int event_fd, bool nonblocking)
    : path_(std::move(path)),
      event_fd_(event_fd),
      nonblocking_(nonblocking),
      memory_fd_(::memfd_create("virtual-v4l2", MFD_CLOEXEC)) {
    shape_.fourcc = kFormats[0];
}

VirtualDevice::~VirtualDevice() {
    streamOff();
    releaseMemory();
    ::close(memory_fd_);
}

int VirtualDevice::control(unsigned long request, void* argument) {
    {
        const std::lock_guard lock(mutex_);
        if (unplugged_ && request != VIDIOC_STREAMOFF && request != VIDIOC_REQBUFS) {
            return ENODEV;
        }
    }
    switch (request) {
        case VIDIOC_QUERYCAP:
            return queryCapability(*static_cast<v4l2_capability*>(argument));
        case VIDIOC_ENUM_FMT:
            return enumerateFormat(*static_cast<v4l2_fmtdesc*>(argument));
        case VIDIOC_ENUM_FRAMESIZES:
            return enumerateSize(*static_cast<v4l2_frmsizeenum*>(argument));
        case VIDIOC_ENUM_FRAMEINTERVALS:
            return enumerateInterval(*static_cast<v4l2_frmivalenum*>(argument));
        case VIDIOC_S_FMT:
        case VIDIOC_TRY_FMT:
        case VIDIOC_G_FMT:
            return format(request, *static_cast<v4l2_format*>(argument));
        case VIDIOC_S_PARM:
        case VIDIOC_G_PARM:
            return parameters(request, *static_cast<v4l2_streamparm*>(argument));
        case VIDIOC_QUERYCTRL:
        case VIDIOC_G_CTRL:
        case VIDIOC_S_CTRL:
            return hasControls() ? VirtualControls::of(path_).answer(request, argument) : ENOTTY;
        case VIDIOC_REQBUFS:
            return requestBuffers(*static_cast<v4l2_requestbuffers*>(argument));
        case VIDIOC_QUERYBUF:
            return queryBuffer(*static_cast<v4l2_buffer*>(argument));
        case VIDIOC_QBUF:
            return queueBuffer(*static_cast<v4l2_buffer*>(argument));
        case VIDIOC_DQBUF:
            return dequeueBuffer(*static_cast<v4l2_buffer*>(argument));
        case VIDIOC_STREAMON:
            return streamOn();
        case VIDIOC_STREAMOFF:
            return streamOff();
        default:
            return ENOTTY;
    }
}

bool VirtualDevice::hasControls() const { return !readCameraFile(path_).value_or(CameraFile{}).bare; }

int VirtualDevice::queryCapability(v4l2_capability& capability) const {
    const CameraFile file = readCameraFile(path_).value_or(CameraFile{});
    capability = {};
    copyText(capability.driver, "uvcvideo");
    copyText(capability.card, file.card);
    copyText(capability.bus_info, "usb-virtual");
    capability.version = 0x060100;
    capability.device_caps =
        (file.metadata ? V4L2_CAP_META_CAPTURE : V4L2_CAP_VIDEO_CAPTURE) | V4L2_CAP_STREAMING;
    capability.capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING | V4L2_CAP_DEVICE_CAPS;
    return 0;
}

int VirtualDevice::enumerateFormat(v4l2_fmtdesc& format) const {
    const bool has_jpeg = !readCameraFile(path_).value_or(CameraFile{}).jpeg_folder.empty();
    const std::size_t offered = kFormats.size() - (has_jpeg ? 0U : 1U);
    if (format.type != V4L2_BUF_TYPE_VIDEO_CAPTURE || format.index >= offered) {
        return EINVAL;
    }
    format.pixelformat = kFormats[format.index];
    format.flags = 0;
    copyText(format.description, kFormatNames[format.index]);
    return 0;
}

int VirtualDevice::enumerateSize(v4l2_frmsizeenum& size) {
    if (size.index >= kSizes.size()) {
        return EINVAL;
    }
    size.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    size.discrete = {kSizes[size.index][0], kSizes[size.index][1]};
    return 0;
}

int VirtualDevice::enumerateInterval(v4l2_frmivalenum& interval) {
    if (interval.index >= kRates_hz.size()) {
        return EINVAL;
    }
    interval.type = V4L2_FRMIVAL_TYPE_DISCRETE;
    interval.discrete = {1, kRates_hz[interval.index]};
    return 0;
}

int VirtualDevice::format(unsigned long request, v4l2_format& format) {
    if (format.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) {
        return EINVAL;
    }
    PictureShape shape = shape_;
    if (request != VIDIOC_G_FMT) {
        const auto larger = std::find_if(kSizes.rbegin(), kSizes.rend(), [&](const auto& size) {
            return size[0] <= format.fmt.pix.width;
        });
        const auto& size = larger == kSizes.rend() ? kSizes.front() : *larger;
        const auto known = std::find(kFormats.begin(), kFormats.end(), format.fmt.pix.pixelformat);
        shape = {known == kFormats.end() ? kFormats[0] : *known, size[0], size[1]};
    }
    if (request == VIDIOC_S_FMT) {
        if (!buffers_.empty()) {
            return EBUSY;
        }
        shape_ = shape;
    }
    format.fmt.pix = {};
    format.fmt.pix.width = shape.width;
    format.fmt.pix.height = shape.height;
    format.fmt.pix.pixelformat = shape.fourcc;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    format.fmt.pix.bytesperline = shape.rowBytes();
    format.fmt.pix.sizeimage = shape.sizeBytes();
    return 0;
}

int VirtualDevice::parameters(unsigned long request, v4l2_streamparm& parameters) {
    if (parameters.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) {
        return EINVAL;
    }
    const v4l2_fract wish = parameters.parm.capture.timeperframe;
    if (request == VIDIOC_S_PARM && wish.numerator > 0) {
        const bool slow = wish.denominator < wish.numerator * (kRates_hz[0] + kRates_hz[1]) / 2;
        rate_hz_ = slow ? kRates_hz[1] : kRates_hz[0];
    }
    parameters.parm.capture = {};
    parameters.parm.capture.capability = V4L2_CAP_TIMEPERFRAME;
    parameters.parm.capture.timeperframe = {1, rate_hz_};
    return 0;
}

int VirtualDevice::requestBuffers(v4l2_requestbuffers& request) {
    if (request.memory != V4L2_MEMORY_MMAP || request.type != V4L2_BUF_TYPE_VIDEO_CAPTURE) {
        return EINVAL;
    }
    const std::lock_guard lock(mutex_);
    releaseMemory();
    request.count = std::min(request.count, kMostBuffers);
    buffers_.assign(request.count, {});
    stride_ = (shape_.sizeBytes() + 4095U) & ~std::size_t{4095};
    const std::size_t size = stride_ * request.count;
    if (request.count > 0 && (::ftruncate(memory_fd_, static_cast<off_t>(size)) != 0 ||
                              (memory_ = mapShared(memory_fd_, size)) == nullptr)) {
        return ENOMEM;
    }
    return 0;
}

void VirtualDevice::releaseMemory() {
    if (memory_ != nullptr) {
        ::munmap(memory_, stride_ * buffers_.size());
        memory_ = nullptr;
    }
}

void VirtualDevice::describe(std::uint32_t index, v4l2_buffer& buffer) const {
    const Buffer& known = buffers_[index];
    buffer.index = index;
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.length = shape_.sizeBytes();
    buffer.bytesused = known.filled_bytes;
    buffer.m.offset = static_cast<__u32>(index * stride_);
    buffer.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | V4L2_BUF_FLAG_MAPPED;
    buffer.flags |= known.owner == Owner::kDriver ? V4L2_BUF_FLAG_QUEUED : 0U;
    buffer.flags |= known.owner == Owner::kFilled ? V4L2_BUF_FLAG_DONE : 0U;
    buffer.field = V4L2_FIELD_NONE;
    buffer.sequence = known.sequence;
    buffer.timestamp = known.captured_at;
}

int VirtualDevice::queryBuffer(v4l2_buffer& buffer) const {
    const std::lock_guard lock(mutex_);
    if (buffer.index >= buffers_.size()) {
        return EINVAL;
    }
    describe(buffer.index, buffer);
    return 0;
}

int VirtualDevice::queueBuffer(v4l2_buffer& buffer) {
    const std::lock_guard lock(mutex_);
    if (buffer.index >= buffers_.size() || buffers_[buffer.index].owner != Owner::kProgram) {
        return EINVAL;
    }
    buffers_[buffer.index].owner = Owner::kDriver;
    queued_.push_back(buffer.index);
    describe(buffer.index, buffer);
    return 0;
}

int VirtualDevice::dequeueBuffer(v4l2_buffer& buffer) {
    std::unique_lock lock(mutex_);
    while (filled_.empty()) {
        if (unplugged_ || !streaming_ || nonblocking_) {
            return unplugged_ ? ENODEV : streaming_ ? EAGAIN : EINVAL;
        }
        changed_.wait(lock);
    }
    const std::uint32_t index = filled_.front();
    filled_.pop_front();
    buffers_[index].owner = Owner::kProgram;
    std::uint64_t count = 0;
    (void)!::read(event_fd_, &count, sizeof count);
    describe(index, buffer);
    return 0;
}

int VirtualDevice::streamOn() {
    const std::lock_guard lock(mutex_);
    streaming_ = true;
    jpegs_ = jpegPictures(readCameraFile(path_).value_or(CameraFile{}).jpeg_folder);
    if (!producer_.joinable()) {
        producer_ = std::thread([this] { produce(); });
    }
    return 0;
}

int VirtualDevice::streamOff() {
    {
        const std::lock_guard lock(mutex_);
        streaming_ = false;
        queued_.clear();
        filled_.clear();
        for (Buffer& buffer : buffers_) {
            buffer.owner = Owner::kProgram;
        }
    }
    changed_.notify_all();
    if (producer_.joinable()) {
        producer_.join();
    }
    std::uint64_t count = 0;
    while (::read(event_fd_, &count, sizeof count) == sizeof count) {
    }
    return 0;
}

void VirtualDevice::produce() {
    auto due = std::chrono::steady_clock::now();
    for (std::uint32_t sequence = 0;; ++sequence) {
        due += std::chrono::nanoseconds(1'000'000'000 / rate_hz_);
        {
            std::unique_lock lock(mutex_);
            if (changed_.wait_until(lock, due, [this] { return !streaming_; })) {
                return;
            }
        }
        if (!produceFrame(sequence)) {
            return;
        }
    }
}

/// Writes a picture and says how many bytes it took.
std::uint32_t VirtualDevice::fill(std::uint32_t sequence, std::uint8_t* pixels) const {
    if (shape_.fourcc != V4L2_PIX_FMT_MJPEG) {
        drawTestPicture(shape_, sequence, pixels);
        return shape_.sizeBytes();
    }
    if (jpegs_.empty()) {
        return 0;
    }
    const std::string& jpeg = jpegs_[sequence % jpegs_.size()];
    const std::size_t bytes = std::min<std::size_t>(jpeg.size(), shape_.sizeBytes());
    std::memcpy(pixels, jpeg.data(), bytes);
    return static_cast<std::uint32_t>(bytes);
}

/// False when the camera has been unplugged.
bool VirtualDevice::produceFrame(std::uint32_t sequence) {
    const std::optional<CameraFile> file = readCameraFile(path_);
    const std::lock_guard lock(mutex_);
    if (!file) {
        unplugged_ = true;
        VirtualControls::of(path_).forget();
        signal();
        changed_.notify_all();
        return false;
    }
    const bool skipped = file->skip > 0 && sequence % static_cast<std::uint32_t>(file->skip) == 0;
    if (file->stall || skipped || queued_.empty()) {
        return true;
    }
    const std::uint32_t index = queued_.front();
    queued_.pop_front();
    const std::uint32_t filled_bytes = fill(sequence, memory_ + index * stride_);
    const auto at = std::chrono::duration_cast<std::chrono::microseconds>(
                        std::chrono::steady_clock::now().time_since_epoch())
                        .count();
    buffers_[index] = {Owner::kFilled,
                       sequence,
                       {static_cast<time_t>(at / 1'000'000), static_cast<suseconds_t>(at % 1'000'000)},
                       filled_bytes};
    filled_.push_back(index);
    signal();
    changed_.notify_all();
    return true;
}

void VirtualDevice::signal() const {
    const std::uint64_t one = 1;
    (void)!::write(event_fd_, &one, sizeof one);
}

}  // namespace pmts::virtual_v4l2
