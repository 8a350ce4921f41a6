#include "action_button.hpp"

#include "pmts/gui/theme.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QKeySequence>
#include <QPainter>
#include <QStyle>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kPadding_px = 8;
constexpr int kGap_px = 6;

struct Inks {
    QColor ground, ink;
};

Inks inksFor(ActionButton::Weight weight, bool enabled, bool down, const Theme& theme) {
    if (!enabled) {
        return {theme.window, theme.disabled_text};
    }
    if (down) {
        return {theme.pressed, theme.text};
    }
    switch (weight) {
        case ActionButton::Weight::kMain:
            return {theme.accent, theme.on_accent};
        case ActionButton::Weight::kStop:
            return {theme.stop, theme.on_stop};
        case ActionButton::Weight::kPlain:
            break;
    }
    return {theme.button, theme.text};
}

}  // namespace

QString keyCapText(const QKeySequence& key) {
    if (key.isEmpty()) {
        return {};
    }
    switch (key[0].key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return QCoreApplication::translate("Key", "Enter");
        case Qt::Key_Space:
            return QCoreApplication::translate("Key", "Space");
        case Qt::Key_Escape:
            return QCoreApplication::translate("Key", "Esc");
        case Qt::Key_Left:
            return QStringLiteral("\u2190");
        case Qt::Key_Up:
            return QStringLiteral("\u2191");
        case Qt::Key_Right:
            return QStringLiteral("\u2192");
        case Qt::Key_Down:
            return QStringLiteral("\u2193");
        default:
            return key.toString(QKeySequence::NativeText);
    }
}

ActionButton::ActionButton(QWidget* parent) : QToolButton(parent) {
    setFocusPolicy(Qt::TabFocus);  // a click leaves the focus where it was: the keys stay the picture's
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
}

void ActionButton::setAction(QAction* action, Weight weight) {
    weight_ = weight;
    setDefaultAction(action);
    setAccessibleName(action->text());
    setAccessibleDescription(tr("Key: %1").arg(keyText()));
}

void ActionButton::setIconOnly(bool icon_only) {
    icon_only_ = icon_only;
    updateGeometry();
}

QString ActionButton::keyText() const {
    return defaultAction() ? keyCapText(defaultAction()->shortcut()) : QString();
}

QFont ActionButton::nameFont() const {
    QFont bold = font();
    bold.setBold(true);
    return bold;
}

QFont ActionButton::keyFont() const {
    QFont small = font();
    small.setPointSizeF(std::max(7.0, font().pointSizeF() * 0.85));
    return small;
}

int ActionButton::textWidth() const {
    return std::max(QFontMetrics(nameFont()).horizontalAdvance(text()),
                    QFontMetrics(keyFont()).horizontalAdvance(keyText()) + 10);
}

QSize ActionButton::sizeHint() const {
    const int icon = iconSize().width();
    const int lines = QFontMetrics(nameFont()).height() + QFontMetrics(keyFont()).height() + 10;
    const int wide = icon_only_ ? icon + 2 * kPadding_px : icon + kGap_px + textWidth() + 2 * kPadding_px;
    return {std::max(wide, kLeastSide_px), std::max(icon_only_ ? 0 : lines, kLeastSide_px)};
}

QSize ActionButton::minimumSizeHint() const {
    const int wide = icon_only_ ? kLeastSide_px : textWidth() + kPadding_px;
    return {std::max(wide, kLeastSide_px), sizeHint().height()};
}

void ActionButton::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        updateGeometry();
    }
    QToolButton::changeEvent(event);
}

/// The icon in the ink of the text beside it, whatever the ground.
void ActionButton::paintIcon(QPainter& painter, const QRect& place, const QColor& ink) const {
    QPixmap drawn = icon().pixmap(place.size(), devicePixelRatioF());
    QPainter tint(&drawn);
    tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
    tint.fillRect(drawn.rect(), ink);
    tint.end();
    painter.drawPixmap(place.topLeft(), drawn);
}

void ActionButton::paintGround(QPainter& painter, const QColor& ground, const QColor& ink) const {
    const Theme& theme = currentTheme();
    const double line = hasFocus() ? 2.5 : theme.line_px;
    const QRectF box =
        QRectF(rect()).adjusted(line / 2 + 0.5, line / 2 + 0.5, -line / 2 - 0.5, -line / 2 - 0.5);
    QPen pen(hasFocus()                                 ? theme.accent
             : isEnabled() && weight_ != Weight::kPlain ? ground
                                                        : theme.border,
             line);
    if (!isEnabled() && theme.name == PaletteName::kSun) {
        pen.setStyle(Qt::DashLine);
    }
    painter.setPen(pen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 6, 6);
    if (underMouse() && isEnabled()) {
        painter.setPen(QPen(ink, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), 4, 4);
    }
}

void ActionButton::paintName(QPainter& painter, const QRect& place, const QColor& ink) const {
    const QString key = keyText();
    const int name_height = QFontMetrics(nameFont()).height();
    const int key_height = key.isEmpty() ? 0 : QFontMetrics(keyFont()).height() + 2;
    QRect name(place.left(), place.center().y() - (name_height + key_height) / 2, place.width(), name_height);
    painter.setPen(ink);
    painter.setFont(nameFont());
    painter.drawText(name, Qt::AlignVCenter | Qt::AlignLeading, text());
    if (key.isEmpty()) {
        return;
    }
    painter.setFont(keyFont());
    QRect cap(0, name.bottom() + 2, QFontMetrics(keyFont()).horizontalAdvance(key) + 10, key_height);
    cap.moveLeft(place.left());
    cap = QStyle::visualRect(layoutDirection(), place, cap);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(cap).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter.drawText(cap, Qt::AlignCenter, key);
}

void ActionButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setLayoutDirection(layoutDirection());
    const Inks inks = inksFor(weight_, isEnabled(), isDown() || isChecked(), currentTheme());
    paintGround(painter, inks.ground, inks.ink);
    const int side = iconSize().width();
    const bool has_room = icon_only_ || width() >= side + kGap_px + textWidth() + kPadding_px;
    QRect inner = rect().adjusted(kPadding_px, 0, -kPadding_px, 0);
    if (icon_only_) {
        QRect middle(0, 0, side, side);
        middle.moveCenter(rect().center());
        paintIcon(painter, middle, inks.ink);
        return;
    }
    if (has_room) {
        QRect place(inner.left(), (height() - side) / 2, side, side);
        paintIcon(painter, QStyle::visualRect(layoutDirection(), inner, place), inks.ink);
        inner = QStyle::visualRect(layoutDirection(), inner, inner.adjusted(side + kGap_px, 0, 0, 0));
    } else {
        inner = rect().adjusted(kPadding_px / 2, 0, -kPadding_px / 2, 0);
    }
    paintName(painter, inner, inks.ink);
}

}  // namespace pmts::gui
