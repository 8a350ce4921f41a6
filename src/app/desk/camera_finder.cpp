#include "camera_finder.hpp"

#include <utility>

namespace pmts::app {

CameraFinder::CameraFinder(Look look, QObject* parent) : QObject(parent), look_(std::move(look)) {
    thread_.setObjectName(QStringLiteral("camera finder"));
    hand_.moveToThread(&thread_);
}

CameraFinder::~CameraFinder() {
    thread_.quit();
    thread_.wait();
}

void CameraFinder::look() {
    if (std::exchange(is_looking_, true)) {
        return;
    }
    if (!thread_.isRunning()) {
        thread_.start(QThread::LowPriority);
    }
    const auto look_and_tell = [this] {
        QMetaObject::invokeMethod(this, [this, cameras = look_()] { show(cameras); }, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(&hand_, look_and_tell, Qt::QueuedConnection);
}

void CameraFinder::show(const std::vector<video::SourceAddress>& cameras) {
    is_looking_ = false;
    Q_EMIT found(cameras);
}

}  // namespace pmts::app
