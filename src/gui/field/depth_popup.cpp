#include "depth_popup.hpp"

#include "parts/action_button.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kSliderWidth_px = 300;
constexpr int kLeastSpan = 4;  ///< steps: near stays in front of far

}  // namespace

DepthPopup::DepthPopup(app::RangePresenter& ranges, QWidget* parent)
    : QFrame(parent, Qt::Popup), ranges_(ranges) {
    setObjectName(QStringLiteral("depth_popup"));
    setFrameShape(QFrame::StyledPanel);
    auto* const grid = new QGridLayout(this);
    grid->addWidget(new QLabel(tr("Points drawn over the pictures, by distance from the station"), this), 0,
                    0, 1, 3);
    near_ = addSlider(tr("Near"), 1);
    far_ = addSlider(tr("Far"), 2);
    near_text_ = new QLabel(this);
    far_text_ = new QLabel(this);
    near_text_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("from the instrument")) + 8);
    grid->addWidget(near_text_, 1, 2);
    grid->addWidget(far_text_, 2, 2);
    auto* const all = new QPushButton(tr("All points"), this);
    all->setMinimumHeight(ActionButton::kLeastSide_px);
    grid->addWidget(all, 3, 1, 1, 2);
    connect(all, &QPushButton::clicked, this,
            [this] { ranges_.setDepthSteps(0, app::RangePresenter::kDepthSteps); });
    connect(near_, &QSlider::valueChanged, this, [this] { slide(true); });
    connect(far_, &QSlider::valueChanged, this, [this] { slide(false); });
    connect(&ranges_, &app::RangePresenter::changed, this, &DepthPopup::showValues);
    showValues();
}

QSlider* DepthPopup::addSlider(const QString& name, int row) {
    auto* const label = new QLabel(name, this);
    auto* const slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(name.toLower());
    slider->setAccessibleName(name);
    slider->setRange(0, app::RangePresenter::kDepthSteps);
    slider->setPageStep(app::RangePresenter::kDepthSteps / 12);
    slider->setMinimumSize(kSliderWidth_px, ActionButton::kLeastSide_px);
    label->setBuddy(slider);
    auto* const grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(label, row, 0);
    grid->addWidget(slider, row, 1);
    return slider;
}

void DepthPopup::slide(bool near_moved) {
    int near_step = near_->value();
    int far_step = far_->value();
    if (near_moved) {
        near_step = std::min(near_step, app::RangePresenter::kDepthSteps - kLeastSpan);
        far_step = std::max(far_step, near_step + kLeastSpan);
    } else {
        far_step = std::max(far_step, kLeastSpan);
        near_step = std::min(near_step, far_step - kLeastSpan);
    }
    ranges_.setDepthSteps(near_step, far_step);
}

void DepthPopup::showValues() {
    const QSignalBlocker near_quiet(near_), far_quiet(far_);
    near_->setValue(ranges_.nearStep());
    far_->setValue(ranges_.farStep());
    near_text_->setText(ranges_.nearText());
    far_text_->setText(ranges_.farText());
}

void DepthPopup::openAbove(const QWidget& button) {
    adjustSize();
    const QRect room = button.screen()->availableGeometry();
    QPoint at = button.mapToGlobal(QPoint(button.width() - width(), -height() - 4));
    at.setX(std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - width())));
    at.setY(std::max(at.y(), room.top()));
    move(at);
    show();
}

}  // namespace pmts::gui
