#include "pmts/transport/tap_link.hpp"

namespace pmts::transport {

TapLink::TapLink(std::unique_ptr<ByteLink> inner, OnTraffic on_traffic)
    : inner_(std::move(inner)), on_traffic_(std::move(on_traffic)) {
    inner_->on_received = [this](std::string_view bytes) {
        on_traffic_(Direction::kReceived, bytes);
        if (const auto receive = on_received) {
            receive(bytes);
        }
    };
    inner_->on_lost = [this](const core::Error& error) {
        on_traffic_(Direction::kLost, error.happened.toStdString());
        if (const auto report = on_lost) {
            report(error);
        }
    };
}

void TapLink::write(std::string_view bytes) {
    if (isOpen()) {
        on_traffic_(Direction::kSent, bytes);
    }
    inner_->write(bytes);
}

}  // namespace pmts::transport
