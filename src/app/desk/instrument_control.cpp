#include "adapter_port.hpp"
#include "instrument_worker.hpp"

namespace pmts::app {

void InstrumentDesk::Worker::setControl(const ControlSettings& control) {
    const ControlSettings before = std::exchange(control_, control);
    if (!connection_) {
        return;
    }
    if (before.path_switch != control_.path_switch) {
        connection_->setPathSwitch(control_.path_switch);
    }
    if (before.panel != control_.panel) {
        usePanel();
    }
    if (before.mode != control_.mode) {
        connection_->setControlMode(control_.mode);
    }
}

void InstrumentDesk::Worker::usePanel() {
    if (control_.panel) {
        connection_->usePanel([this] { return makePanelLink(); });
    } else {
        connection_->usePanel({});
    }
}

/// The adapter may be back under another name.
std::unique_ptr<transport::ByteLink> InstrumentDesk::Worker::makePanelLink() const {
    SerialChoice choice = *control_.panel;
    choice.path = pathNow(choice, portsFor(choice));
    return linkTo(choice);
}

}  // namespace pmts::app
