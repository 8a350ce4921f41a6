#pragma once

#include "pmts/instrument/line_dialect.hpp"
#include "pmts/transport/port_finder.hpp"

#include <QMetaType>
#include <QString>

namespace pmts::app {

enum class Parity { kNone, kOdd, kEven };

/// What a person picks or types to reach an instrument; enough to find it again under another port name.
struct SerialChoice {
    QString path;                     ///< `/dev/ttyUSB0`, a pty or a link to one
    transport::PortIdentity adapter;  ///< as PortChoice gave it; empty for a typed path
    int baud = 9600;
    int data_bits = 8;
    Parity parity = Parity::kNone;
    int stop_bits = 1;
    instrument::LineDialect dialect = instrument::LineDialect::kExternal;

    [[nodiscard]] bool operator==(const SerialChoice&) const = default;
    /// `/dev/ttyUSB0 at 9600 8N1`.
    [[nodiscard]] QString text() const;
};

/// One line of the port list.
struct PortChoice {
    QString path;
    QString name;               ///< friendly: `USB-Serial Controller (Prolific), /dev/ttyUSB0`
    transport::PortIdentity adapter;  ///< goes into SerialChoice
    bool used_last = false;
};

}  // namespace pmts::app
