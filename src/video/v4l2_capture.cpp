#include "v4l2_capture.hpp"

#include "capture_device.hpp"
#include "v4l2_device.hpp"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <sys/eventfd.h>
#include <unistd.h>

namespace pmts::video {
namespace {

constexpr core::Duration kStale = std::chrono::milliseconds(100);

QStringList nodesIn(const QString& folder) {
    QStringList names = QDir(folder).entryList({QStringLiteral("video*")}, QDir::System | QDir::Files);
    std::sort(names.begin(), names.end(), [](const QString& a, const QString& b) {  // video2 before video10
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    for (QString& name : names) {
        name = QDir(folder).filePath(name);
    }
    return names;
}

/// A V4L2 camera on its worker. It is found again by its name when it comes back under another node.
class V4l2Capture final : public CaptureDevice {
public:
    explicit V4l2Capture(SourceAddress address)
        : address_(std::move(address)), interrupt_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

    core::Result<void> open(const VideoFormat& wanted) override {
        auto device = find();
        if (!device) {
            return tl::unexpected(device.error());
        }
        device_.emplace(std::move(*device));
        formats_ = device_->formats();
        auto started = device_->configure(wanted).and_then([this](const VideoFormat& got) {
            format_ = got;
            return device_->startStreaming();
        });
        if (!started) {
            close();
        }
        return started;
    }

    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        giveBack();
        const V4l2Device::Wake wake = device_->wait(interrupt_.get(), limit);
        if (wake == V4l2Device::Wake::kInterrupted) {
            std::uint64_t count = 0;
            (void)!::read(interrupt_.get(), &count, sizeof count);
        }
        if (wake != V4l2Device::Wake::kReady) {
            return std::nullopt;
        }
        PMTS_TRY(takeNewest());
        return held_ ? std::optional(Shot{held_->sequence, held_->captured_at}) : std::nullopt;
    }

    camera::Frame picture() override {
        camera::Frame frame;
        if (held_ && !held_->damaged) {
            frame.image = bgrFrom(held_->picture);
        }
        giveBack();
        return frame;
    }

    void close() override {
        held_.reset();
        device_.reset();
    }

    DeviceReport report() override {
        return device_ ? DeviceReport{format_, formats_, device_->controls()} : DeviceReport{};
    }
    void setControl(const ControlValue& wish) override {
        if (device_) {
            device_->setControl(wish);
        }
    }

    void interrupt() override {
        const std::uint64_t one = 1;
        (void)!::write(interrupt_.get(), &one, sizeof one);
    }

private:
    /// The node of the address; when that is gone or carries another camera, the node with this camera's
    /// name.
    core::Result<V4l2Device> find() const {
        auto device = V4l2Device::open(address_.location);
        if (device && (address_.name.isEmpty() || device->cardName() == address_.name)) {
            return device;
        }
        const QString shown = address_.name.isEmpty() ? address_.location : address_.name;
        core::Error why = device ? v4l2Error(ENODEV, shown, address_.location) : device.error();
        why.happened.replace(address_.location, shown);  // people know it by its name
        if (!device && QFileInfo::exists(address_.location)) {
            return tl::unexpected(
                why);  // busy or forbidden: another camera of this name is not the one meant
        }
        for (const QString& node : nodesIn(QFileInfo(address_.location).path())) {
            auto other = V4l2Device::open(node);
            if (other && other->canStream() && other->cardName() == address_.name) {
                return other;
            }
        }
        return tl::unexpected(why);
    }

    /// The oldest filled buffer; but when the worker was kept away for long, the newest: the live view never
    /// lags.
    core::Result<void> takeNewest() {
        while (true) {
            auto filled = device_->dequeue();
            if (!filled) {
                return tl::unexpected(filled.error());
            }
            if (!*filled) {
                return {};
            }
            giveBack();
            held_ = **filled;
            if (now() - held_->captured_at < kStale) {
                return {};
            }
        }
    }

    void giveBack() {
        if (held_) {
            device_->requeue(held_->index);
            held_.reset();
        }
    }

    SourceAddress address_;
    FileDescriptor interrupt_;
    std::optional<V4l2Device> device_;
    std::optional<V4l2Buffer> held_;
    VideoFormat format_;
    std::vector<VideoFormat> formats_;
};

}  // namespace

std::vector<SourceAddress> v4l2Cameras(const QString& folder) {
    std::vector<SourceAddress> cameras;
    for (const QString& node : nodesIn(folder)) {
        const auto device = V4l2Device::open(node);
        if (device && device->canStream() && !device->formats().empty()) {
            cameras.push_back({SourceKind::kV4l2, node, device->cardName()});
        }
    }
    return cameras;
}

std::unique_ptr<CaptureDevice> makeV4l2Capture(const SourceAddress& address) {
    return std::make_unique<V4l2Capture>(address);
}

}  // namespace pmts::video
