#include "filter_popup.hpp"

#include "parts/lab_parts.hpp"

#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QScreen>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr int kWhole = 100;      ///< steps of a strength
constexpr int kMostGain = 400;   ///< 4 times
constexpr int kSlider_px = 260;

}  // namespace

FilterPopup::FilterPopup(app::LivePresenter& live, app::StillFilters& filters, QWidget* parent)
    : QFrame(parent, Qt::Popup), live_(live), filters_(filters) {
    setObjectName(QStringLiteral("filter_popup"));
    setFrameShape(QFrame::StyledPanel);
    auto* const grid = new QGridLayout(this);
    said_ = labText("filter_said", this);
    grid->addWidget(said_, 0, 0, 1, 2);
    smooth_ = addSlider(*grid, tr("Smooth"), "filter_smooth", kWhole);
    smooth_->setToolTip(tr("Balances the contrast: shadows and sun"));
    sharp_ = addSlider(*grid, tr("Sharp"), "filter_sharp", kWhole);
    edges_ = addSlider(*grid, tr("Edges"), "filter_edges", kWhole);
    red_ = addSlider(*grid, tr("Red"), "filter_red", kMostGain);
    green_ = addSlider(*grid, tr("Green"), "filter_green", kMostGain);
    blue_ = addSlider(*grid, tr("Blue"), "filter_blue", kMostGain);
    bands_ = new QComboBox(this);
    bands_->setObjectName(QStringLiteral("filter_bands"));
    bands_->setAccessibleName(tr("Bands"));
    bands_->addItems({tr("All bands"), tr("Red alone"), tr("Green alone"), tr("Blue alone")});
    bands_->setMinimumHeight(ActionButton::kLeastSide_px);
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(tr("Bands"), this), row, 0);
    grid->addWidget(bands_, row, 1);
    none_ = labButton(tr("No filter"), "filter_none", this);
    save_ = labButton(tr("Save picture…"), "filter_save", this);
    grid->addWidget(none_, row + 1, 0);
    grid->addWidget(save_, row + 1, 1);
    connect(bands_, &QComboBox::activated, this, &FilterPopup::take);
    connect(none_, &QPushButton::clicked, this, [this] { filters_.set(stillNumber(), {}); });
    connect(save_, &QPushButton::clicked, this, &FilterPopup::save);
    connect(&filters_, &app::StillFilters::changed, this, &FilterPopup::showFilter);
    connect(&live_, &app::LivePresenter::stillCaptured, this, &FilterPopup::showFilter);
    showFilter();
}

QSlider* FilterPopup::addSlider(QGridLayout& grid, const QString& name, const char* object_name, int most) {
    auto* const label = new QLabel(name, this);
    auto* const slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(QLatin1String(object_name));
    slider->setAccessibleName(name);
    slider->setRange(0, most);
    slider->setPageStep(most / 10);
    slider->setMinimumSize(kSlider_px, ActionButton::kLeastSide_px);
    label->setBuddy(slider);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(slider, row, 1);
    connect(slider, &QSlider::valueChanged, this, &FilterPopup::take);
    return slider;
}

int FilterPopup::stillNumber() const { return live_.still() ? live_.still()->number : 0; }

void FilterPopup::take() {
    const auto share = [](const QSlider* slider) { return slider->value() / static_cast<double>(kWhole); };
    camera::ImageFilter filter;
    filter.smooth = share(smooth_);
    filter.sharp = share(sharp_);
    filter.edges = share(edges_);
    filter.red = share(red_);
    filter.green = share(green_);
    filter.blue = share(blue_);
    filter.single_band = bands_->currentIndex() > 0;
    filter.band = std::max(0, bands_->currentIndex() - 1);
    filters_.set(stillNumber(), filter);
}

void FilterPopup::showFilter() {
    const camera::ImageFilter filter = filters_.of(stillNumber());
    const auto put = [](QSlider* slider, double value) {
        const QSignalBlocker quiet(slider);
        slider->setValue(static_cast<int>(std::lround(value * kWhole)));
    };
    put(smooth_, filter.smooth);
    put(sharp_, filter.sharp);
    put(edges_, filter.edges);
    put(red_, filter.red);
    put(green_, filter.green);
    put(blue_, filter.blue);
    bands_->setCurrentIndex(filter.single_band ? filter.band + 1 : 0);
    said_->setText(live_.still() ? tr("Still %1 for the eye; its pixels stay as they are.").arg(stillNumber())
                                 : tr("Take a still first: capture (C)."));
    for (QWidget* part : std::initializer_list<QWidget*>{smooth_, sharp_, edges_, red_, green_, blue_, bands_, none_, save_}) {
        part->setEnabled(live_.still().has_value());
    }
}

void FilterPopup::openAt(const QPoint& global) {
    adjustSize();
    const QRect room = screen()->availableGeometry();
    move(std::clamp(global.x(), room.left(), std::max(room.left(), room.right() - width())),
         std::clamp(global.y() - height(), room.top(), std::max(room.top(), room.bottom() - height())));
    show();
}

void FilterPopup::save() {
    if (!live_.still()) {
        return;
    }
    const QString path = QFileDialog::getSaveFileName(parentWidget(), tr("Save picture"), QStringLiteral("still-%1.png").arg(stillNumber()), tr("Pictures (*.png *.jpg)"));
    if (!path.isEmpty()) {
        const auto written = filters_.write(stillNumber(), live_.still()->frame, path);
        said_->setText(written ? tr("The picture is written.") : written.error().sentence());
    }
}

}  // namespace pmts::gui
