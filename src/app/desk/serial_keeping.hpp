#pragma once

#include "pmts/app/desk/serial_choice.hpp"

class QSettings;

namespace pmts::app {

/// A serial port kept under keys that begin with `prefix`: `serial/path`, `control/panel_path`. What is missing or out of
/// bounds is the default; an empty path: none was kept.
[[nodiscard]] SerialChoice serialFrom(const QSettings& file, const QString& prefix);
void saveSerial(QSettings& file, const QString& prefix, const SerialChoice& port);

}  // namespace pmts::app
