#pragma once

#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/transport/serial_link.hpp"

namespace pmts::app {

/// A chosen port as the serial link takes it; no flow control.
[[nodiscard]] transport::SerialSettings serialSettings(const SerialChoice& choice);

}  // namespace pmts::app
