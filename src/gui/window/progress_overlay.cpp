#include "progress_overlay.hpp"

#include "ui_progress_overlay.h"

#include <QEvent>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kMargin_px = 12;
constexpr int kLeastWidth_px = 380;

}  // namespace

ProgressOverlay::ProgressOverlay(QWidget* parent)
    : QFrame(parent), ui_(std::make_unique<Ui::ProgressOverlay>()) {
    ui_->setupUi(this);
    ui_->lamp->setState(app::DeviceState::kBusy);
    connect(ui_->cancel, &QPushButton::clicked, this, &ProgressOverlay::cancelled);
    parent->installEventFilter(this);
    hide();
}

ProgressOverlay::~ProgressOverlay() = default;

void ProgressOverlay::showBusy(const QString& text, double fraction) {
    ui_->text->setText(text);
    ui_->bar->setMaximum(fraction > 0.0 ? 1000 : 0);
    ui_->bar->setValue(qRound(std::clamp(fraction, 0.0, 1.0) * 1000));
    place();
    show();
    raise();
}

void ProgressOverlay::place() {
    const QSize wanted =
        layout()->sizeHint().expandedTo(QSize(kLeastWidth_px, 0)).boundedTo(parentWidget()->size());
    setGeometry((parentWidget()->width() - wanted.width()) / 2, kMargin_px, wanted.width(), wanted.height());
}

bool ProgressOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

}  // namespace pmts::gui
