#pragma once

#include <QMetaType>
#include <QString>

namespace pmts::app {

/// The five states of every device and every value, shown by shape and colour (interface page, "States").
enum class DeviceState {
    kIdle,     ///< hollow grey
    kBusy,     ///< blue, turning
    kGood,     ///< green disc
    kWarning,  ///< amber triangle
    kFailed,   ///< red square
};

/// A state and the words for it.
struct StatusItem {
    DeviceState state = DeviceState::kIdle;
    QString text;     ///< short, as on the button: `Geodimeter 5603`
    QString details;  ///< one or two sentences for the tool tip

    [[nodiscard]] bool operator==(const StatusItem&) const = default;
};

}  // namespace pmts::app
