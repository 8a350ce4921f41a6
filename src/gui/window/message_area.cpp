#include "message_area.hpp"

#include "parts/line_icon.hpp"
#include "parts/state_lamp.hpp"
#include "ui_message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pmts::gui {
namespace {

constexpr int kToast_ms = 2500;
constexpr int kToastMargin_px = 16;

QString countedText(const app::Message& message) {
    return message.count > 1 ? MessageBar::tr("%1 (%2 times)").arg(message.happened).arg(message.count)
                             : message.happened;
}

}  // namespace

MessageBar::MessageBar(const app::Message& message, QWidget* parent)
    : QFrame(parent), ui_(std::make_unique<Ui::MessageBar>()) {
    ui_->setupUi(this);
    ui_->lamp->setState(message.kind == app::MessageKind::kWarning ? app::DeviceState::kWarning
                                                                   : app::DeviceState::kFailed);
    setProperty("warning", message.kind == app::MessageKind::kWarning);
    ui_->happened->setText(countedText(message));
    ui_->remedy->setText(message.remedy);
    ui_->remedy->setVisible(!message.remedy.isEmpty());
    ui_->details->setText(message.details);
    ui_->details->hide();
    ui_->more->setVisible(!message.details.isEmpty());
    ui_->act->setText(message.action_text);
    ui_->act->setVisible(message.action != app::MessageAction::kNone);
    ui_->dismiss->setIcon(lineIcon(QStringLiteral("close")));
    connect(ui_->more, &QToolButton::toggled, ui_->details, &QWidget::setVisible);
    connect(ui_->act, &QPushButton::clicked, this,
            [this, action = message.action] { Q_EMIT actionChosen(action); });
    connect(ui_->dismiss, &QToolButton::clicked, this, [this, id = message.id] { Q_EMIT dismissed(id); });
}

MessageBar::~MessageBar() = default;

MessageArea::MessageArea(QWidget* parent) : QWidget(parent) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    hide();
}

void MessageArea::showBars(const std::vector<app::Message>& bars) {
    while (QLayoutItem* item = layout()->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    int shown = 0;
    for (auto message = bars.rbegin(); message != bars.rend() && shown < kMostShown; ++message, ++shown) {
        auto* const bar = new MessageBar(*message, this);
        layout()->addWidget(bar);
        connect(bar, &MessageBar::actionChosen, this, &MessageArea::actionChosen);
        connect(bar, &MessageBar::dismissed, this, &MessageArea::dismissed);
    }
    setVisible(shown > 0);
}

Toast::Toast(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
    setObjectName(QStringLiteral("toast"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(14, 8, 14, 8);
    row->addWidget(label_);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide_soon_.setSingleShot(true);
    connect(&hide_soon_, &QTimer::timeout, this, &QWidget::hide);
    parent->installEventFilter(this);
    hide();
}

void Toast::showText(const QString& text) {
    label_->setText(text);
    place();
    show();
    raise();
    hide_soon_.start(kToast_ms);
}

void Toast::place() {
    const QSize size = layout()->sizeHint().boundedTo(parentWidget()->size());
    resize(size);
    move((parentWidget()->width() - size.width()) / 2,
         parentWidget()->height() - size.height() - kToastMargin_px);
}

bool Toast::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

}  // namespace pmts::gui
