#include "pmts/app/line/axis_test_presenter.hpp"

#include "axis_test_state.hpp"
#include "pmts/geometry/polar.hpp"

#include <QLocale>

#include <algorithm>

namespace pmts::app {
namespace {

using core::Angle;

const QString kTopic = QStringLiteral("axis_test");
const QString kDroppedTopic = QStringLiteral("axis_test_dropped");
constexpr Angle kStill = Angle::fromMgon(3);        ///< spread of readings of one pointing
constexpr Angle kSameTarget = Angle::fromGon(0.5);  ///< both faces of one target differ by less
constexpr Angle kLevelTarget = Angle::fromGon(10);  ///< from the horizon: there the tilting axis says nothing
constexpr Angle kServoTolerance = Angle::fromCc(10);
constexpr int kEnoughPairs = 3;

QString mgon(Angle angle) { return QString::number(angle.mgon(), 'f', 2); }

/// Mean beside the first reading, so that the zero of the circle does no harm.
Angle meanOf(const std::vector<geometry::Pointing>& readings, Angle geometry::Pointing::*circle) {
    Angle sum;
    for (const auto& reading : readings) {
        sum += core::normalizedSigned(reading.*circle - readings.front().*circle);
    }
    return readings.front().*circle + sum / static_cast<double>(readings.size());
}

bool isStill(const std::vector<geometry::Pointing>& readings) {
    return std::ranges::all_of(readings, [&](const geometry::Pointing& reading) {
        return core::abs(core::normalizedSigned(reading.ha - readings.front().ha)) <= kStill &&
               core::abs(core::normalizedSigned(reading.va - readings.front().va)) <= kStill;
    });
}

/// With a point or the comma of the language.
std::optional<double> degcIn(const QString& text) {
    constexpr double kColdest = -60, kWarmest = 80;
    bool ok = false;
    double degc = text.toDouble(&ok);
    degc = ok ? degc : QLocale().toDouble(text, &ok);
    return ok && degc >= kColdest && degc <= kWarmest ? std::optional(degc) : std::nullopt;
}

}  // namespace

AxisTestPresenter::AxisTestPresenter(InstrumentDesk& instrument, InstrumentHealth& health, Preferences& preferences,
                                     MessageCentre& messages, const core::Clock& clock, QObject* parent)
    : QObject(parent),
      instrument_(instrument),
      health_(health),
      preferences_(preferences),
      messages_(messages),
      clock_(clock) {
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &AxisTestPresenter::addReading);
    connect(&instrument_, &InstrumentDesk::turned, this, [this](Ticket ticket) {
        if (ticket == turn_ticket_ && ticket != 0) {
            turn_ticket_ = 0;
            Q_EMIT changed();
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &AxisTestPresenter::onFailed);
    connect(&instrument_, &InstrumentDesk::identityChanged, this, &AxisTestPresenter::onIdentity);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &AxisTestPresenter::onConnection);
    connect(&health_, &InstrumentHealth::changed, this, &AxisTestPresenter::follow);
    connect(&preferences_, &Preferences::changed, this, &AxisTestPresenter::changed);
}

void AxisTestPresenter::onConnection(ConnectionState state) {
    if (state != ConnectionState::kConnected) {
        wants_reading_ = false;
        readings_.clear();
        Q_EMIT changed();
    }
}

/// Axis errors belong to one instrument: pointings of two never go into one test.
void AxisTestPresenter::onIdentity() {
    reminded_ = false;
    if (of_serial_ && *of_serial_ != serialNumber()) {
        const QString before = *of_serial_;
        dropPointings();
        messages_.warn(tr("Another instrument is connected: the pointings of %1 are dropped.").arg(before),
                       tr("Begin the test anew with this one."), MessageAction::kNone, kDroppedTopic);
    }
    follow();
}

void AxisTestPresenter::dropPointings() {
    of_serial_.reset();
    measured_degc_.reset();
    typed_temperature_.clear();
    pairs_.clear();
    half_.reset();
    readings_.clear();
    wants_reading_ = false;
}

/// Once for each instrument that is connected: its test has expired, or the instrument wants to be adjusted.
void AxisTestPresenter::follow() {
    const StatusItem test = kept();
    if (of_serial_ && health_.temperatureDegc()) {
        measured_degc_ = health_.temperatureDegc();
    }
    if (!reminded_ && test.state == DeviceState::kWarning) {
        reminded_ = true;
        messages_.warn(tr("The axis test of this instrument: %1").arg(test.text), test.details, MessageAction::kNone, kTopic);
    }
    Q_EMIT changed();
}

QString AxisTestPresenter::serialNumber() const {
    return instrument_.identity() ? instrument_.identity()->serial_number : QString();
}

void AxisTestPresenter::say(const QString& happened, const QString& remedy) {
    messages_.warn(happened, remedy, MessageAction::kNone, kTopic);
    Q_EMIT changed();
}

// Pointings
// --------------------------------------------------------------------------------------------------------------

void AxisTestPresenter::take() {
    messages_.solve(kTopic);
    messages_.solve(kDroppedTopic);
    if (!health_.isConnected()) {
        return say(tr("The instrument is not connected, so its circles cannot be read."), tr("Connect it first."));
    }
    readings_.clear();
    wants_reading_ = true;
    Q_EMIT changed();
}

void AxisTestPresenter::addReading(const TimedPointing& reading) {
    if (!wants_reading_ || instrument_.isTurning()) {
        return;
    }
    readings_.push_back(reading.pointing);
    if (readings_.size() == kReadings) {
        finishPointing();
    }
}

void AxisTestPresenter::finishPointing() {
    const auto readings = std::exchange(readings_, {});
    wants_reading_ = false;
    if (!isStill(readings)) {
        return say(tr("The instrument moved while its circles were read."),
                   tr("Aim again, let go, then take the pointing."));
    }
    addPointing({.ha = core::normalized(meanOf(readings, &geometry::Pointing::ha)),
                 .va = core::normalized(meanOf(readings, &geometry::Pointing::va))});
}

void AxisTestPresenter::addPointing(const geometry::Pointing& pointing) {
    if (!of_serial_) {
        of_serial_ = serialNumber();
        measured_degc_ = health_.temperatureDegc();
    }
    if (!half_) {
        half_ = pointing;
        Q_EMIT changed();
        return;
    }
    const bool second_is_two = geometry::isFaceTwo(pointing);
    if (second_is_two == geometry::isFaceTwo(*half_)) {
        return say(tr("This face is taken already."),
                   tr("Turn to the other face, aim at the same target, then take it."));
    }
    const geometry::FacePair pair =
        second_is_two ? geometry::FacePair{*half_, pointing} : geometry::FacePair{pointing, *half_};
    if (geometry::separation(pair.face_one, pair.face_two) > kSameTarget) {
        return say(tr("That is another target: both faces differ by more than 0.5 gon."),
                   tr("Aim at the target of the other face."));
    }
    pairs_.push_back(pair);
    half_.reset();
    Q_EMIT changed();
}

void AxisTestPresenter::turnToOther() {
    const auto now = instrument_.track().newest();
    if (!now || isTurning()) {
        return;
    }
    messages_.solve(kTopic);
    turn_ticket_ = instrument_.turnTo(geometry::otherFace(now->pointing), kServoTolerance);
    Q_EMIT changed();
}

void AxisTestPresenter::cancel() {
    wants_reading_ = false;
    readings_.clear();
    if (isTurning()) {
        instrument_.cancel(turn_ticket_);
    }
    Q_EMIT changed();
}

void AxisTestPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != turn_ticket_ || ticket == 0) {
        return;
    }
    turn_ticket_ = 0;
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kTopic);
    }
    Q_EMIT changed();
}

void AxisTestPresenter::discard() {
    dropPointings();
    cancel();
}

// Result
// -----------------------------------------------------------------------------------------------------------------

QString AxisTestPresenter::instruction() const {
    if (isTurning()) {
        return tr("Turning to the other face.");
    }
    if (isReading()) {
        return tr("Reading the circles: do not touch the instrument.");
    }
    if (half_) {
        return geometry::isFaceTwo(*half_) ? tr("Turn to face I, aim at the same target again, take the pointing.")
                                           : tr("Turn to face II, aim at the same target again, take the pointing.");
    }
    if (pairs_.empty()) {
        return tr("Aim at a sharp target near the horizon, 50 m away or more, and take the pointing.");
    }
    return pairs_.size() < kEnoughPairs
               ? tr("Aim anew at the target in this face and take the pointing: three pairs or more tell how sure it is.")
               : tr("Accept the result, or take more pairs. A second, steep target shows the tilting axis too.");
}

QStringList AxisTestPresenter::headers() const {
    return {tr("Pair"), tr("HA I"), tr("VA I"), tr("HA II"), tr("VA II"), tr("c mgon"), tr("i mgon")};
}

std::vector<QStringList> AxisTestPresenter::rows() const {
    const UnitFormat& units = preferences_.units();
    std::vector<QStringList> rows;
    for (const auto& pair : pairs_) {
        const auto alone = geometry::axisErrorsFrom({pair});
        rows.push_back({QString::number(rows.size() + 1), units.directionNumber(pair.face_one.ha),
                        units.angleNumber(pair.face_one.va), units.directionNumber(pair.face_two.ha),
                        units.angleNumber(pair.face_two.va), alone ? mgon(alone->collimation.value) : QString(),
                        alone ? mgon(alone->index.value) : QString()});
    }
    if (half_) {
        const QString ha = units.directionNumber(half_->ha), va = units.angleNumber(half_->va);
        const QString number = QString::number(rows.size() + 1);
        rows.push_back(geometry::isFaceTwo(*half_) ? QStringList{number, {}, {}, ha, va, {}, {}}
                                                   : QStringList{number, ha, va, {}, {}, {}, {}});
    }
    return rows;
}

std::optional<geometry::AxisErrors> AxisTestPresenter::result() const {
    const auto errors = geometry::axisErrorsFrom(pairs_);
    return errors ? std::optional(*errors) : std::nullopt;
}

StatusItem AxisTestPresenter::resultState() const {
    const auto errors = result();
    if (!errors) {
        return {DeviceState::kIdle, tr("No pair yet."), {}};
    }
    QString text =
        tr("Collimation c = %1\nIndex i = %2").arg(axisErrorText(errors->collimation), axisErrorText(errors->index));
    if (errors->tilting) {
        text += u'\n' + tr("Tilting axis k = %1").arg(axisErrorText(*errors->tilting));
    }
    const bool steep = std::ranges::any_of(pairs_, [](const geometry::FacePair& pair) {
        return core::abs(geometry::meanOfFaces(pair).va - Angle::fromGon(100)) > kLevelTarget;
    });
    if (isBeyondLimit(care(), *errors)) {
        return {DeviceState::kWarning, text,
                tr("Beyond the limit of %1 mgon: have the instrument adjusted.")
                    .arg(care().axis_limit.mgon())};
    }
    if (steep && !errors->tilting) {
        return {DeviceState::kWarning, text,
                tr("The target is steep: an error of the tilting axis would look like collimation. Use one near the "
                   "horizon.")};
    }
    return {DeviceState::kGood, text,
            tr("Within the limit of %1 mgon.").arg(care().axis_limit.mgon())};
}

StatusItem AxisTestPresenter::kept() const {
    const InstrumentCareSettings none;
    return axisTestState(instrument_.identity() ? care() : none, serialNumber(), health_.temperatureDegc(),
                         clock_.utcNow());
}

std::optional<double> AxisTestPresenter::temperatureDegc() const {
    if (!typed_temperature_.isEmpty()) {
        return degcIn(typed_temperature_);
    }
    return health_.temperatureDegc() ? health_.temperatureDegc() : measured_degc_;
}

QString AxisTestPresenter::temperatureText() const {
    const auto degc = temperatureDegc();
    if (!degc) {
        return tr("The temperature is not known: type it, or the test is kept without one and expires by its age alone.");
    }
    const QString text = tr("%1 °C is noted with the test").arg(*degc, 0, 'f', 1);
    return typed_temperature_.isEmpty() ? tr("%1, as the instrument says (label 56).").arg(text)
                                        : tr("%1, as you typed it.").arg(text);
}

void AxisTestPresenter::typeTemperature(const QString& text) {
    messages_.solve(kTopic);
    const QString typed = text.trimmed();
    if (!typed.isEmpty() && !degcIn(typed)) {
        return say(tr("“%1” is no temperature in degrees Celsius.").arg(typed), tr("Type one from -60 to 80."));
    }
    typed_temperature_ = typed;
    Q_EMIT changed();
}

void AxisTestPresenter::setCare(const InstrumentCareSettings& care) {
    Settings next = preferences_.settings();
    next.instrument_care = care;
    preferences_.set(next);
}

void AxisTestPresenter::accept() {
    const auto errors = result();
    if (!errors || !canAccept()) {
        return;
    }
    Settings next = preferences_.settings();
    const auto degc = temperatureDegc();
    next.instrument_care.keep({.serial_number = *of_serial_,
                               .utc = clock_.utcNow(),
                               .temperature_degc = degc,
                               .errors = *errors});
    dropPointings();
    preferences_.set(next);
    messages_.solve(kTopic);
    messages_.toast(tr("The test is kept: collimation %1, index %2, %3.")
                        .arg(axisErrorText(errors->collimation), axisErrorText(errors->index), degcText(degc)));
    Q_EMIT changed();
}

}  // namespace pmts::app
