#include "control_row.hpp"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr int kTicks = 1000;
constexpr int kReach_px = 40;      ///< a gloved finger
constexpr double kWide = 50.0;     ///< a range of this ratio is handled by its logarithm
constexpr int kSlider_px = 72;     ///< the least way of a slider
enum Column { kName, kSlider, kNumber, kAuto };

bool isWide(const video::ControlRange& range) { return range.minimum > 0.0 && range.maximum / range.minimum > kWide; }

int decimalsOf(double step) { return step >= 1.0 ? 0 : step >= 0.1 ? 1 : 2; }

}  // namespace

ControlRow::ControlRow(app::CameraPresenter& camera, const app::ControlRow& row, QGridLayout& grid, int at, QWidget* parent)
    : QObject(parent), camera_(camera), range_(row.range), name_(new QLabel(row.name, parent)) {
    grid.addWidget(name_, at, kName);
    if (range_.has_auto) {
        automatic_ = new QCheckBox(tr("Auto"), parent);
        automatic_->setAccessibleName(tr("%1 automatic").arg(row.name));
        automatic_->setMinimumHeight(kReach_px);
        grid.addWidget(automatic_, at, kAuto);
        connect(automatic_, &QCheckBox::clicked, this,
                [this](bool on) { camera_.setAutomatic(range_.control, on); });
    }
    if (range_.has_value) {
        buildValue(row, grid, at, parent);
    }
    showRow(row);
}

void ControlRow::buildValue(const app::ControlRow& row, QGridLayout& grid, int at, QWidget* parent) {
    number_ = new QDoubleSpinBox(parent);
    number_->setRange(range_.minimum, range_.maximum);
    number_->setSingleStep(range_.step);
    number_->setDecimals(decimalsOf(range_.step));
    number_->setSuffix(row.unit.isEmpty() ? QString() : QStringLiteral(" ") + row.unit);
    number_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // too small for a finger; the slider is there
    number_->setKeyboardTracking(false);
    number_->setMinimumHeight(kReach_px);
    slider_ = new QSlider(Qt::Horizontal, parent);
    slider_->setRange(0, kTicks);
    slider_->setMinimumHeight(kReach_px);
    for (QWidget* const part : {static_cast<QWidget*>(number_), static_cast<QWidget*>(slider_)}) {
        part->setAccessibleName(row.name);
        part->setToolTip(row.limits);
    }
    slider_->setMinimumWidth(kSlider_px);
    grid.addWidget(slider_, at, kSlider);
    grid.addWidget(number_, at, kNumber);
    grid.setColumnStretch(kSlider, 1);
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) { camera_.setValue(range_.control, value); });
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) { camera_.setValue(range_.control, valueOf(tick)); });
}

int ControlRow::tickOf(double value) const {
    const double share = isWide(range_) ? std::log(std::max(value, range_.minimum) / range_.minimum) /
                                              std::log(range_.maximum / range_.minimum)
                                        : (value - range_.minimum) / std::max(range_.maximum - range_.minimum, 1e-9);
    return qRound(std::clamp(share, 0.0, 1.0) * kTicks);
}

double ControlRow::valueOf(int tick) const {
    const double share = static_cast<double>(tick) / kTicks;
    return isWide(range_) ? range_.minimum * std::pow(range_.maximum / range_.minimum, share)
                          : range_.minimum + share * (range_.maximum - range_.minimum);
}

void ControlRow::showRow(const app::ControlRow& row) {
    if (automatic_ != nullptr) {
        automatic_->setChecked(row.value.automatic);
    }
    if (number_ != nullptr) {
        const QSignalBlocker quiet_number(number_), quiet_slider(slider_);
        number_->setEnabled(!row.value.automatic);
        slider_->setEnabled(!row.value.automatic);
        if (!number_->hasFocus() || row.value.automatic || number_->value() != row.value.value) {
            number_->setValue(row.value.value);
        }
        if (!slider_->isSliderDown()) {
            slider_->setValue(tickOf(row.value.value));
        }
    }
    name_->setToolTip(row.limits);
}

}  // namespace pmts::gui
