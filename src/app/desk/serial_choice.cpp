#include "serial_settings.hpp"

namespace pmts::app {

namespace {

QChar parityLetter(Parity parity) {
    switch (parity) {
        case Parity::kNone: return u'N';
        case Parity::kOdd: return u'O';
        case Parity::kEven: return u'E';
    }
    return u'?';
}

}  // namespace

QString Framing::text() const { return QStringLiteral("%1%2%3").arg(data_bits).arg(parityLetter(parity)).arg(stop_bits); }

std::vector<Framing> Framing::usual() {
    return {{8, Parity::kNone, 1}, {7, Parity::kEven, 1}, {7, Parity::kOdd, 1},
            {8, Parity::kEven, 1}, {8, Parity::kOdd, 1},  {8, Parity::kNone, 2}};
}

QString SerialChoice::text() const { return QStringLiteral("%1 at %2 %3").arg(path).arg(baud).arg(framing().text()); }

transport::SerialSettings serialSettings(const SerialChoice& choice) {
    return {.port_name = choice.path,
            .baud = choice.baud,
            .data_bits = choice.data_bits,
            .parity = static_cast<transport::Parity>(choice.parity),
            .stop_bits = choice.stop_bits,
            .flow_control = transport::FlowControl::kNone};
}

}  // namespace pmts::app
