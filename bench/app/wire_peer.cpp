#include "wire_peer.hpp"

#include "pmts/simulator/station.hpp"
#include "pmts/transport/pty_link.hpp"

namespace pmts::bench {

namespace {

/// Motors without patience, so that a hundred moves take a minute; the line keeps its 9600 baud.
simulator::StationSettings quickMotors() {
    simulator::StationSettings settings;
    settings.speed_gon_s = 200.0;
    settings.acceleration_gon_s2 = 2000.0;
    settings.settle = std::chrono::milliseconds(50);
    return settings;
}

std::shared_ptr<const simulator::Scene> wall() {
    const simulator::Panel panel{QStringLiteral("wall"), {-20, 15, -4}, {40, 0, 0}, {0, 0, 10},
                                 cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(128)), false};
    return std::make_shared<const simulator::Scene>(std::vector<simulator::Panel>{panel});
}

}  // namespace

class WirePeer::Instrument {
public:
    explicit Instrument(WirePeer& peer) {
        pty_.on_received = [this, &peer](std::string_view bytes) {
            peer.note(bytes, clock_.now());
            station_.receive(bytes);
        };
        station_.send = [this](std::string_view bytes) { pty_.write(bytes); };
        (void)pty_.open();
    }
    [[nodiscard]] QString portPath() const { return pty_.slaveName(); }

private:
    core::SystemClock clock_;
    transport::PtyLink pty_;
    simulator::Station station_{quickMotors(), wall(), std::make_shared<simulator::TruePointing>(), clock_};
};

WirePeer::WirePeer() {
    context_.moveToThread(&thread_);
    thread_.start(QThread::HighestPriority);
    QMetaObject::invokeMethod(
        &context_,
        [this] {
            instrument_ = std::make_unique<Instrument>(*this);
            port_path_ = instrument_->portPath();
        },
        Qt::BlockingQueuedConnection);
}

WirePeer::~WirePeer() {
    QMetaObject::invokeMethod(&context_, [this] { instrument_.reset(); }, Qt::BlockingQueuedConnection);
    thread_.quit();
    thread_.wait();
}

void WirePeer::watchFor(const std::string& prefix) {
    const std::lock_guard lock(mutex_);
    prefix_ = prefix;
    arrival_.reset();
}

std::optional<core::Duration> WirePeer::arrival() const {
    const std::lock_guard lock(mutex_);
    return arrival_;
}

void WirePeer::note(std::string_view bytes, core::Duration at) {
    const std::lock_guard lock(mutex_);
    for (const char byte : bytes) {
        if (line_.empty()) {
            line_began_ = at;
        }
        line_ += byte;
        if (!arrival_ && line_ == prefix_) {
            arrival_ = line_began_;
        }
        if (byte == '\r') {
            line_.clear();
        }
    }
}

}  // namespace pmts::bench
