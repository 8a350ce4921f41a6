#include "axis_errors.hpp"
#include "pmts/geometry/polar.hpp"
#include "station_impl.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::simulator {
namespace {

using core::Angle;

constexpr int kHaFaceTwo = 17, kVaFaceTwo = 18, kHaFaceOne = 24, kVaFaceOne = 25;

/// The last of contradicting letters counts; nullopt for a letter that is none of them.
std::optional<ReadForm> formOf(const std::string& arguments) {
    const bool known = arguments.find_first_not_of("SNDVT") == std::string::npos;
    if (!known) {
        return std::nullopt;
    }
    return arguments.empty() ? 'S' : arguments.back();
}

}  // namespace

void Station::Impl::read(const CommandLine& command) {
    const auto form = formOf(command.arguments);
    const bool addressed = command.unit == 'G' || command.unit == 'R';
    if (!form || !addressed || command.data) {
        answerStatus(info::kSyntax);
    } else if (command.unit == 'R' && withoutControlUnit()) {
        answerStatus(info::kWrongDevice);
    } else if (*form == 'T') {
        signalTest();
    } else if (command.number) {
        readOneLabel(command, *form);
    } else {
        answer(measurementBlock(*form, true, true));
    }
}

void Station::Impl::signalTest() {
    const bool signal = lightWay().has_value();
    answerStatus(signal ? info::kSignal : info::kNoSignal);
}

void Station::Impl::readOneLabel(const CommandLine& command, ReadForm form) {
    const int label = *command.number;
    if (protocol::findLabel(label) == nullptr) {
        answerStatus(kLabelUnknown);
        return;
    }
    const bool measured = protocol::findLabel(label)->access == protocol::LabelAccess::kMeasured ||
                          protocol::findLabel(label)->access == protocol::LabelAccess::kCalculated;
    if (const auto refused = measured ? readingRefused() : std::nullopt) {
        answerStatus(*refused);
        return;
    }
    const LabelStore& store = storeOf(command.unit, label);
    const auto text = &store == &cu_labels_ ? store.text(label) : labelText(label, takeReading());
    if (text) {
        answer({std::nullopt, item(label, *text, form)});
    } else if (label == protocol::kSd || distanceLabel(label, {{}, 1.0})) {
        answerStatus(meter_.hasDistance() && targetMoved() ? settings_.target_test_status
                                                           : settings_.status_without_distance);
    } else {
        answerStatus(measured ? info::kNoData : kLabelUnknown);
    }
}

std::optional<int> Station::Impl::readingRefused() {
    if (const auto status = std::exchange(pending_reading_status_, std::nullopt)) {
        faults_.strike(QStringLiteral("memory_lost"));
        return status;
    }
    const Angle tilt = Angle::fromRad(std::hypot(settings_.tilt_north.rad(), settings_.tilt_east.rad()));
    const bool tilted = struckBy("level_loss") || tilt > settings_.compensator_range;
    if (tilted && compensated()) {
        return info::kTilted;
    }
    return settings_.refuse_face_two && isFaceTwo() ? std::optional(info::kNotInThisState) : std::nullopt;
}

Answer Station::Impl::measurementBlock(ReadForm form, bool with_status, bool marks_recorded) {
    if (const auto refused = readingRefused()) {
        return {statusText(*refused), {}};
    }
    const Reading now = takeReading();
    switch (meter_.state()) {
        case DistanceState::kNone:
            return refusedMeasurement(now, form, settings_.reading_without_distance, with_status);
        case DistanceState::kMeasuring:
            return refusedMeasurement(now, form, settings_.reading_while_measuring, with_status);
        case DistanceState::kFailed:
            return {statusText(meter_.failure()), {}};
        case DistanceState::kAvailableRecorded:
            return refusedMeasurement(now, form, settings_.reading_of_old_distance, with_status);
        case DistanceState::kAvailableNew:
            break;
    }
    if (targetMoved()) {
        return {statusText(settings_.target_test_status), {}};
    }
    if (marks_recorded) {
        meter_.markRecorded();
    }
    const int status = struckBy("battery_low") ? info::kBatteryLow : kAccepted;
    const auto labels = settings_.output_table.empty() ? blockLabels(true, now) : settings_.output_table;
    return {with_status ? std::optional(statusText(status)) : std::nullopt, items(labels, now, form)};
}

/// `how` is "angles", an info code, or both: "3+angles".
Answer Station::Impl::refusedMeasurement(const Reading& now, ReadForm form, const QString& how,
                                         bool with_status) const {
    const bool angles = how.endsWith(QLatin1String("angles"));
    const int usual = struckBy("battery_low") ? info::kBatteryLow : kAccepted;
    const int status = how == QLatin1String("angles") ? usual : how.section(u'+', 0, 0).toInt();
    Answer block{statusText(status), {}};
    if (angles) {
        block.lines = items({protocol::kHa, protocol::kVa}, now, form);
        block.status = with_status ? block.status : std::nullopt;
    }
    return block;
}

/// Table 0, protocol page 4.5.
std::vector<int> Station::Impl::blockLabels(bool with_distance, const Reading& now) const {
    using protocol::kHa, protocol::kSd, protocol::kVa;
    if (!with_distance) {
        return {kHa, kVa};
    }
    if (meter_.mode() == EdmMode::kTrk || !faceTwoOf(now)) {
        return {kHa, kVa, kSd};
    }
    if (meter_.averages()) {
        return {kHa, kVa, kHaFaceTwo, kVaFaceTwo, kHaFaceOne, kVaFaceOne, kSd};
    }
    return {kHa, kVa, kSd, kHaFaceTwo, kVaFaceTwo};
}

std::vector<std::string> Station::Impl::items(const std::vector<int>& labels, const Reading& now,
                                              ReadForm form) const {
    std::vector<std::string> lines;
    for (const int label : labels) {
        const auto text = labelText(label, now);
        std::ranges::move(item(label, text.value_or(""), form), std::back_inserter(lines));
    }
    return lines;
}

std::vector<std::string> Station::Impl::item(int label, const std::string& text, ReadForm form) const {
    switch (form) {
        case 'N': {
            const std::string prompt(protocol::findLabel(label)->prompt);
            return {(prompt.empty() ? std::to_string(label) : prompt) + '=' + text};
        }
        case 'D':
            return {text};
        case 'V':
            return {std::to_string(label), text};
        default:
            return {std::to_string(label) + '=' + text};
    }
}

Reading Station::Impl::takeReading() {
    const auto noise = [this] {
        const double sigma_gon = settings_.angle_sigma.gon();
        return Angle::fromGon(sigma_gon > 0.0 ? std::normal_distribution(0.0, sigma_gon)(random_) : 0.0);
    };
    Reading now{circleReading(settings_, pointing_->at(clock_.now()), compensated()), std::nullopt};
    now.shown.ha = core::normalized(now.shown.ha + noise() + orientation_);
    now.shown.va = core::normalized(now.shown.va + noise());
    if (meter_.hasDistance() && !targetMoved()) {
        const double prism_m =
            settings_.prism_constant_added ? labels_.number(protocol::kPrismConstant) : 0.0;
        now.sd_m = meter_.distance() * (1.0 + labels_.number(protocol::kPpm) * 1e-6) +
                   labels_.number(protocol::kOffset) + prism_m;
    }
    return now;
}

/// What the distance meter's light travels, in its own count: the air makes it longer or shorter than the
/// way.
std::optional<double> Station::Impl::lightWay() const {
    const auto echo = struckBy("no_signal") ? std::nullopt : scene_->echo(pointing_->at(clock_.now()));
    if (!echo || echo->distance_m > settings_.longest_range_m) {
        return std::nullopt;
    }
    const double true_ppm = makersPpm(settings_.air_pressure_mbar, settings_.air_temperature_degc);
    return echo->distance_m / (1.0 + true_ppm * 1e-6);
}

/// Up to 400 m the pointing may move 30 cm at the target, beyond that 50 mgon.
bool Station::Impl::targetMoved() const {
    constexpr double kMostAtTarget_m = 0.30;
    const Angle most = Angle::fromMgon(50.0);
    if (!settings_.target_test || !meter_.hasDistance()) {
        return false;
    }
    const Angle moved = geometry::separation(measured_at_, pointing_->at(clock_.now()));
    return moved.rad() * meter_.distance() > std::max(kMostAtTarget_m, most.rad() * meter_.distance());
}

/// The face II half of a two-face observation: it counts only while face I points at the same thing.
std::optional<Reading> Station::Impl::faceTwoOf(const Reading& now) const {
    const Angle most = Angle::fromMgon(500.0);
    const bool face_one = !geometry::isFaceTwo(now.shown);
    const bool same = face_two_ && face_one && geometry::separation(face_two_->shown, now.shown) < most;
    return same ? face_two_ : std::nullopt;
}

std::optional<std::string> Station::Impl::labelText(int label, const Reading& now) const {
    if (const auto angle = angleLabel(label, now)) {
        return angle;
    }
    const bool coordinate = label >= protocol::kNorthing && label <= protocol::kElevation;
    if (!coordinate || (shows_point_ && now.sd_m)) {
        if (const auto value = distanceLabel(label, now)) {
            return labels_.shown(*protocol::findLabel(label), *value);
        }
    }
    switch (label) {
        case kDate:
            return clock_.utcNow().addSecs(clock_offset_s_).toString(kDateFormat).toStdString();
        case kTime:
            return clock_.utcNow().addSecs(clock_offset_s_).toString(kTimeFormat).toStdString();
        default:
            break;
    }
    const auto access = protocol::findLabel(label)->access;
    const bool measured =
        access == protocol::LabelAccess::kMeasured || access == protocol::LabelAccess::kCalculated;
    return measured ? std::nullopt : labels_.text(label);
}

std::optional<std::string> Station::Impl::angleLabel(int label, const Reading& now) const {
    const auto two = faceTwoOf(now);
    const bool means = two && meter_.averages() && meter_.hasDistance();
    const AngleText unit = labels_.units().angle;
    const bool fine = meter_.mode() == EdmMode::kDBarHighResolution && meter_.hasDistance();
    const auto shown = [&](Angle angle, int extra = 0) {
        return angleText(angle, unit, settings_.angle_decimals + extra);
    };
    switch (label) {
        case protocol::kHa: {
            const Angle half =
                two ? core::normalizedSigned(geometry::otherFace(two->shown).ha - now.shown.ha) / 2.0
                    : Angle{};
            return shown(means ? now.shown.ha + half : now.shown.ha, fine ? 1 : 0);
        }
        case protocol::kVa:
            return shown(means ? (now.shown.va + geometry::otherFace(two->shown).va) / 2.0 : now.shown.va);
        case kHaFaceTwo:
            return two ? std::optional(shown(two->shown.ha)) : std::nullopt;
        case kVaFaceTwo:
            return two ? std::optional(shown(two->shown.va)) : std::nullopt;
        case kHaFaceOne:
            return two ? std::optional(shown(now.shown.ha)) : std::nullopt;
        case kVaFaceOne:
            return two ? std::optional(shown(now.shown.va)) : std::nullopt;
        case 77:
            return signedAngleText(
                core::normalizedSigned(Angle::fromGon(labels_.number(protocol::kTargetHa)) - now.shown.ha),
                unit, settings_.angle_decimals);
        default:
            return std::nullopt;
    }
}

/// Labels computed from the distance, protocol page 4.3.
std::optional<double> Station::Impl::distanceLabel(int label, const Reading& now) const {
    if (!now.sd_m) {
        return std::nullopt;
    }
    const auto of = [this](int number) { return labels_.number(number); };
    const double horizontal = *now.sd_m * std::abs(core::sin(now.shown.va)),
                 up = *now.sd_m * core::cos(now.shown.va);
    const double along = *now.sd_m * core::sin(now.shown.va);
    const double north = along * core::cos(now.shown.ha), east = along * core::sin(now.shown.ha);
    const double vd = up + of(3) - of(protocol::kTargetHeight);
    // clang-format off
    switch (label) {
        case protocol::kSd: return now.sd_m;
        case 10: return up;
        case 11: return horizontal;
        case 14: return horizontal > 0.0 ? 100.0 * up / horizontal : 0.0;
        case protocol::kNorthing: return of(protocol::kNorthing) + north;
        case protocol::kEasting: return of(protocol::kEasting) + east;
        case protocol::kElevation: return of(protocol::kElevation) + vd;
        case 40: return of(67) - of(protocol::kNorthing) - north;
        case 41: return of(68) - of(protocol::kEasting) - east;
        case 42: return of(69) - of(protocol::kElevation) - vd;
        case 46: return meter_.deviation();
        case 47: return north;
        case 48: return east;
        case 49: return vd;
        case 75: return of(29) - of(protocol::kElevation) - vd;
        case 76: return of(28) - horizontal;
        default: return std::nullopt;
    }
    // clang-format on
}

void Station::Impl::pressRegKey() {
    if (power_ != Power::kReady) {
        return;
    }
    emitBlock(measurementBlock('S', settings_.unsolicited_status, false));
    const Reading now = takeReading();
    std::vector<std::string> record{"5=" + labels_.raw(protocol::kPointNumber)};
    std::ranges::move(items(blockLabels(now.sd_m.has_value(), now), now, 'S'), std::back_inserter(record));
    files_.append('M', labels_.raw(protocol::kJobName), record);
    meter_.markRecorded();
}

}  // namespace pmts::simulator
