#include "qt_camera_device.hpp"

#include "qt_frame.hpp"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include <mutex>
#include <utility>

namespace pmts::video {
namespace {

QString say(const char* text) { return QCoreApplication::translate("QtCamera", text); }

/// QCamera lives here on the worker, not on the GUI thread: its start and stop may block for ever.
class QtCameraDevice final : public CaptureDevice {
public:
    QtCameraDevice(QString description, std::unique_ptr<QtCameraBackend> backend)
        : description_(std::move(description)), backend_(std::move(backend)) {}
    ~QtCameraDevice() override { backend_->stop(); }

    core::Result<void> open(const VideoFormat& wanted) override {
        forget();
        if (!backend_->isPresent(description_)) {
            return tl::unexpected(notConnected());
        }
        backend_->start(description_, wanted,
                        {.frame = [this](const QVideoFrame& frame) { receive(frame); },
                         .error = [this](const QString& text) { fail(text); }});
        return {};
    }

    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        if (!hasNews()) {
            turnLoop(limit);
        }
        if (const auto shot = takeArrived()) {
            return shot;
        }
        if (const auto text = problem()) {
            return tl::unexpected(backend_->isPresent(description_) ? stopped(*text) : notConnected());
        }
        if (!backend_->isPresent(description_)) {
            return tl::unexpected(notConnected());
        }
        return std::nullopt;
    }

    camera::Frame picture() override {
        camera::Frame frame;
        frame.image = bgrFromQt(std::exchange(held_, QVideoFrame()));
        return frame;
    }

    void close() override {
        backend_->stop();
        forget();
    }

    DeviceReport report() override { return backend_->report(); }
    void setControl(const ControlValue& wish) override { backend_->setControl(wish); }

    void interrupt() override {
        const std::lock_guard lock(mutex_);
        wake();
    }

private:
    struct Arrival {
        QVideoFrame frame;
        Shot shot;
    };

    [[nodiscard]] core::Error notConnected() const {
        return {.kind = core::ErrorKind::kCamera,
                .happened = say("%1 is not connected.").arg(description_),
                .remedy = say("Plug it in; the live view starts by itself."),
                .info_code = std::nullopt,
                .detail = {}};
    }
    [[nodiscard]] core::Error stopped(const QString& text) const {
        return {.kind = core::ErrorKind::kCamera,
                .happened = say("%1 has stopped.").arg(description_),
                .remedy = say("Close other programs that use it; the live view tries again by itself."),
                .info_code = std::nullopt,
                .detail = text};
    }

    /// Called on the backend's thread; only the newest frame is kept.
    void receive(const QVideoFrame& frame) {
        if (!frame.isValid()) {
            return;
        }
        const std::lock_guard lock(mutex_);
        arrived_ = Arrival{frame, {sequence_++, now()}};
        wake();
    }
    void fail(const QString& text) {
        const std::lock_guard lock(mutex_);
        problem_ = text;
        wake();
    }
    void wake() {
        if (loop_ != nullptr) {
            QMetaObject::invokeMethod(loop_, &QEventLoop::quit, Qt::QueuedConnection);
        }
    }

    void forget() {
        const std::lock_guard lock(mutex_);
        arrived_.reset();
        problem_.reset();
    }
    [[nodiscard]] bool hasNews() {
        const std::lock_guard lock(mutex_);
        return arrived_ || problem_;
    }
    [[nodiscard]] std::optional<QString> problem() {
        const std::lock_guard lock(mutex_);
        return problem_;
    }
    std::optional<Shot> takeArrived() {
        const std::lock_guard lock(mutex_);
        if (!arrived_) {
            return std::nullopt;
        }
        held_ = std::move(arrived_->frame);
        const Shot shot = arrived_->shot;
        arrived_.reset();
        return shot;
    }

    /// This thread's event loop, in slices: the backend's notifiers live on it.
    void turnLoop(core::Duration limit) {
        QEventLoop loop;
        QTimer::singleShot(std::chrono::duration_cast<std::chrono::milliseconds>(limit), &loop,
                           &QEventLoop::quit);
        setLoop(&loop);
        loop.exec();
        setLoop(nullptr);
    }
    void setLoop(QEventLoop* loop) {
        const std::lock_guard lock(mutex_);
        loop_ = loop;
        if (arrived_ || problem_) {
            wake();
        }
    }

    const QString description_;
    const std::unique_ptr<QtCameraBackend> backend_;
    QVideoFrame held_;
    std::mutex mutex_;
    QEventLoop* loop_ = nullptr;
    std::optional<Arrival> arrived_;
    std::optional<QString> problem_;
    std::uint64_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeQtCameraDevice(const QString& description,
                                                  std::unique_ptr<QtCameraBackend> backend) {
    return std::make_unique<QtCameraDevice>(description, std::move(backend));
}

std::unique_ptr<CaptureDevice> makeQtCameraDevice(const QString& description) {
    return makeQtCameraDevice(description, makeQtCameraBackend());
}

}  // namespace pmts::video
