#include "pmts/instrument/control_settings.hpp"

#include <QObject>

namespace pmts::instrument {
namespace {

const QString kPanelControl = QStringLiteral("mode of control: panel");

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

core::Error panelHasControl() {
    return {.kind = core::ErrorKind::kRefused,
            .happened = QObject::tr("The panel has control: PMTS sends nothing."),
            .remedy = QObject::tr("Take control back, or share it, with the control switch."),
            .info_code = std::nullopt,
            .detail = kPanelControl};
}

bool isPanelControl(const core::Error& error) {
    return error.kind == core::ErrorKind::kRefused && error.detail == kPanelControl;
}

}  // namespace pmts::instrument
