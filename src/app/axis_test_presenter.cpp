#include "pmts/app/axis_test_presenter.hpp"

#include "pmts/geometry/polar.hpp"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace pmts::app {
namespace {

using core::Angle;

const QString kTopic = QStringLiteral("axis_test");
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

QString expiry(const InstrumentCareSettings& care, const AxisTestRecord& test,
               const std::optional<double>& temperature_degc, const QDateTime& utc_now) {
    constexpr qint64 kDay_s = 86400;
    if (test.utc.secsTo(utc_now) < -kDay_s) {
        return AxisTestPresenter::tr("Its date lies in the future: the clock of this computer was set, its age is not known.");
    }
    const qint64 days = test.utc.daysTo(utc_now);
    if (days > care.expires_days) {
        return AxisTestPresenter::tr("It is %1 days old.").arg(days);
    }
    if (test.temperature_degc && temperature_degc &&
        std::abs(*temperature_degc - *test.temperature_degc) > care.expires_degc) {
        return AxisTestPresenter::tr("It was made at %1 °C, now it is %2 °C.")
            .arg(*test.temperature_degc, 0, 'f', 0)
            .arg(*temperature_degc, 0, 'f', 0);
    }
    return {};
}

bool isBeyond(const InstrumentCareSettings& care, const geometry::AxisErrors& errors) {
    return core::abs(errors.collimation.value) > care.axis_limit || core::abs(errors.index.value) > care.axis_limit;
}

}  // namespace

QString axisErrorText(const geometry::AxisError& error) {
    const QString value = QStringLiteral("%1 mgon (%2\")").arg(mgon(error.value)).arg(error.value.arcsec(), 0, 'f', 1);
    return error.sigma ? QStringLiteral("%1 ± %2 mgon").arg(value, mgon(*error.sigma)) : value;
}

StatusItem axisTestState(const InstrumentCareSettings& care, const QString& serial_number,
                         const std::optional<double>& temperature_degc, const QDateTime& utc_now) {
    const AxisTestRecord* const test = care.testOf(serial_number);
    if (test == nullptr) {
        return {DeviceState::kIdle, AxisTestPresenter::tr("No test of this instrument is kept."),
                AxisTestPresenter::tr("Without one, measure in both faces where it must be accurate.")};
    }
    const QString temperature =
        test->temperature_degc ? QStringLiteral(", %1 °C").arg(*test->temperature_degc, 0, 'f', 0) : QString();
    const QString text = AxisTestPresenter::tr("Collimation %1, index %2; %3%4")
                             .arg(axisErrorText(test->errors.collimation), axisErrorText(test->errors.index),
                                  QLocale().toString(test->utc.toLocalTime(), QLocale::ShortFormat), temperature);
    if (const QString old = expiry(care, *test, temperature_degc, utc_now); !old.isEmpty()) {
        return {DeviceState::kWarning, text, old + u' ' + AxisTestPresenter::tr("Repeat the test.")};
    }
    if (isBeyond(care, test->errors)) {
        return {DeviceState::kWarning, text,
                AxisTestPresenter::tr("More than %1 mgon: have the instrument adjusted, or measure in both faces.")
                    .arg(care.axis_limit.mgon())};
    }
    return {DeviceState::kGood, text,
            AxisTestPresenter::tr("PMTS corrects no reading by it; the mean of both faces is free of it.")};
}

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
    connect(&instrument_, &InstrumentDesk::identityChanged, this, [this] {
        reminded_ = false;
        follow();
    });
    connect(&health_, &InstrumentHealth::changed, this, &AxisTestPresenter::follow);
    connect(&preferences_, &Preferences::changed, this, &AxisTestPresenter::changed);
}

/// Once for each instrument that is connected: its test has expired, or the instrument wants to be adjusted.
void AxisTestPresenter::follow() {
    const StatusItem test = kept();
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
        instrument_.stop();
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
    pairs_.clear();
    half_.reset();
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
        rows.push_back({QString::number(rows.size() + 1), units.angleNumber(pair.face_one.ha),
                        units.angleNumber(pair.face_one.va), units.angleNumber(pair.face_two.ha),
                        units.angleNumber(pair.face_two.va), alone ? mgon(alone->collimation.value) : QString(),
                        alone ? mgon(alone->index.value) : QString()});
    }
    if (half_) {
        const QString ha = units.angleNumber(half_->ha), va = units.angleNumber(half_->va);
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
    if (isBeyond(care(), *errors)) {
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
    return axisTestState(care(), serialNumber(), health_.temperatureDegc(),
                         clock_.utcNow());
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
    next.instrument_care.keep({.serial_number = serialNumber(),
                               .utc = clock_.utcNow(),
                               .temperature_degc = health_.temperatureDegc(),
                               .errors = *errors});
    preferences_.set(next);
    pairs_.clear();
    messages_.solve(kTopic);
    messages_.toast(tr("The test is kept: collimation %1, index %2.")
                        .arg(axisErrorText(errors->collimation), axisErrorText(errors->index)));
    Q_EMIT changed();
}

}  // namespace pmts::app
