#pragma once

#include "picture_format.hpp"
#include "pmts/core/result.hpp"
#include "pmts/video/video_source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pmts::video {

/// A file descriptor that closes itself.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int fd) : fd_(fd) {}
    ~FileDescriptor();
    FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }
    [[nodiscard]] int get() const { return fd_; }
    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }

private:
    int fd_ = -1;
};

/// A filled buffer of the driver; give it back with requeue() after use.
struct V4l2Buffer {
    std::uint32_t index = 0;
    std::uint64_t sequence = 0;
    core::Duration captured_at{0};
    RawPicture picture;
    bool damaged = false;
};

/// One V4L2 capture device: every ioctl of the room but the controls' is here. Memory-mapped streaming, one thread.
class V4l2Device {
public:
    [[nodiscard]] static core::Result<V4l2Device> open(const QString& path);
    ~V4l2Device();
    V4l2Device(V4l2Device&&) noexcept = default;
    V4l2Device& operator=(V4l2Device&&) = delete;

    [[nodiscard]] const QString& cardName() const { return card_; }
    [[nodiscard]] bool canStream() const { return can_stream_; }
    /// What it offers in the pixel layouts we read, most preferred layout first.
    [[nodiscard]] std::vector<VideoFormat> formats() const;

    /// Sets the nearest format to the wanted one and says which it became.
    [[nodiscard]] core::Result<VideoFormat> configure(const VideoFormat& wanted);
    [[nodiscard]] core::Result<void> startStreaming();

    enum class Wake { kReady, kTimeOut, kInterrupted };
    /// Waits for a buffer or for `interrupt_fd` to become readable.
    [[nodiscard]] Wake wait(int interrupt_fd, core::Duration limit) const;
    /// nullopt when no buffer is filled; an error when the device is gone.
    [[nodiscard]] core::Result<std::optional<V4l2Buffer>> dequeue();
    void requeue(std::uint32_t index);

    /// Exposure, gain, white balance, focus and zoom as far as the device has them, with their values now.
    [[nodiscard]] std::vector<CameraControlState> controls() const;
    void setControl(const ControlValue& wish);

private:
    struct Mapping {
        void* start = nullptr;
        std::size_t length = 0;
    };

    V4l2Device(FileDescriptor fd, QString path) : fd_(std::move(fd)), path_(std::move(path)) {}
    [[nodiscard]] tl::unexpected<core::Error> trouble(int error_number, const char* step) const;
    [[nodiscard]] core::Result<void> mapBuffer(std::uint32_t index);

    FileDescriptor fd_;
    QString path_;
    QString card_;
    bool can_stream_ = false;
    bool streaming_ = false;
    RawPicture shape_;  ///< layout and size of the configured format
    std::vector<Mapping> mappings_;
};

/// What a failed open or ioctl means for the surveyor.
[[nodiscard]] core::Error v4l2Error(int error_number, const QString& camera, const QString& detail);

}  // namespace pmts::video
