#include "pmts/transport/byte_link.hpp"

#include <QCoreApplication>

namespace pmts::transport {

core::Result<void> ByteLink::setControlLines(const ControlLines& lines) {
    if (!lines.dtr && !lines.rts) {
        return {};
    }
    return core::fail(core::ErrorKind::kUnsupported,
                      QCoreApplication::translate("ByteLink", "%1 has no DTR and RTS lines.").arg(description()),
                      QCoreApplication::translate("ByteLink", "Choose a real serial port to drive a switch with."));
}

core::Result<void> ByteLink::setBreak(bool /*on*/) {
    return core::fail(core::ErrorKind::kUnsupported,
                      QCoreApplication::translate("ByteLink", "%1 cannot send a BREAK.").arg(description()),
                      QCoreApplication::translate("ByteLink", "Switch the instrument on by its own key."));
}

}  // namespace pmts::transport
