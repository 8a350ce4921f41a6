#include "pmts/app/line/instrument_health.hpp"

#include "pmts/geometry/polar.hpp"
#include "pmts/protocol/labels.hpp"
#include "pmts/protocol/reply.hpp"

#include <QLocale>

#include <algorithm>

namespace pmts::app {
namespace {

const QString kTopic = QStringLiteral("instrument_care");
constexpr int kHumidity = 65;  // an older instrument may mean something else by it: a number of percent or nothing
constexpr int kAirLabels[] = {protocol::kTemperature, protocol::kPressure, kHumidity, protocol::kPpm};
constexpr int kTilted = 1, kBatteryLow = 8, kExternalBatteryLow = 9;

}  // namespace

InstrumentHealth::InstrumentHealth(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                                   const core::Clock& clock, QObject* parent)
    : QObject(parent), instrument_(instrument), preferences_(preferences), messages_(messages), clock_(clock) {
    instrument_.setTargetTest(targetTest());
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, [this](const TimedPointing& reading) {
        const bool face_two = geometry::isFaceTwo(reading.pointing);
        if (std::exchange(face_two_, face_two) != face_two) {
            Q_EMIT changed();
        }
    });
    connect(&instrument_, &InstrumentDesk::transactionFinished, this, &InstrumentHealth::noteTransaction);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, [this] { isConnected() ? refresh() : forget(); });
    connect(&instrument_, &InstrumentDesk::labelRead, this, &InstrumentHealth::onLabel);
    connect(&instrument_, &InstrumentDesk::labelWritten, this, [this](Ticket ticket, int label) {
        if (ticket == switch_ticket_ && label == protocol::kCompensator) {
            switch_ticket_ = 0;
            refresh();
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &InstrumentHealth::onFailed);
    connect(&instrument_, &InstrumentDesk::instrumentAsks, this, [this](Ticket ticket) {
        if (ticket == calibration_ticket_ && ticket != 0) {
            Q_EMIT questionAsked();
        }
    });
    connect(&instrument_, &InstrumentDesk::compensatorCalibrated, this,
            [this](Ticket ticket, const instrument::CompensatorRun& run) {
                if (ticket == calibration_ticket_) {
                    endCalibration(run.answered_no ? tr("The instrument was answered no and calibrated nothing.")
                                   : run.ended_by_block
                                       ? tr("The instrument has calibrated its compensator.")
                                       : tr("The instrument answers again; it did not say how the calibration ended."));
                    refresh();
                }
            });
}

bool InstrumentHealth::isConnected() const { return instrument_.connectionState() == ConnectionState::kConnected; }

const instrument::TargetTest& InstrumentHealth::targetTest() const {
    return preferences_.settings().instrument_care.target_test;
}

void InstrumentHealth::forget() {
    face_two_.reset();
    compensator_on_.reset();
    air_ = {};
    air_tickets_.clear();
    without_.clear();
    battery_code_.reset();
    battery_at_ = fine_at_ = tilted_at_ = {};
    tilted_ = false;
    Q_EMIT changed();
}

// What the instrument says in passing ----------------------------------------------------------------------------------

void InstrumentHealth::noteTransaction(const scheduler::TransactionRecord& record) {
    const auto line = std::string_view(record.received).substr(0, record.received.find_first_of("\r\n"));
    if (const auto status = protocol::parseStatus(line)) {
        const bool is_measurement = record.sent.starts_with("RG") && record.sent.find(',') == std::string::npos;
        noteStatus(status->code, is_measurement);
    }
}

/// Only the status of a measurement says that all is well; the others come with any command.
void InstrumentHealth::noteStatus(int code, bool is_measurement) {
    const QDateTime now = clock_.utcNow();
    if (code == kTilted) {
        tilted_ = true;
        tilted_at_ = now;
    } else if (code == kBatteryLow || code == kExternalBatteryLow) {
        battery_code_ = code;
        battery_at_ = now;
        tilted_ = is_measurement ? false : tilted_;
        fine_at_ = is_measurement ? now : fine_at_;
    } else if (code == 0 && is_measurement) {
        tilted_ = false;
        battery_code_.reset();
        fine_at_ = now;
    } else {
        return;
    }
    Q_EMIT changed();
}

QString InstrumentHealth::age(const QDateTime& since) const {
    const qint64 seconds = since.secsTo(clock_.utcNow());
    const QString at = QLocale().toString(since.toLocalTime().time(), QLocale::ShortFormat);
    return seconds < 60 ? tr("%1, %2 s ago").arg(at).arg(std::max<qint64>(0, seconds))
                        : tr("%1, %2 min ago").arg(at).arg(seconds / 60);
}

StatusItem InstrumentHealth::face() const {
    if (!isConnected() || !face_two_) {
        return {DeviceState::kIdle, tr("Not known"), tr("No circle reading yet.")};
    }
    return *face_two_ ? StatusItem{DeviceState::kGood, tr("Face II"),
                                   tr("VA is above 200 gon. The instrument may refuse commands here (info 24).")}
                      : StatusItem{DeviceState::kGood, tr("Face I"), tr("VA is below 200 gon.")};
}

StatusItem InstrumentHealth::compensator() const {
    if (isCalibrating()) {
        return {DeviceState::kBusy, tr("Calibrating"), calibration_text_};
    }
    if (!isConnected() || !compensator_on_) {
        return {DeviceState::kIdle, tr("Not known"),
                isConnected() && !canAsk() ? tr("The bus does not tell it: connect to the instrument's foot.")
                                           : tr("Label 22 was not read.")};
    }
    return *compensator_on_ ? StatusItem{DeviceState::kGood, tr("On"), calibration_text_}
                            : StatusItem{DeviceState::kWarning, tr("Off"),
                                         tr("Readings are not corrected for the tilt of the standing axis.")};
}

StatusItem InstrumentHealth::battery() const {
    if (battery_code_) {
        return {DeviceState::kWarning, *battery_code_ == kBatteryLow ? tr("Low") : tr("External battery low"),
                tr("Info %1 at %2. Change the battery soon.").arg(*battery_code_).arg(age(battery_at_))};
    }
    if (!isConnected() || !fine_at_.isValid()) {
        return {DeviceState::kIdle, tr("Not known"),
                tr("The instrument says it with a measurement, there is no question for it.")};
    }
    return {DeviceState::kGood, tr("No warning"), tr("With the measurement at %1.").arg(age(fine_at_))};
}

StatusItem InstrumentHealth::level() const {
    if (tilted_) {
        return {DeviceState::kFailed, tr("Out of level"),
                tr("Info 1 at %1: the compensator is out of its range. Level the instrument.").arg(age(tilted_at_))};
    }
    if (compensator_on_ == false) {
        return {DeviceState::kWarning, tr("Not watched"), tr("With the compensator off nobody notices a tilt.")};
    }
    if (!isConnected() || !fine_at_.isValid()) {
        return {DeviceState::kIdle, tr("Not known"),
                tr("The instrument says it with a measurement, there is no question for it.")};
    }
    return {DeviceState::kGood, tr("Within range"), tr("With the measurement at %1.").arg(age(fine_at_))};
}

StatusItem InstrumentHealth::airUsed() const {
    if (air_.isEmpty()) {
        return {DeviceState::kIdle, tr("Not known"), tr("The instrument told none of the labels 56, 74, 65 and 30.")};
    }
    const QString labels = tr("Its labels 56, 74, 65 and 30, where it has them.");
    return {DeviceState::kGood, air_.text(), air_at_.isValid() ? labels + u' ' + tr("Read at %1.").arg(age(air_at_)) : labels};
}

DeviceState InstrumentHealth::state() const { return std::max({compensator().state, battery().state, level().state}); }

// What is asked and ordered ---------------------------------------------------------------------------------------------

void InstrumentHealth::refresh() {
    if (canAsk() && !isCalibrating()) {
        compensator_ticket_ = instrument_.readLabel(protocol::kCompensator);
        air_tickets_.clear();
        for (const int label : kAirLabels) {
            if (!without_.contains(label)) {
                air_tickets_[instrument_.readLabel(label)] = label;
            }
        }
    }
}

void InstrumentHealth::keepAir(int label, const QString& data) {
    const std::string text = data.trimmed().toStdString();
    const protocol::WireUnits units = instrument_.identity() ? instrument_.identity()->units : protocol::WireUnits();
    const auto kept = [](const core::Result<double>& number) { return number ? std::optional(*number) : std::nullopt; };
    switch (label) {
        case protocol::kTemperature: air_.temperature_degc = kept(protocol::degcFromWire(text, units.temperature)); break;
        case protocol::kPressure: air_.pressure_mbar = kept(protocol::mbarFromWire(text, units.pressure)); break;
        case protocol::kPpm: air_.ppm = kept(protocol::numberFromWire(text)); break;
        case kHumidity:
            air_.humidity_percent = kept(protocol::numberFromWire(text));
            if (air_.humidity_percent.value_or(0) < 0 || air_.humidity_percent.value_or(0) > 100) {
                air_.humidity_percent.reset();
            }
            break;
        default: break;
    }
    air_at_ = clock_.utcNow();
}

void InstrumentHealth::showAir(const InstrumentAir& air) {
    air_ = air;
    air_at_ = {};
    Q_EMIT changed();
}

void InstrumentHealth::onLabel(Ticket ticket, int label, const QString& data) {
    if (ticket == compensator_ticket_ && label == protocol::kCompensator) {
        compensator_on_ = data.trimmed() != QLatin1String("0");
    } else if (air_tickets_.erase(ticket) > 0 && instrument_.identity()) {
        keepAir(label, data);
    } else {
        return;
    }
    Q_EMIT changed();
}

void InstrumentHealth::switchCompensator(bool on) {
    if (!canAsk()) {
        return;
    }
    messages_.solve(kTopic);
    switch_ticket_ = instrument_.writeLabel(protocol::kCompensator, on ? QStringLiteral("1") : QStringLiteral("0"));
}

void InstrumentHealth::calibrateCompensator() {
    if (isCalibrating() || !canAsk()) {
        return;
    }
    messages_.solve(kTopic);
    calibration_ticket_ = instrument_.calibrateCompensator();
    calibration_text_ = tr("The instrument turns by itself and measures its compensator in both faces, about 20 s.");
    Q_EMIT changed();
}

void InstrumentHealth::answer(bool yes) {
    if (isCalibrating()) {
        instrument_.answerInstrument(yes);
    }
}

void InstrumentHealth::cancel() {
    if (isCalibrating()) {
        instrument_.cancel(calibration_ticket_);
    }
}

void InstrumentHealth::endCalibration(const QString& text) {
    calibration_ticket_ = 0;
    calibration_text_ = text;
    Q_EMIT changed();
}

void InstrumentHealth::onFailed(Ticket ticket, const core::Error& error) {
    if (const auto air = air_tickets_.find(ticket); air != air_tickets_.end()) {
        if (error.kind == core::ErrorKind::kDevice) {
            without_.insert(air->second);
        }
        air_tickets_.erase(air);
        return;
    }
    if (ticket == calibration_ticket_ && ticket != 0) {
        endCalibration(error.kind == core::ErrorKind::kCancelled
                           ? tr("Cancelled here; the instrument may go on by itself until it is through.")
                           : error.happened);
    } else if (ticket != switch_ticket_ || ticket == 0) {
        return;
    }
    switch_ticket_ = 0;
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kTopic);
    }
    refresh();
}

void InstrumentHealth::setTargetTest(const instrument::TargetTest& test) {
    Settings next = preferences_.settings();
    next.instrument_care.target_test = test;
    preferences_.set(next);
    instrument_.setTargetTest(test);
    Q_EMIT changed();
}

}  // namespace pmts::app
