#include "replay_source.hpp"

namespace pmts::app {

void ReplaySource::show(const camera::FramePtr& frame) {
    const bool other_size = !newest_ || newest_->image.size() != frame->image.size();
    if (newest_ && frame->captured_at > newest_->captured_at) {
        rate_hz_ = 1.0 / std::chrono::duration<double>(frame->captured_at - newest_->captured_at).count();
    }
    newest_ = frame;
    ++shown_;
    if (other_size) {
        Q_EMIT reportChanged();
    }
    Q_EMIT frameReady();
}

void ReplaySource::start(const video::VideoFormat&) { Q_EMIT stateChanged(state()); }

video::SourceAddress ReplaySource::address() const {
    return {.kind = video::SourceKind::kFile, .location = {}, .name = tr("Recording")};
}

video::SourceStatistics ReplaySource::statistics() const {
    video::SourceStatistics statistics;
    statistics.delivered = shown_;
    statistics.measured_rate_hz = rate_hz_;
    return statistics;
}

video::DeviceReport ReplaySource::report() const {
    video::DeviceReport report;
    if (newest_) {
        report.format.size = {newest_->image.cols, newest_->image.rows};
        report.formats = {report.format};
    }
    return report;
}

}  // namespace pmts::app
