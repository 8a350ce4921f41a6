#pragma once

#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/transport/byte_link.hpp"

#include <memory>

namespace pmts::app {

/// Where the chosen USB adapter is now, whatever name it had; the chosen path where it cannot be told or is no adapter.
[[nodiscard]] QString pathNow(const SerialChoice& choice, const std::vector<transport::PortInfo>& present);

/// Another adapter has the chosen name now: what is sent there would reach another device.
[[nodiscard]] bool isAnothersPort(const SerialChoice& choice, const std::vector<transport::PortInfo>& present);

/// A link in place of another's port: it fails to open, with the reason.
[[nodiscard]] std::unique_ptr<transport::ByteLink> anothersPort(const QString& path);

}  // namespace pmts::app
