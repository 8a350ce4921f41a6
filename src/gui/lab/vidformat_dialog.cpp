#include "vidformat_dialog.hpp"

#include "ui_vidformat_dialog.h"

namespace pmts::gui {

VidformatDialog::VidformatDialog(app::CameraPresenter& camera, QWidget* parent)
    : QDialog(parent), camera_(camera), ui_(std::make_unique<Ui::VidformatDialog>()) {
    ui_->setupUi(this);
    connect(ui_->apply, &QPushButton::clicked, this, &VidformatDialog::apply);
    connect(ui_->close, &QPushButton::clicked, this, &QDialog::close);
    connect(ui_->size, &QComboBox::currentIndexChanged, this, &VidformatDialog::showPixels);
    connect(ui_->pixels, &QComboBox::currentIndexChanged, this, &VidformatDialog::showRates);
    connect(&camera_, &app::CameraPresenter::modesChanged, this, &VidformatDialog::showCamera);
    connect(&camera_, &app::CameraPresenter::rateChanged, this, &VidformatDialog::showMeasured);
    connect(&camera_, &app::CameraPresenter::stateChanged, this, &VidformatDialog::showMeasured);
    showCamera();
}

VidformatDialog::~VidformatDialog() = default;

void VidformatDialog::showCamera() {
    const auto now = camera_.format();
    {
        const QSignalBlocker quiet(ui_->size);
        ui_->size->clear();
        for (const QSize& size : camera_.sizes()) {
            ui_->size->addItem(QStringLiteral("%1 x %2").arg(size.width()).arg(size.height()), size);
        }
        ui_->size->setCurrentIndex(ui_->size->findData(now.size));
    }
    const bool has_choice = ui_->size->count() > 0;
    for (QWidget* const part : {static_cast<QWidget*>(ui_->size), static_cast<QWidget*>(ui_->pixels),
                                static_cast<QWidget*>(ui_->rate), static_cast<QWidget*>(ui_->apply)}) {
        part->setEnabled(has_choice);
    }
    showPixels();
    const QString note = camera_.rigNote();
    ui_->note->setText(has_choice ? note : tr("The formats are known once the camera runs."));
    ui_->note->setVisible(!ui_->note->text().isEmpty());
    showMeasured();
}

void VidformatDialog::showPixels() {
    {
        const QSignalBlocker quiet(ui_->pixels);
        const QString before = ui_->pixels->count() > 0 ? ui_->pixels->currentText() : camera_.format().pixel_format;
        ui_->pixels->clear();
        ui_->pixels->addItems(camera_.pixelFormats(ui_->size->currentData().toSize()));
        ui_->pixels->setCurrentIndex(std::max(0, ui_->pixels->findText(before)));
    }
    showRates();
}

void VidformatDialog::showRates() {
    const double now_hz = camera_.format().rate_hz;
    ui_->rate->clear();
    for (const double rate_hz : camera_.rates(ui_->size->currentData().toSize(), ui_->pixels->currentText())) {
        ui_->rate->addItem(tr("%1 a second").arg(rate_hz, 0, 'g', 4), rate_hz);
        if (std::abs(rate_hz - now_hz) < 0.05) {
            ui_->rate->setCurrentIndex(ui_->rate->count() - 1);
        }
    }
}

void VidformatDialog::showMeasured() {
    ui_->camera->setText(camera_.sentence());
    ui_->measured->setText(camera_.measuredText());
}

void VidformatDialog::apply() {
    if (ui_->size->currentIndex() >= 0) {
        camera_.setFormat({ui_->size->currentData().toSize(), ui_->rate->currentData().toDouble(), ui_->pixels->currentText()});
    }
}

}  // namespace pmts::gui
