#include "pmts/video/video_source.hpp"

#include "worker_source.hpp"

#include <stdexcept>

namespace pmts::video {
namespace {

DeviceFactory deviceFactory(const SourceAddress& address) {
    switch (address.kind) {
        case SourceKind::kV4l2:
            return [address] { return makeV4l2Capture(address); };
        case SourceKind::kQtCamera:
            return [name = address.name] { return makeQtCameraDevice(name); };
        case SourceKind::kFile:
            return [path = address.location] { return makeFileDevice(path); };
        case SourceKind::kStream:
            return [url = address.location] { return makeStreamDevice(url); };
        case SourceKind::kSimulated:
            break;
    }
    throw std::logic_error("a simulated source needs a painter: use makeSimulatedSource()");
}

}  // namespace

std::unique_ptr<VideoSource> makeVideoSource(const SourceAddress& address, core::VideoGate& gate) {
    return std::make_unique<WorkerSource>(address, deviceFactory(address), gate);
}

std::unique_ptr<VideoSource> makeSimulatedSource(FramePainter painter, core::VideoGate& gate) {
    const SourceAddress address{SourceKind::kSimulated, {}, VideoSource::tr("Simulated camera")};
    return std::make_unique<WorkerSource>(
        address, [painter = std::move(painter)] { return makeSimulatedDevice(painter); }, gate);
}

std::unique_ptr<VideoSource> makeSimulatedSource(ExposurePainter painter, core::VideoGate& gate) {
    const SourceAddress address{SourceKind::kSimulated, {}, VideoSource::tr("Simulated camera")};
    return std::make_unique<WorkerSource>(
        address, [painter = std::move(painter)] { return makeSimulatedDevice(painter); }, gate);
}

}  // namespace pmts::video
