#include "pmts/instrument/control_settings.hpp"

namespace pmts::instrument {
namespace {

bool assertedIn(const LineInModes& line, scheduler::ControlMode mode) {
    switch (mode) {
        case scheduler::ControlMode::kShared:
            return line.shared;
        case scheduler::ControlMode::kComputer:
            return line.computer;
        case scheduler::ControlMode::kPanel:
            return line.panel;
    }
    return false;
}

}  // namespace

transport::ControlLines PathSwitch::linesIn(scheduler::ControlMode mode) const {
    transport::ControlLines lines;
    if (dtr) {
        lines.dtr = assertedIn(*dtr, mode) != inverted;
    }
    if (rts) {
        lines.rts = assertedIn(*rts, mode) != inverted;
    }
    return lines;
}

}  // namespace pmts::instrument
