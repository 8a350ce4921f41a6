#include "axis_test_state.hpp"

#include <QLocale>

#include <cmath>

namespace pmts::app {
namespace {

QString mgon(core::Angle angle) { return QString::number(angle.mgon(), 'f', 2); }

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

}  // namespace

bool isBeyondLimit(const InstrumentCareSettings& care, const geometry::AxisErrors& errors) {
    return core::abs(errors.collimation.value) > care.axis_limit || core::abs(errors.index.value) > care.axis_limit;
}

QString degcText(const std::optional<double>& degc) {
    return degc ? AxisTestPresenter::tr("%1 °C").arg(*degc, 0, 'f', 0) : AxisTestPresenter::tr("temperature not known");
}

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
    const QString text =
        AxisTestPresenter::tr("Collimation %1, index %2; %3, %4")
            .arg(axisErrorText(test->errors.collimation), axisErrorText(test->errors.index),
                 QLocale().toString(test->utc.toLocalTime(), QLocale::ShortFormat), degcText(test->temperature_degc));
    if (const QString old = expiry(care, *test, temperature_degc, utc_now); !old.isEmpty()) {
        return {DeviceState::kWarning, text, old + u' ' + AxisTestPresenter::tr("Repeat the test.")};
    }
    if (isBeyondLimit(care, test->errors)) {
        return {DeviceState::kWarning, text,
                AxisTestPresenter::tr("More than %1 mgon: have the instrument adjusted, or measure in both faces.")
                    .arg(care.axis_limit.mgon())};
    }
    return {DeviceState::kGood, text,
            AxisTestPresenter::tr("PMTS corrects no reading by it; the mean of both faces is free of it.")};
}

}  // namespace pmts::app
