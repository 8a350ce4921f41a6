#include "pmts/app/desk/connection_checks.hpp"

#include "pmts/instrument/line_symptom.hpp"
#include "pmts/protocol/labels.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/units.hpp"

#include <utility>

namespace pmts::app {

using instrument::LineSymptom;

namespace {

constexpr int kUsualMark = '>';

bool asksLabel(const scheduler::TransactionRecord& record, int label) {
    return record.sent == "RG," + std::to_string(label) + "\r";
}

QString unitsText(const protocol::WireUnits& units) {
    using namespace protocol;
    const QString angle = units.angle == WireAngleUnit::kGon   ? ConnectionChecks::tr("gon")
                          : units.angle == WireAngleUnit::kDms ? ConnectionChecks::tr("degrees, minutes, seconds")
                          : units.angle == WireAngleUnit::kMil ? ConnectionChecks::tr("mil")
                                                               : ConnectionChecks::tr("decimal degrees");
    const QString length = units.length == WireLengthUnit::kMetre ? ConnectionChecks::tr("metre") : ConnectionChecks::tr("foot");
    return ConnectionChecks::tr("Label 23 = %1: %2, %3.").arg(QString::fromStdString(unitStatusText(units)), angle, length);
}

}  // namespace

ConnectionChecks::ConnectionChecks(InstrumentDesk& instrument, QObject* parent) : QObject(parent), instrument_(instrument) {
    begin();
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &ConnectionChecks::onConnection);
    connect(&instrument_, &InstrumentDesk::connectFailed, this, &ConnectionChecks::onFailed);
    connect(&instrument_, &InstrumentDesk::transactionFinished, this, &ConnectionChecks::onTransaction);
    connect(&instrument_, &InstrumentDesk::unsolicitedBlock, this, &ConnectionChecks::onUnasked);
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &ConnectionChecks::onPointing);
}

void ConnectionChecks::begin() {
    heard_.clear();
    if (isBus()) {
        items_ = {};
        items_[kPort].title = tr("Port");
        items_[kStream].title = tr("Stream");
        items_[kAngles].title = tr("Angles");
        Q_EMIT changed();
        return;
    }
    items_ = {CheckItem{.state = DeviceState::kIdle, .title = tr("Port"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("Bytes"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("Answer"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("End mark"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("Units"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("Number"), .sentence = {}},
              CheckItem{.state = DeviceState::kIdle, .title = tr("Output"), .sentence = {}}};
    Q_EMIT changed();
}

void ConnectionChecks::set(Check check, DeviceState state, const QString& sentence) {
    CheckItem& item = items_.at(check);
    if (item.state != state || item.sentence != sentence) {
        item.state = state;
        item.sentence = sentence;
        Q_EMIT changed();
    }
}

void ConnectionChecks::onConnection(ConnectionState state) {
    const auto before = std::exchange(last_state_, state);
    const bool was_there = before == ConnectionState::kConnected || before == ConnectionState::kReconnecting;
    if (state == ConnectionState::kConnecting && items_[kPort].state != DeviceState::kBusy) {
        begin();
        set(kPort, DeviceState::kBusy, tr("%1 is being opened.").arg(instrument_.choice().text()));
    } else if (state == ConnectionState::kConnected) {
        showConnected();
    } else if (state == ConnectionState::kReconnecting) {
        begin();
        set(kPort, DeviceState::kFailed, instrument_.connectionSentence());
    } else if (state == ConnectionState::kDisconnected && was_there) {
        begin();
    } else if (state == ConnectionState::kDisconnected) {
        for (std::size_t i = 0; i < kCount; ++i) {
            if (items_.at(i).state == DeviceState::kBusy) {
                set(static_cast<Check>(i), DeviceState::kIdle, {});
            }
        }
    }
}

void ConnectionChecks::showConnected() {
    set(kPort, DeviceState::kGood, tr("%1 is open.").arg(instrument_.choice().text()));
    if (isBus()) {
        set(kStream, DeviceState::kGood, tr("The angle stream comes by itself."));
    } else if (items_[kOutput].state == DeviceState::kIdle) {
        set(kOutput, DeviceState::kGood, tr("Nothing comes unasked: the output is set to Request."));
    }
}

void ConnectionChecks::onPointing() {
    if (isBus()) {
        set(kAngles, DeviceState::kGood, tr("VA and HA are read, in gon with five decimals."));
    }
}

void ConnectionChecks::onFailed(const core::Error& error) {
    if (error.kind == core::ErrorKind::kCancelled) {
        return;
    }
    if (error.kind == core::ErrorKind::kPortUnavailable) {
        set(kPort, DeviceState::kFailed, error.sentence());
    } else if (isBus()) {
        set(kPort, DeviceState::kGood, tr("%1 is open.").arg(instrument_.choice().text()));
        set(kStream, DeviceState::kFailed, error.sentence());
    } else if (items_[kGrammar].state == DeviceState::kGood) {
        const auto is_open = [this](Check check) { return items_.at(check).state != DeviceState::kGood; };
        set(is_open(kUnits) ? kUnits : is_open(kSerialNumber) ? kSerialNumber : kGrammar, DeviceState::kFailed, error.sentence());
    } else if (heard_.empty()) {
        set(kPort, DeviceState::kGood, tr("%1 is open.").arg(instrument_.choice().text()));
        set(kBytes, DeviceState::kFailed,
            tr("No byte comes: switch the instrument on, check the cable, choose its serial interface (menu 4 1). At another speed "
               "it is silent too: \"Look for the settings\" tries them."));
    } else {
        judgeSilence();
    }
}

/// Bytes came, and no answer was found in them.
void ConnectionChecks::judgeSilence() {
    const auto evidence = instrument::judgeLine("RG,79\r", heard_);
    switch (evidence.symptom) {
        case LineSymptom::kEcho:
            set(kBytes, DeviceState::kWarning, tr("Only what PMTS sends comes back: the cable joins its own two data wires."));
            return;
        case LineSymptom::kModem: set(kGrammar, DeviceState::kFailed, tr("A modem answers: choose another port.")); return;
        case LineSymptom::kOtherDevice:
            set(kGrammar, DeviceState::kFailed, tr("Another device talks here: choose another port."));
            return;
        case LineSymptom::kBusStream:
            set(kGrammar, DeviceState::kFailed,
                tr("This is the bus under the panel: choose it as the line, or let \"Look for the settings\" choose it."));
            return;
        case LineSymptom::kGarbled:
            set(kGrammar, DeviceState::kFailed,
                tr("The bytes are no text: speed or framing differ (label 78). \"Look for the settings\" finds them."));
            return;
        default: set(kGrammar, DeviceState::kFailed, tr("What came was no whole answer: try again.")); return;
    }
}

void ConnectionChecks::onTransaction(const scheduler::TransactionRecord& record) {
    if (record.master != scheduler::Master::kComputer || isBus()) {
        return;
    }
    if (items_[kPort].state == DeviceState::kBusy) {
        set(kPort, DeviceState::kGood, tr("%1 is open.").arg(instrument_.choice().text()));
    }
    if (items_[kGrammar].state != DeviceState::kGood) {
        judgeFirst(record);
    }
    if (asksLabel(record, protocol::kUnits)) {
        judgeUnits(record.received);
    } else if (asksLabel(record, protocol::kSerialNumber)) {
        judgeSerialNumber(record.received);
    }
}

void ConnectionChecks::judgeFirst(const scheduler::TransactionRecord& record) {
    heard_ += record.received;
    if (heard_.empty()) {
        set(kBytes, DeviceState::kBusy, tr("Asked, nothing has come yet."));
        return;
    }
    set(kBytes, DeviceState::kGood, tr("The instrument's wire is alive: %1 bytes.").arg(heard_.size()));
    const auto evidence = instrument::judgeLine(record.sent, record.received);
    if (!evidence.isInstrument()) {
        set(kGrammar, DeviceState::kBusy, tr("What came is not understood yet."));
        return;
    }
    set(kGrammar, DeviceState::kGood, tr("An instrument answers."));
    if (evidence.echoes) {
        set(kBytes, DeviceState::kWarning, tr("What PMTS sends comes back before the answer: switch the adapter's echo off."));
    }
    if (evidence.label_79 && *evidence.label_79 == kUsualMark) {
        set(kEndMark, DeviceState::kGood, tr("Every answer ends with \">\" (label 79 = 62)."));
    } else if (evidence.label_79 && *evidence.label_79 == 0) {
        set(kEndMark, DeviceState::kWarning, tr("Answers have no end mark (label 79 = 0), each waits for silence: set 62."));
    } else if (evidence.label_79) {
        set(kEndMark, DeviceState::kWarning, tr("Label 79 = %1: PMTS lives with it, 62 is usual.").arg(*evidence.label_79));
    } else {
        set(kEndMark, DeviceState::kWarning, tr("The instrument does not tell its end mark (label 79); PMTS takes \">\"."));
    }
}

void ConnectionChecks::judgeUnits(const std::string& received) {
    const auto reply = protocol::parseReply(received);
    const auto* const item = reply.find(protocol::kUnits);
    const auto units = item != nullptr ? protocol::parseUnitStatus(item->data) : core::Result<protocol::WireUnits>(protocol::WireUnits());
    if (item != nullptr && units) {
        set(kUnits, DeviceState::kGood, unitsText(*units));
    } else if (items_[kUnits].state != DeviceState::kGood) {
        set(kUnits, DeviceState::kWarning, tr("Label 23 cannot be read: no angle is believed before its units are known."));
    }
}

void ConnectionChecks::judgeSerialNumber(const std::string& received) {
    const auto reply = protocol::parseReply(received);
    if (const auto* const item = reply.find(protocol::kSerialNumber)) {
        set(kSerialNumber, DeviceState::kGood, tr("Label 55 = %1.").arg(QString::fromStdString(item->data)));
    } else if (items_[kSerialNumber].state != DeviceState::kGood) {
        set(kSerialNumber, DeviceState::kWarning, tr("Label 55 cannot be read; another instrument would not be noticed."));
    }
}

void ConnectionChecks::onUnasked() {
    if (isBus()) {
        return;
    }
    set(kOutput, DeviceState::kWarning, tr("Blocks come unasked: set the output to Request (menu 4 1), unless REG is meant to send."));
}

}  // namespace pmts::app
