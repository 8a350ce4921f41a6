#include "apa_dialog.hpp"

#include "parts/line_icon.hpp"
#include "ui_apa_dialog.h"

#include <array>

namespace pmts::gui {

using app::Extreme;

namespace {

constexpr QSize kFirstSize(790, 690);  ///< leaves the reticle of the live view free at 1280x800
constexpr double kZoomStep = 1.5;
constexpr std::array kAll{Extreme::kLeft, Extreme::kRight, Extreme::kUpper, Extreme::kLower};

QString orDash(const QString& text) { return text.isEmpty() ? QStringLiteral("–") : text; }

void showResult(const app::ApaResult& result, QLabel& between, QLabel& per_pixel, StateLamp& lamp, QLabel& judgement) {
    const bool any = !result.angle.isEmpty() || !result.pixels.isEmpty();
    between.setText(any ? ApaDialog::tr("%1 over %2").arg(orDash(result.angle), orDash(result.pixels)) : orDash({}));
    per_pixel.setText(result.per_pixel.isEmpty() ? orDash({}) : ApaDialog::tr("%1 per pixel").arg(result.per_pixel));
    lamp.setState(result.state);
    judgement.setText(result.judgement);
}

}  // namespace

ApaDialog::ApaDialog(app::ApaPresenter& apa, const app::InstrumentDesk& instrument, const app::Preferences& preferences,
                     QWidget* parent)
    : QDialog(parent), apa_(apa), ui_(std::make_unique<Ui::ApaDialog>()) {
    ui_->setupUi(this);
    resize(kFirstSize);
    connect(ui_->capture, &QPushButton::clicked, &apa_, &app::ApaPresenter::capture);
    connect(ui_->reading, &QPushButton::clicked, &apa_, &app::ApaPresenter::takeReading);
    connect(ui_->store, &QPushButton::clicked, &apa_, &app::ApaPresenter::store);
    connect(ui_->close, &QPushButton::clicked, this, &QDialog::close);
    const std::array buttons{ui_->left, ui_->right, ui_->upper, ui_->lower};
    for (std::size_t i = 0; i < kAll.size(); ++i) {
        connect(buttons[i], &QPushButton::clicked, &apa_, [this, which = kAll[i]] { apa_.choose(which); });
    }
    connect(&apa_, &app::ApaPresenter::changed, this, &ApaDialog::showAll);
    connect(&apa_, &app::ApaPresenter::said, this, &ApaDialog::say);
    connect(&apa_, &app::ApaPresenter::refused, this, &ApaDialog::say);
    connect(&instrument, &app::InstrumentDesk::pointingChanged, this, [this, &preferences](const app::TimedPointing& now) {
        ui_->now->setText(tr("Now HA %1\nVA %2").arg(preferences.units().direction(now.pointing.ha),
                                                     preferences.units().angle(now.pointing.va)));
    });
    wirePicture();
    showAll();
}

ApaDialog::~ApaDialog() = default;

void ApaDialog::wirePicture() {
    ImageView* const picture = ui_->picture;
    connect(picture, &ImageView::pixelClicked, &apa_, &app::ApaPresenter::click);
    ui_->zoom_in->setIcon(lineIcon(QStringLiteral("zoom-in")));
    ui_->zoom_out->setIcon(lineIcon(QStringLiteral("zoom-out")));
    ui_->fit->setIcon(lineIcon(QStringLiteral("fit")));
    connect(ui_->zoom_in, &QToolButton::clicked, picture, [picture] { picture->setZoom(picture->zoom() * kZoomStep); });
    connect(ui_->zoom_out, &QToolButton::clicked, picture, [picture] { picture->setZoom(picture->zoom() / kZoomStep); });
    connect(ui_->fit, &QToolButton::clicked, picture, &ImageView::fit);
}

void ApaDialog::showAll() {
    ui_->step->setText(apa_.step());
    ui_->message->clear();
    ui_->kept->setText(apa_.storedText());
    ui_->store->setEnabled(apa_.canStore());
    ui_->reading->setEnabled(apa_.still().has_value());
    showObjects();
    showPicture();
    showResult(apa_.across(), *ui_->across_between, *ui_->across_per_pixel, *ui_->across_lamp, *ui_->across_judgement);
    showResult(apa_.down(), *ui_->down_between, *ui_->down_per_pixel, *ui_->down_lamp, *ui_->down_judgement);
}

void ApaDialog::showObjects() {
    struct Row {
        QPushButton* choose;
        QLabel *px, *reading;
    };
    const std::array rows{Row{ui_->left, ui_->left_px, ui_->left_reading}, Row{ui_->right, ui_->right_px, ui_->right_reading},
                          Row{ui_->upper, ui_->upper_px, ui_->upper_reading}, Row{ui_->lower, ui_->lower_px, ui_->lower_reading}};
    for (std::size_t i = 0; i < kAll.size(); ++i) {
        const app::ApaObject object = apa_.object(kAll[i]);
        rows[i].choose->setChecked(apa_.current() == kAll[i]);
        rows[i].px->setText(orDash(object.px_text));
        rows[i].reading->setText(orDash(object.reading_text));
    }
}

void ApaDialog::showPicture() {
    const auto& still = apa_.still();
    ui_->picture->setFrame(still ? still->frame : nullptr);
    ui_->picture->setNotice(still ? QString() : tr("No still yet."));
    ui_->picture_text->setText(apa_.stillText());
    ImageOverlay overlay;
    for (const Extreme which : kAll) {
        if (const app::ApaObject object = apa_.object(which); object.px) {
            overlay.points.push_back({.px = *object.px, .label = object.name, .selected = which == apa_.current()});
        }
    }
    ui_->picture->setOverlay(overlay);
}

void ApaDialog::say(const QString& sentence) {
    ui_->message->setText(sentence == ui_->step->text() ? QString() : sentence);
}

}  // namespace pmts::gui
