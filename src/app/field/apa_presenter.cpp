#include "pmts/app/field/apa_presenter.hpp"

#include <cmath>

namespace pmts::app {

namespace {

using targeting::SightedPixel;

QString pixelAngleText(core::Angle angle, const UnitFormat& units) {
    return core::angleText(angle, units.angle_unit, core::usualDecimals(units.angle_unit) + 1);
}

SightedPixel sighted(const QPointF& px, const geometry::Pointing& reading) { return {{px.x(), px.y()}, reading}; }

core::Result<core::Angle> perPixel(bool horizontal, const SightedPixel& first, const SightedPixel& second) {
    return horizontal ? targeting::pixelAngleAcross(first, second) : targeting::pixelAngleDown(first, second);
}

bool isHorizontal(Extreme which) { return which == Extreme::kLeft || which == Extreme::kRight; }

}  // namespace

ApaPresenter::ApaPresenter(LivePresenter& live, const InstrumentDesk& instrument, Preferences& preferences,
                           MessageCentre& messages, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), preferences_(preferences), messages_(messages) {
    connect(&live_, &LivePresenter::stillCaptured, this, &ApaPresenter::onStill);
    connect(&live_, &LivePresenter::captureWaiting, this, [this](const QString& reason) {
        if (capturing_ && !reason.isEmpty()) {
            Q_EMIT said(reason);
        }
    });
    connect(&preferences_, &Preferences::changed, this, &ApaPresenter::compute);
}

void ApaPresenter::capture() {
    capturing_ = true;
    live_.capture();
}

void ApaPresenter::onStill(const Still& still) {
    if (!capturing_) {
        return;  // somebody else's
    }
    capturing_ = false;
    still_ = still;
    sights_ = {};
    current_ = Extreme::kLeft;
    compute();
    Q_EMIT said(step());
}

QString ApaPresenter::stillText() const {
    return still_ ? tr("HA %1   VA %2").arg(preferences_.units().direction(still_->pointing.ha),
                                            preferences_.units().angle(still_->pointing.va))
                  : QString();
}

ApaObject ApaPresenter::object(Extreme which) const {
    static const char* const kNames[] = {QT_TR_NOOP("Left"), QT_TR_NOOP("Right"), QT_TR_NOOP("Upper"), QT_TR_NOOP("Lower")};
    const Sight& known = sight(which);
    ApaObject object{.name = tr(kNames[static_cast<int>(which)]), .px = known.px, .reading = known.reading, .px_text = {},
                     .reading_text = {}};
    if (known.px) {
        object.px_text = isHorizontal(which) ? tr("column %1").arg(known.px->x(), 0, 'f', 1)
                                             : tr("row %1").arg(known.px->y(), 0, 'f', 1);
    }
    if (known.reading) {
        const UnitFormat& units = preferences_.units();
        object.reading_text = isHorizontal(which) ? tr("HA %1").arg(units.direction(known.reading->ha))
                                                  : tr("VA %1").arg(units.angle(known.reading->va));
    }
    return object;
}

QString ApaPresenter::step() const {
    if (!still_) {
        return tr("Take a still that shows an object near each of its four edges.");
    }
    const ApaObject now = object(current_);
    if (!now.px) {
        return tr("Click the %1 object in the still.").arg(now.name.toLower());
    }
    if (!now.reading) {
        return tr("Point the telescope at the %1 object and take the reading.").arg(now.name.toLower());
    }
    return measured_ ? tr("All four objects are measured. Store keeps the result with the rig.")
                     : tr("Choose an object that is not measured yet.");
}

void ApaPresenter::choose(Extreme which) {
    current_ = which;
    Q_EMIT changed();
    Q_EMIT said(step());
}

void ApaPresenter::click(const QPointF& still_px) {
    if (!still_) {
        Q_EMIT refused(step());
        return;
    }
    sight(current_).px = still_px;
    goOn();
}

void ApaPresenter::takeReading() {
    const auto newest = instrument_.track().newest();
    if (instrument_.connectionState() != ConnectionState::kConnected || !newest) {
        Q_EMIT refused(tr("There is no circle reading: the instrument is not connected."));
        return;
    }
    const auto tracked = instrument_.track().at(newest->at);
    if (instrument_.isTurning() || (tracked && (tracked->moving || !tracked->settled))) {
        Q_EMIT refused(tr("The telescope moves. Wait until it stands still, then take the reading."));
        return;
    }
    if (!still_) {
        Q_EMIT refused(step());
        return;
    }
    sight(current_).reading = newest->pointing;
    goOn();
}

/// To the next object that is not measured, when the current one is.
void ApaPresenter::goOn() {
    const auto is_open = [this](Extreme which) { return !sight(which).px || !sight(which).reading; };
    for (int i = 0; i < kExtremes && !is_open(current_); ++i) {
        current_ = static_cast<Extreme>((static_cast<int>(current_) + 1) % kExtremes);
    }
    compute();
    Q_EMIT said(step());
}

void ApaPresenter::compute() {
    across_ = {};
    down_ = {};
    const auto horizontal = measure(true, across_);
    const auto vertical = measure(false, down_);
    measured_.reset();
    if (horizontal && vertical) {
        measured_ = targeting::AveragePixelAngle{*horizontal, *vertical};
    }
    Q_EMIT changed();
}

std::optional<core::Angle> ApaPresenter::measure(bool horizontal, ApaResult& result) const {
    const Sight& first = sight(horizontal ? Extreme::kLeft : Extreme::kUpper);
    const Sight& second = sight(horizontal ? Extreme::kRight : Extreme::kLower);
    const UnitFormat& units = preferences_.units();
    if (first.px && second.px) {
        const QPointF between = *second.px - *first.px;
        result.pixels = tr("%1 px").arg(horizontal ? between.x() : between.y(), 0, 'f', 1);
    }
    if (first.reading && second.reading) {
        result.angle = units.angle(horizontal ? core::normalizedSigned(second.reading->ha - first.reading->ha)
                                              : second.reading->va - first.reading->va);
    }
    if (result.pixels.isEmpty() || result.angle.isEmpty()) {
        return std::nullopt;
    }
    const auto angle = perPixel(horizontal, sighted(*first.px, *first.reading), sighted(*second.px, *second.reading));
    if (!angle || *angle == core::Angle()) {
        result.state = DeviceState::kFailed;
        result.judgement = angle ? tr("Both readings are the same.") : angle.error().sentence();
        return std::nullopt;
    }
    result.per_pixel = pixelAngleText(*angle, units);
    judge(horizontal, *angle, result);
    return *angle;
}

void ApaPresenter::judge(bool horizontal, core::Angle per_pixel, ApaResult& result) const {
    const QPointF first_px = *sight(horizontal ? Extreme::kLeft : Extreme::kUpper).px;
    const QPointF second_px = *sight(horizontal ? Extreme::kRight : Extreme::kLower).px;
    const double range_m = live_.scene().range.slope_distance_m;
    const auto by_rig = [&](const QPointF& px) {
        return live_.model().pointingForPixel({px.x(), px.y()}, still_->pointing, range_m);
    };
    const auto first = by_rig(first_px);
    const auto second = by_rig(second_px);
    const auto expected = first && second ? perPixel(horizontal, sighted(first_px, *first), sighted(second_px, *second))
                                          : core::Result<core::Angle>(core::fail(core::ErrorKind::kUndefined, {}));
    if (!expected || *expected == core::Angle()) {
        result.judgement = tr("The rig in use does not tell what to expect.");
        return;
    }
    const double off = per_pixel / *expected - 1.0;
    result.expected = pixelAngleText(*expected, preferences_.units());
    const QString how = off < 0 ? tr("%1 % less than the rig says") : tr("%1 % more than the rig says");
    result.judgement = how.arg(std::abs(off) * 100.0, 0, 'f', 1);
    result.state = std::abs(off) > kPlausible ? DeviceState::kWarning : DeviceState::kGood;
    if (result.state == DeviceState::kWarning) {
        result.judgement += tr(": check both objects, and the rig profile in use.");
    }
}

QString ApaPresenter::storedText() const {
    const RigProfile profile = preferences_.settings().chosenRig();
    if (!profile.average_pixel_angle) {
        return tr("%1 has no average pixel angle yet.").arg(profile.name);
    }
    const UnitFormat& units = preferences_.units();
    return tr("%1 has %2 across, %3 down.").arg(profile.name, pixelAngleText(profile.average_pixel_angle->horizontal, units),
                                                pixelAngleText(profile.average_pixel_angle->vertical, units));
}

void ApaPresenter::store() {
    if (!measured_) {
        Q_EMIT refused(step());
        return;
    }
    preferences_.setAveragePixelAngle(*measured_);
    messages_.toast(tr("The average pixel angle is kept."));
    Q_EMIT said(storedText());
    Q_EMIT stored();
}

}  // namespace pmts::app
