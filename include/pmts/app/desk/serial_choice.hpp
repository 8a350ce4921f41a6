#pragma once

#include "pmts/instrument/line_dialect.hpp"
#include "pmts/transport/port_finder.hpp"

#include <QMetaType>
#include <QString>

#include <vector>

namespace pmts::app {

enum class Parity { kNone, kOdd, kEven };

/// How a byte is framed on the line.
struct Framing {
    int data_bits = 8;
    Parity parity = Parity::kNone;
    int stop_bits = 1;

    [[nodiscard]] bool operator==(const Framing&) const = default;
    [[nodiscard]] QString text() const;  ///< `8N1`
    /// Those that instruments can be set to, the usual one first (label 78).
    [[nodiscard]] static std::vector<Framing> usual();
};

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
    [[nodiscard]] Framing framing() const { return {data_bits, parity, stop_bits}; }
};

/// One line of the port list.
struct PortChoice {
    QString path;
    QString name;               ///< friendly: `USB-Serial Controller (Prolific), /dev/ttyUSB0`
    transport::PortIdentity adapter;  ///< goes into SerialChoice
    bool used_last = false;
};

}  // namespace pmts::app
