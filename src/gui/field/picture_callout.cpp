#include "picture_callout.hpp"

#include "parts/action_button.hpp"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kAway_px = 22;
constexpr int kNameWidth_px = 110;

}  // namespace

PictureCallout::PictureCallout(QWidget* picture) : QFrame(picture), row_(new QHBoxLayout(this)) {
    setObjectName(QStringLiteral("callout"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setCursor(Qt::ArrowCursor);
    row_->setContentsMargins(5, 5, 5, 5);
    row_->setSpacing(5);
    hide();
}

void PictureCallout::empty() {
    while (QLayoutItem* const item = row_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();  // it may be the button that was just pressed
        delete item;
    }
}

void PictureCallout::addButtons(std::vector<Choice> choices) {
    for (Choice& choice : choices) {
        auto* const button = new QPushButton(choice.text, this);
        button->setMinimumSize(ActionButton::kLeastSide_px, ActionButton::kLeastSide_px);
        button->setAutoDefault(false);
        row_->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, act = std::move(choice.act)] {
            hide();
            act();
        });
    }
}

void PictureCallout::offer(const QPointF& at, std::vector<Choice> choices) {
    empty();
    addButtons(std::move(choices));
    showBeside(at);
}

void PictureCallout::offerWithName(const QPointF& at, const QString& name,
                                   std::function<void(const QString&)> rename, std::vector<Choice> choices) {
    empty();
    auto* const field = new QLineEdit(name, this);
    field->setObjectName(QStringLiteral("mark_name"));
    field->setAccessibleName(tr("Name of the mark"));
    field->setMinimumHeight(ActionButton::kLeastSide_px);
    field->setFixedWidth(kNameWidth_px);
    row_->addWidget(field);
    connect(field, &QLineEdit::editingFinished, this,
            [field, rename = std::move(rename)] { rename(field->text()); });
    connect(field, &QLineEdit::returnPressed, this, &QWidget::hide);
    addButtons(std::move(choices));
    showBeside(at);
    field->selectAll();
    field->setFocus();
}

void PictureCallout::showBeside(const QPointF& at) {
    adjustSize();
    const QSize room = parentWidget()->size();
    const int right = static_cast<int>(at.x()) + kAway_px;
    const int left = static_cast<int>(at.x()) - kAway_px - width();
    const int x = right + width() <= room.width() ? right : std::max(0, left);
    const int y =
        std::clamp(static_cast<int>(at.y()) + kAway_px / 2, 0, std::max(0, room.height() - height()));
    move(x, y);
    show();
    raise();
}

}  // namespace pmts::gui
