#include "camera_step.hpp"

#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"
#include "ui_camera_step.h"

#include <QGridLayout>
#include <QPainter>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr double kBoxShare = 0.16;  ///< of the picture's width: a box about the click
constexpr int kHatch_px = 8;
constexpr int kStripe_px = 3;

/// Red stripes; what is burnt out is light, and the reticle stays seen between them.
QBrush hatching() {
    QImage tile(kHatch_px, kHatch_px, QImage::Format_ARGB32);
    for (int y = 0; y < kHatch_px; ++y) {
        for (int x = 0; x < kHatch_px; ++x) {
            tile.setPixelColor(x, y, (x + y) % kHatch_px < kStripe_px ? QColor(200, 0, 0) : QColor(Qt::transparent));
        }
    }
    return QBrush(tile);
}

/// Where the mask is white.
QImage stripesOver(const QImage& mask) {
    QImage alpha = mask.copy();
    alpha.reinterpretAsFormat(QImage::Format_Alpha8);
    QImage stripes(mask.size(), QImage::Format_ARGB32_Premultiplied);
    QPainter hatch(&stripes);
    hatch.setCompositionMode(QPainter::CompositionMode_Source);
    hatch.fillRect(stripes.rect(), hatching());
    hatch.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    hatch.drawImage(0, 0, alpha);
    return stripes;
}

}  // namespace

CameraStep::CameraStep(app::CameraPresenter& camera, QWidget* parent)
    : LabStep(parent), camera_(camera), ui_(std::make_unique<Ui::CameraStep>()) {
    ui_->setupUi(this);
    wire();
    showState();
    showControls();
    showMeters();
    showOptions();
}

CameraStep::~CameraStep() = default;

void CameraStep::wire() {
    using app::CameraPresenter;
    connect(ui_->pause, &QPushButton::clicked, &camera_, &CameraPresenter::togglePause);
    connect(ui_->stop, &QPushButton::clicked, &camera_, &CameraPresenter::stop);
    connect(ui_->format, &QPushButton::clicked, this, &CameraStep::formatRequested);
    connect(ui_->lock, &QPushButton::clicked, &camera_, &CameraPresenter::lock);
    connect(ui_->usual, &QPushButton::clicked, &camera_, &CameraPresenter::useUsualValues);
    connect(ui_->reset_peak, &QPushButton::clicked, &camera_, &CameraPresenter::resetPeak);
    connect(ui_->whole, &QPushButton::clicked, &camera_, [this] { camera_.setBox(std::nullopt); });
    connect(ui_->burnt, &QCheckBox::toggled, &camera_, &CameraPresenter::setShowsBurnt);
    connect(ui_->full_stills, &QCheckBox::clicked, &camera_, &CameraPresenter::setFullStills);
    connect(&camera_, &CameraPresenter::stateChanged, this, &CameraStep::showState);
    connect(&camera_, &CameraPresenter::rateChanged, this, &CameraStep::showState);
    connect(&camera_, &CameraPresenter::modesChanged, this, &CameraStep::showState);
    connect(&camera_, &CameraPresenter::controlsChanged, this, &CameraStep::showControls);
    connect(&camera_, &CameraPresenter::metersChanged, this, &CameraStep::showMeters);
    connect(&camera_, &CameraPresenter::optionsChanged, this, &CameraStep::showOptions);
}

void CameraStep::entered() {
    camera_.setMetering(true);
    camera_.setShowsBurnt(ui_->burnt->isChecked());
}

void CameraStep::left() {
    camera_.setMetering(false);
    camera_.setShowsBurnt(false);
}

bool CameraStep::pictureClicked(const QPointF& frame_px) {
    const double side_px = kBoxShare * std::max(camera_.format().size.width(), 320);
    camera_.setBox(QRectF(frame_px - QPointF(side_px, side_px) / 2.0, QSizeF(side_px, side_px)));
    return true;
}

void CameraStep::showState() {
    ui_->lamp->setState(camera_.state());
    ui_->sentence->setText(camera_.sentence());
    ui_->pause->setText(camera_.isRunning() ? tr("Pause") : tr("Start"));
    ui_->pause->setEnabled(camera_.hasCamera());
    ui_->stop->setEnabled(camera_.isRunning() || camera_.isPaused());
    const QString note = camera_.rigNote();
    ui_->rig_note->setText(note);
    ui_->rig_note->setVisible(!note.isEmpty());
    Q_EMIT stateChanged(camera_.state());
}

void CameraStep::showControls() {
    const std::vector<app::ControlRow> rows = camera_.controls();
    std::vector<video::ControlRange> ranges;
    std::ranges::transform(rows, std::back_inserter(ranges), &app::ControlRow::range);
    if (ranges != ranges_) {  // another camera
        ranges_ = ranges;
        qDeleteAll(ui_->controls->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
        qDeleteAll(std::exchange(rows_, {}));
        for (const app::ControlRow& row : rows) {
            rows_.push_back(new ControlRow(camera_, row, *ui_->controls_grid, static_cast<int>(rows_.size()), ui_->controls));
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows_[i]->showRow(rows[i]);
    }
    ui_->no_controls->setVisible(rows.empty());
    ui_->lock->setVisible(!rows.empty());
    ui_->usual->setVisible(!rows.empty());
    ui_->lock->setEnabled(camera_.canLock());
}

void CameraStep::showMeters() {
    const app::CameraMeters& meters = camera_.meters();
    ui_->exposure_lamp->setState(meters.exposure_state);
    ui_->exposure->setText(meters.exposure_text.isEmpty() ? tr("No picture yet.") : meters.exposure_text);
    ui_->histogram->showMeters(meters.picture);
    ui_->sharpness->setText(meters.sharpness_text);
    ui_->peak->setValue(meters.best_sharpness > 0.0 ? qRound(100.0 * meters.sharpness / meters.best_sharpness) : 0);
    stripes_ = meters.burnt.isNull() ? QImage() : stripesOver(meters.burnt);
    Q_EMIT overlayChanged();
}

void CameraStep::showOptions() {
    ui_->box_text->setText(camera_.box() ? tr("In the box; click elsewhere to move it.")
                                         : tr("In the whole picture; click a spot to measure there."));
    ui_->whole->setVisible(camera_.box().has_value());
    ui_->full_stills->setChecked(camera_.takesFullStills());
    ui_->full_stills->setEnabled(camera_.hasLargerMode() || camera_.takesFullStills());
    ui_->full_text->setText(camera_.fullStillText());
    Q_EMIT overlayChanged();
}

void CameraStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const QTransform from_corner = QTransform::fromTranslate(-0.5, -0.5) * widget_from_frame;
    if (camera_.showsBurnt() && !stripes_.isNull()) {
        painter.save();
        painter.setTransform(from_corner, true);
        painter.drawImage(0, 0, stripes_);
        painter.restore();
    }
    if (const auto& box = camera_.box()) {
        QPainterPath frame;
        frame.addPolygon(widget_from_frame.map(QPolygonF(*box)));
        strokeEdged(painter, frame, currentTheme().overlay_light, currentTheme());
    }
}

}  // namespace pmts::gui
