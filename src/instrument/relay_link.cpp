#include "relay_link.hpp"

namespace pmts::instrument {

void RelayLink::replace(std::unique_ptr<transport::ByteLink> inner) {
    close();
    inner_ = std::move(inner);
    if (inner_ == nullptr) {
        return;
    }
    inner_->on_received = [this](std::string_view bytes) {
        if (on_received) {
            on_received(bytes);
        }
    };
    inner_->on_lost = [this](const core::Error& error) {
        if (on_lost) {
            on_lost(error);
        }
        if (on_gone) {
            on_gone(error);
        }
    };
}

core::Result<void> RelayLink::open() {
    if (inner_ == nullptr) {
        return core::fail(core::ErrorKind::kPortUnavailable, QStringLiteral("There is no such port."));
    }
    return inner_->open();
}

void RelayLink::close() {
    if (inner_ != nullptr && inner_->isOpen()) {
        inner_->close();
    }
}

bool RelayLink::isOpen() const { return inner_ != nullptr && inner_->isOpen(); }

void RelayLink::write(std::string_view bytes) {
    if (inner_ != nullptr) {
        inner_->write(bytes);
    }
}

core::Result<void> RelayLink::setControlLines(const transport::ControlLines& lines) {
    return inner_ == nullptr ? core::Result<void>() : inner_->setControlLines(lines);
}

core::Result<void> RelayLink::setBreak(bool on) {
    return inner_ == nullptr ? core::Result<void>() : inner_->setBreak(on);
}

QString RelayLink::description() const { return inner_ == nullptr ? QString() : inner_->description(); }

}  // namespace pmts::instrument
