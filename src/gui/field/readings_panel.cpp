#include "readings_panel.hpp"

#include "ui_readings_panel.h"

#include <QEvent>
#include <QFontInfo>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kUsualText_px = 13;
constexpr double kDigitsGrowth =
    1.3;  ///< pixels the digits grow for each pixel of the text: they are large already
const QString kNothing = QStringLiteral("\u2013");

void showValue(QLabel* label, const QString& text) { label->setText(text.isEmpty() ? kNothing : text); }

void markOld(QLabel* label, bool old, const QString& reason) {
    QFont font = label->font();
    if (font.italic() != old) {
        font.setItalic(old);
        label->setFont(font);
    }
    label->setToolTip(old ? reason : QString());
}

}  // namespace

app::StatusItem shotStatus(app::ShotState state) {
    using app::DeviceState;
    using app::ShotState;
    switch (state) {
        case ShotState::kNone:
            break;
        case ShotState::kMeasuring:
            return {DeviceState::kBusy, ReadingsPanel::tr("measuring"), {}};
        case ShotState::kMeasured:
            return {DeviceState::kGood, ReadingsPanel::tr("measured"), {}};
        case ShotState::kConverted:
            return {DeviceState::kGood, ReadingsPanel::tr("converted"), {}};
        case ShotState::kAbsurd:
            return {DeviceState::kWarning, ReadingsPanel::tr("absurd point"), {}};
        case ShotState::kRecording:
            return {DeviceState::kBusy, ReadingsPanel::tr("recording"), {}};
        case ShotState::kRecorded:
            return {DeviceState::kGood, ReadingsPanel::tr("recorded"), {}};
        case ShotState::kKept:
            return {DeviceState::kFailed, ReadingsPanel::tr("not recorded"), {}};
    }
    return {DeviceState::kIdle, ReadingsPanel::tr("no distance yet"), {}};
}

ReadingsPanel::ReadingsPanel(QWidget* parent) : QFrame(parent), ui_(std::make_unique<Ui::ReadingsPanel>()) {
    ui_->setupUi(this);
    sizeDigits();
    showReadings({});
}

ReadingsPanel::~ReadingsPanel() = default;

void ReadingsPanel::showReadings(const app::Readings& readings) {
    showValue(ui_->ha, readings.ha);
    showValue(ui_->va, readings.va);
    showValue(ui_->sd, readings.sd);
    showValue(ui_->easting, readings.easting);
    showValue(ui_->northing, readings.northing);
    showValue(ui_->height, readings.height);
    for (QLabel* unit : {ui_->ha_unit, ui_->va_unit}) {
        unit->setText(readings.angle_unit);
    }
    for (QLabel* unit : {ui_->sd_unit, ui_->easting_unit, ui_->northing_unit, ui_->height_unit}) {
        unit->setText(readings.length_unit);
    }
    ui_->mode->setText(readings.mode);
    ui_->time_taken->setText(readings.time_taken);
    ui_->precision->setText(readings.precision);
    ui_->sentence->setText(readings.sentence);
    showShot(readings);
}

void ReadingsPanel::showShot(const app::Readings& readings) {
    const app::StatusItem status = shotStatus(readings.shot);
    const bool old = readings.shot_is_elsewhere && !readings.sd.isEmpty();
    ui_->shot_lamp->setState(status.state);
    ui_->shot_text->setText(old ? tr("%1, turned since").arg(status.text) : status.text);
    for (QLabel* value : {ui_->sd, ui_->easting, ui_->northing, ui_->height}) {
        markOld(value, old, tr("The telescope has turned since this distance was measured."));
    }
}

void ReadingsPanel::setCirclesLive(bool live) {
    for (QLabel* value : {ui_->ha, ui_->va}) {
        markOld(value, !live, tr("The instrument does not answer: this is its last reading."));
    }
}

void ReadingsPanel::sizeDigits() {
    sizing_ = true;
    const int larger_px = std::max(0, QFontInfo(font()).pixelSize() - kUsualText_px);
    const int height_px = kLeastDigits_px + qRound(kDigitsGrowth * larger_px);
    for (QLabel* value : {ui_->ha, ui_->va, ui_->sd, ui_->easting, ui_->northing, ui_->height}) {
        value->setStyleSheet(QStringLiteral("font-size: %1px;").arg(height_px));
    }
    sizing_ = false;
}

void ReadingsPanel::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (!sizing_ && (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange)) {
        sizeDigits();
    }
}

}  // namespace pmts::gui
