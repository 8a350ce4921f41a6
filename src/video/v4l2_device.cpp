#include "v4l2_device.hpp"

#include "v4l2_controls.hpp"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <functional>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace pmts::video {
namespace {

constexpr std::uint32_t kBuffers = 6;

struct KnownLayout {
    std::uint32_t fourcc;
    const char* name;
    PixelLayout layout;
};
/// Most preferred first: no decoding, then cheap decoding.
constexpr std::array<KnownLayout, 3> kLayouts{{{V4L2_PIX_FMT_YUYV, "YUYV", PixelLayout::kYuyv},
                                               {V4L2_PIX_FMT_NV12, "NV12", PixelLayout::kNv12},
                                               {V4L2_PIX_FMT_MJPEG, "MJPG", PixelLayout::kMjpg}}};

/// ioctl that repeats when a signal interrupts it; 0 or the error number.
int control(int fd, unsigned long request, void* argument) {
    int outcome = 0;
    do {
        outcome = ::ioctl(fd, request, argument);
    } while (outcome == -1 && errno == EINTR);
    return outcome == -1 ? errno : 0;
}

const KnownLayout* layoutNamed(const QString& name) {
    const auto found = std::find_if(kLayouts.begin(), kLayouts.end(), [&](const KnownLayout& known) {
        return name == QLatin1String(known.name);
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

const KnownLayout* layoutOf(std::uint32_t fourcc) {
    const auto found = std::find_if(kLayouts.begin(), kLayouts.end(),
                                    [&](const KnownLayout& known) { return known.fourcc == fourcc; });
    return found == kLayouts.end() ? nullptr : &*found;
}

/// Fastest first. A camera that tells none keeps its own rate: 0.
std::vector<double> ratesOf(int fd, std::uint32_t fourcc, std::uint32_t width, std::uint32_t height) {
    std::vector<double> rates_hz;
    v4l2_frmivalenum interval{};
    interval.pixel_format = fourcc;
    interval.width = width;
    interval.height = height;
    for (; control(fd, VIDIOC_ENUM_FRAMEINTERVALS, &interval) == 0; ++interval.index) {
        const v4l2_fract& step =
            interval.type == V4L2_FRMIVAL_TYPE_DISCRETE ? interval.discrete : interval.stepwise.min;
        if (step.numerator > 0) {
            rates_hz.push_back(static_cast<double>(step.denominator) / step.numerator);
        }
        if (interval.type != V4L2_FRMIVAL_TYPE_DISCRETE) {
            break;
        }
    }
    std::ranges::sort(rates_hz, std::greater<>());
    return rates_hz.empty() ? std::vector{0.0} : rates_hz;
}

bool offers(int fd, std::uint32_t fourcc) {
    v4l2_fmtdesc description{};
    description.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    for (; control(fd, VIDIOC_ENUM_FMT, &description) == 0; ++description.index) {
        if (description.pixelformat == fourcc) {
            return true;
        }
    }
    return false;
}

/// How far an offer is from a wish: another size weighs most, then a lower rate, then the layout's place in
/// the list.
double distance(const VideoFormat& offer, const VideoFormat& wanted) {
    const double size = std::abs(offer.size.width() - wanted.size.width()) +
                        std::abs(offer.size.height() - wanted.size.height());
    const double slower = std::max(0.0, wanted.rate_hz * 0.99 - offer.rate_hz);
    const double faster = std::max(0.0, offer.rate_hz - wanted.rate_hz * 1.01);
    return size * 1000.0 + slower + faster * 0.001;
}

}  // namespace

FileDescriptor::~FileDescriptor() {
    if (fd_ >= 0) {
        ::close(fd_);
    }
}

core::Error v4l2Error(int error_number, const QString& camera, const QString& detail) {
    const auto error = [&](const char* happened, const char* remedy) {
        return core::Error{
            core::ErrorKind::kCamera, QCoreApplication::translate("V4l2", happened).arg(camera),
            QCoreApplication::translate("V4l2", remedy), std::nullopt,
            QStringLiteral("%1: %2").arg(detail, QString::fromLocal8Bit(std::strerror(error_number)))};
    };
    switch (error_number) {
        case EBUSY:
            return error("%1 is used by another program.",
                         "Close that program; the live view starts by itself.");
        case EACCES:
        case EPERM:
            return error("You have no permission to use %1.",
                         "Add your user to the group \"video\" and log in again.");
        case ENOENT:
        case ENODEV:
        case ENXIO:
            return error("%1 is not connected.", "Plug it in; the live view starts by itself.");
        default:
            return error("%1 does not work.", "Unplug it and plug it in again.");
    }
}

core::Result<V4l2Device> V4l2Device::open(const QString& path) {
    FileDescriptor fd(::open(QFile::encodeName(path).constData(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    if (!fd.isOpen()) {
        return tl::unexpected(v4l2Error(errno, path, path));
    }
    V4l2Device device(std::move(fd), path);
    v4l2_capability capability{};
    if (const int failure = control(device.fd_.get(), VIDIOC_QUERYCAP, &capability)) {
        return device.trouble(failure, "VIDIOC_QUERYCAP");
    }
    const std::uint32_t abilities = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0
                                        ? capability.device_caps
                                        : capability.capabilities;
    constexpr std::uint32_t kNeeded = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    device.can_stream_ = (abilities & kNeeded) == kNeeded;
    const auto* card = reinterpret_cast<const char*>(capability.card);
    device.card_ = QString::fromUtf8(card, static_cast<qsizetype>(strnlen(card, sizeof capability.card)));
    return device;
}

V4l2Device::~V4l2Device() {
    if (streaming_ && fd_.isOpen()) {
        int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        (void)control(fd_.get(), VIDIOC_STREAMOFF, &type);
    }
    for (const Mapping& mapping : mappings_) {
        ::munmap(mapping.start, mapping.length);
    }
}

tl::unexpected<core::Error> V4l2Device::trouble(int error_number, const char* step) const {
    return tl::unexpected(
        v4l2Error(error_number, card_.isEmpty() ? path_ : card_, path_ + u' ' + QLatin1String(step)));
}

std::vector<CameraControlState> V4l2Device::controls() const { return v4l2Controls(fd_.get()); }

void V4l2Device::setControl(const ControlValue& wish) { setV4l2Control(fd_.get(), wish); }

std::vector<VideoFormat> V4l2Device::formats() const {
    std::vector<VideoFormat> all;
    for (const KnownLayout& known : kLayouts) {
        if (!offers(fd_.get(), known.fourcc)) {
            continue;
        }
        v4l2_frmsizeenum size{};
        size.pixel_format = known.fourcc;
        for (; control(fd_.get(), VIDIOC_ENUM_FRAMESIZES, &size) == 0;
             ++size.index) {
            const bool discrete = size.type == V4L2_FRMSIZE_TYPE_DISCRETE;
            const std::uint32_t width = discrete ? size.discrete.width : size.stepwise.max_width;
            const std::uint32_t height = discrete ? size.discrete.height : size.stepwise.max_height;
            for (const double rate_hz : ratesOf(fd_.get(), known.fourcc, width, height)) {
                all.push_back({QSize(static_cast<int>(width), static_cast<int>(height)), rate_hz,
                               QString::fromLatin1(known.name)});
            }
            if (!discrete) {
                break;
            }
        }
    }
    return all;
}

core::Result<VideoFormat> V4l2Device::configure(const VideoFormat& wanted) {
    std::vector<VideoFormat> offered = formats();
    if (layoutNamed(wanted.pixel_format) != nullptr) {
        std::erase_if(offered,
                      [&](const VideoFormat& offer) { return offer.pixel_format != wanted.pixel_format; });
    }
    const auto best =
        std::min_element(offered.begin(), offered.end(), [&](const VideoFormat& a, const VideoFormat& b) {
            return distance(a, wanted) < distance(b, wanted);
        });
    if (best == offered.end()) {
        return trouble(EINVAL, "no format we can read");
    }
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    format.fmt.pix.width = static_cast<std::uint32_t>(best->size.width());
    format.fmt.pix.height = static_cast<std::uint32_t>(best->size.height());
    format.fmt.pix.pixelformat = layoutNamed(best->pixel_format)->fourcc;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    if (const int failure = control(fd_.get(), VIDIOC_S_FMT, &format)) {
        return trouble(failure, "VIDIOC_S_FMT");
    }
    const KnownLayout* got = layoutOf(format.fmt.pix.pixelformat);
    if (got == nullptr) {
        return trouble(EINVAL, "the driver changed the pixel format");
    }
    v4l2_streamparm rate{};
    rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    rate.parm.capture.timeperframe = {
        1000, static_cast<std::uint32_t>(std::lround(std::max(1.0, wanted.rate_hz) * 1000.0))};
    const bool has_rate = control(fd_.get(), VIDIOC_S_PARM, &rate) == 0;  // others keep their own
    const v4l2_fract& period = rate.parm.capture.timeperframe;
    const double rate_hz = has_rate && period.numerator > 0
                               ? static_cast<double>(period.denominator) / period.numerator
                               : best->rate_hz;
    shape_ = {.layout = got->layout,
              .width_px = static_cast<int>(format.fmt.pix.width),
              .height_px = static_cast<int>(format.fmt.pix.height),
              .row_bytes = format.fmt.pix.bytesperline};
    return VideoFormat{QSize(shape_.width_px, shape_.height_px), rate_hz,
                       QString::fromLatin1(got->name)};
}

core::Result<void> V4l2Device::startStreaming() {
    v4l2_requestbuffers request{};
    request.count = kBuffers;
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.memory = V4L2_MEMORY_MMAP;
    if (const int failure = control(fd_.get(), VIDIOC_REQBUFS, &request)) {
        return trouble(failure, "VIDIOC_REQBUFS");
    }
    for (std::uint32_t index = 0; index < request.count; ++index) {
        PMTS_TRY(mapBuffer(index));
        requeue(index);
    }
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (const int failure = control(fd_.get(), VIDIOC_STREAMON, &type)) {
        return trouble(failure, "VIDIOC_STREAMON");
    }
    streaming_ = true;
    return {};
}

core::Result<void> V4l2Device::mapBuffer(std::uint32_t index) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = index;
    if (const int failure = control(fd_.get(), VIDIOC_QUERYBUF, &buffer)) {
        return trouble(failure, "VIDIOC_QUERYBUF");
    }
    void* const start = ::mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, fd_.get(),
                               static_cast<off_t>(buffer.m.offset));
    if (start == MAP_FAILED) {
        return trouble(errno, "mmap");
    }
    mappings_.push_back({start, buffer.length});
    return {};
}

V4l2Device::Wake V4l2Device::wait(int interrupt_fd, core::Duration limit) const {
    std::array<pollfd, 2> watched{{{fd_.get(), POLLIN, 0}, {interrupt_fd, POLLIN, 0}}};
    const auto limit_ms = std::chrono::duration_cast<std::chrono::milliseconds>(limit).count();
    const int woken = ::poll(watched.data(), watched.size(), static_cast<int>(limit_ms));
    if (woken <= 0) {
        return Wake::kTimeOut;
    }
    return watched[1].revents != 0 ? Wake::kInterrupted : Wake::kReady;
}

core::Result<std::optional<V4l2Buffer>> V4l2Device::dequeue() {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    if (const int failure = control(fd_.get(), VIDIOC_DQBUF, &buffer)) {
        if (failure == EAGAIN) {
            return std::nullopt;
        }
        return trouble(failure, "VIDIOC_DQBUF");
    }
    V4l2Buffer filled{.index = buffer.index,
                      .sequence = buffer.sequence,
                      .captured_at = {},
                      .picture = shape_,
                      .damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0};
    filled.captured_at =
        std::chrono::seconds(buffer.timestamp.tv_sec) + std::chrono::microseconds(buffer.timestamp.tv_usec);
    filled.picture.data = static_cast<const std::uint8_t*>(mappings_.at(buffer.index).start);
    filled.picture.size_bytes = std::min<std::size_t>(buffer.bytesused, mappings_[buffer.index].length);
    return filled;
}

void V4l2Device::requeue(std::uint32_t index) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = index;
    (void)control(fd_.get(), VIDIOC_QBUF, &buffer);  // a device that is gone says so at the next dequeue
}

}  // namespace pmts::video
