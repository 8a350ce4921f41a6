#include "axis_errors.hpp"
#include "pmts/geometry/polar.hpp"
#include "station_impl.hpp"

#include <algorithm>
#include <array>

namespace pmts::simulator {

using core::Angle;

bool Station::Impl::isFaceTwo() const { return geometry::isFaceTwo(pointing_->at(clock_.now())); }

bool Station::Impl::compensated() const { return labels_.number(protocol::kCompensator) != 0.0; }

bool Station::Impl::withoutControlUnit() const { return settings_.bare_station || struckBy("no_cu"); }

/// Temperature, pressure and humidity exist twice: in the base and in the control unit.
LabelStore& Station::Impl::storeOf(char unit, int label) {
    constexpr std::array kKeptTwice{protocol::kPpm, protocol::kTemperature, 65, 66, protocol::kPressure};
    const bool twice = std::find(kKeptTwice.begin(), kKeptTwice.end(), label) != kKeptTwice.end();
    return unit == 'R' && twice ? cu_labels_ : labels_;
}

void Station::Impl::write(const CommandLine& command) {
    const bool addressed = command.unit == 'G' || command.unit == 'R';
    if (!addressed || !command.number || !command.data || !command.arguments.empty()) {
        answerStatus(info::kSyntax);
    } else if (command.unit == 'R' && withoutControlUnit()) {
        answerStatus(info::kWrongDevice);
    } else {
        answerDone(writeLabel(command));
    }
}

int Station::Impl::writeLabel(const CommandLine& command) {
    const int label = *command.number;
    LabelStore& store = storeOf(command.unit, label);
    const int code = store.write(label, *command.data);
    if (code == kAccepted && &store == &labels_) {
        applyWritten(label);
    }
    return code;
}

void Station::Impl::applyWritten(int label) {
    switch (label) {
        case protocol::kHaRef:
            orientation_ = Angle::fromGon(labels_.number(label)) -
                           circleReading(settings_, pointing_->at(clock_.now()), compensated()).ha;
            break;
        case protocol::kEndMark:
            if (settings_.end_mark_changes_at_once) {
                end_mark_ = static_cast<int>(labels_.number(label));
            }
            break;
        case protocol::kLineParameters:
            if (settings_.baud > 0.0) {
                setPace(plainNumber(std::string_view(labels_.raw(label)).substr(6)).value_or(settings_.baud));
            }
            break;
        case protocol::kNorthing:
        case protocol::kEasting:
        case protocol::kElevation:
            shows_point_ = false;  // the station's own coordinates, until the next distance
            break;
        case kDate:
        case kTime: {
            const QDateTime shown = clock_.utcNow().addSecs(clock_offset_s_);
            const QString text = QString::fromStdString(labels_.raw(label));
            const QDate date = label == kDate ? QDate::fromString(text, kDateFormat) : shown.date();
            const QTime time = label == kTime ? QTime::fromString(text, kTimeFormat) : shown.time();
            clock_offset_s_ += shown.secsTo(QDateTime(date, time, Qt::UTC));
            break;
        }
        default:
            break;
    }
}

void Station::Impl::trigger(const CommandLine& command) {
    const bool plain = command.arguments.empty() || command.arguments == "<" || command.arguments == ">";
    if (command.unit != 'G' || !plain || command.number || command.data) {
        answerStatus(info::kSyntax);
        return;
    }
    if (withoutControlUnit() || struckBy("tg_ignored")) {
        answerDone();
        return;
    }
    if (isFaceTwo() && (settings_.refuse_face_two || meter_.mode() == EdmMode::kTrk)) {
        answerStatus(settings_.refuse_face_two ? info::kNotInThisState : info::kWrongFace);
        return;
    }
    if (isFaceTwo()) {
        face_two_ = takeReading();
    }
    for (const auto& [fault, status] :
         {std::pair{"target_lost", info::kTargetLost}, {"distance_jump", info::kDistanceJump}}) {
        if (faults_.take(fault, current_)) {
            meter_.failNext(status);
        }
    }
    if (const auto late_s = faults_.take("distance_late", current_)) {
        meter_.delayNext(scaled(*late_s));
    }
    const auto range = command.arguments == "<"   ? RangeChoice::kShort
                       : command.arguments == ">" ? RangeChoice::kLong
                                                  : RangeChoice::kNormal;
    meter_.trigger(range);
    waits_for_distance_ = settings_.trigger_ends_late && meter_.isRunning();
    if (!waits_for_distance_) {
        answerDone();
    }
}

void Station::Impl::distanceArrived() {
    measured_at_ = pointing_->at(clock_.now());
    shows_point_ = true;
    if (std::exchange(waits_for_distance_, false)) {
        answerDone();
    }
    if (settings_.output == QLatin1String("slave") && !meter_.averages()) {
        emitBlock(
            measurementBlock('S', settings_.unsolicited_status, settings_.slave_block_counts_as_reading));
    }
}

void Station::Impl::measuringEnded() {
    const bool failed = meter_.state() == DistanceState::kFailed;
    if (std::exchange(waits_for_distance_, false)) {
        answerDone(failed ? meter_.failure() : kAccepted);
    }
    const bool slave = settings_.output == QLatin1String("slave");
    if (slave && meter_.averages() && meter_.hasDistance()) {
        emitBlock(
            measurementBlock('S', settings_.unsolicited_status, settings_.slave_block_counts_as_reading));
    }
}

void Station::Impl::runProcess(const CommandLine& command) {
    constexpr int kMode = 3, kCalibrate = 20, kSwitchOff = 21;
    const int process = command.number.value_or(-1);
    if (process < 0 || !command.arguments.empty() || (command.unit != 'G' && command.unit != 'V')) {
        answerStatus(info::kSyntax);
    } else if (command.unit == 'G' && process == kMode) {
        const std::string mode = command.data.value_or("");
        if (mode.size() != 1 || mode[0] < '0' || mode[0] > '4') {
            answerStatus(kBadData);
            return;
        }
        meter_.selectMode(static_cast<EdmMode>(mode[0] - '0'));
        face_two_.reset();
        answerDone();
    } else if (command.unit == 'V' && process == kCalibrate) {
        startCalibration();
    } else if (command.unit == 'V' && process == kSwitchOff) {
        switchOff();
    } else {
        answerStatus(info::kWrongProcess);
    }
}

/// `P` and one or two pairs of an axis letter and two digits, cc.
std::optional<Station::Impl::PositionOrder> Station::Impl::positionOrder(const std::string& data) {
    constexpr std::size_t kPair = 3;
    const bool shape = data.size() == 1 + kPair || data.size() == 1 + 2 * kPair;
    if (!shape || data[0] != 'P') {
        return std::nullopt;
    }
    PositionOrder order;
    for (std::size_t at = 1; at < data.size(); at += kPair) {
        const auto tolerance = plainNumber(data.substr(at + 1, 2));
        const bool digits = data.find_first_not_of("0123456789", at + 1) >= at + kPair;
        if (!tolerance || !digits || (data[at] != 'H' && data[at] != 'V')) {
            return std::nullopt;
        }
        (data[at] == 'H' ? order.ha_tolerance : order.va_tolerance) = Angle::fromCc(*tolerance);
    }
    return order;
}

void Station::Impl::position(const CommandLine& command) {
    const auto order = command.data && !command.number ? positionOrder(*command.data) : std::nullopt;
    if (!order) {
        answerStatus(info::kSyntax);
    } else if (settings_.refuse_face_two && isFaceTwo()) {
        answerStatus(info::kNotInThisState);
    } else if (faults_.take("target_not_found", current_)) {
        answerStatus(info::kTargetNotFound);
    } else {
        startPositioning(*order);
    }
}

/// Where an axis settles beside its target, and whether that is out of tolerance.
std::pair<Angle, bool> Station::Impl::residual(Angle tolerance, const char* fault) {
    const Angle allowed = tolerance > Angle{} ? tolerance : settings_.usual_tolerance;
    if (const auto injected_cc = faults_.value(fault)) {
        const Angle beside = Angle::fromCc(*injected_cc);
        (void)struckBy(fault);
        return {beside, beside > allowed};
    }
    constexpr double kPartUsed = 0.9;
    return {allowed * std::uniform_real_distribution(-kPartUsed, kPartUsed)(random_), false};
}

void Station::Impl::startPositioning(const PositionOrder& order) {
    const Angle va_target = Angle::fromGon(labels_.number(protocol::kTargetVa));
    const bool on_circle = va_target >= Angle{} && va_target < Angle::fromGon(400.0);
    const bool blocked = va_target > settings_.blocked_va_from && va_target < settings_.blocked_va_to;
    if (order.va_tolerance && (!on_circle || blocked)) {
        answerStatus(settings_.out_of_range_status);
        return;
    }
    const geometry::Pointing here = pointing_->at(clock_.now());
    geometry::Pointing circles = circleReading(settings_, here, compensated());
    bool ha_missed = false, va_missed = false;
    if (order.ha_tolerance) {
        const auto [beside, missed] = residual(*order.ha_tolerance, "residual_h");
        circles.ha = Angle::fromGon(labels_.number(protocol::kTargetHa)) - orientation_ + beside;
        ha_missed = missed;
    }
    if (order.va_tolerance) {
        const auto [beside, missed] = residual(*order.va_tolerance, "residual_v");
        circles.va = va_target + beside;
        va_missed = missed;
    }
    const int status = ha_missed && va_missed ? info::kBothResiduals
                       : ha_missed            ? info::kHorizontalResidual
                       : va_missed            ? info::kVerticalResidual
                                              : kAccepted;
    goTo(trueFromReading(settings_, circles, compensated()), status);
}

void Station::Impl::goTo(const geometry::Pointing& true_target, int status_at_end) {
    for (const auto& [fault, status] : {std::pair{"motor_overload_h", info::kHorizontalOverload},
                                        {"motor_overload_v", info::kVerticalOverload},
                                        {"end_switch", info::kEndSwitch}}) {
        if (faults_.take(fault, current_)) {
            servo_.turnHalfWayTo(true_target, [this, code = status] { answerDone(code); });
            return;
        }
    }
    const int code = std::exchange(forced_motion_status_, std::nullopt).value_or(status_at_end);
    servo_.turnTo(true_target, [this, code] { answerDone(code); });
}

}  // namespace pmts::simulator
