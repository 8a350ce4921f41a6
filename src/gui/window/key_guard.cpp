#include "key_guard.hpp"

#include "field/field_actions.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace pmts::gui {
namespace {

bool isTypedIn(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

bool walks(int key) {
    switch (key) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return true;
        default:
            return false;
    }
}

bool presses(int key) { return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter; }

/// The list of a choice, opened: letters search in it.
bool isOpenList(const QWidget* widget) { return qobject_cast<const QAbstractItemView*>(widget) && widget->window()->windowType() == Qt::Popup; }

bool belongsTo(const QWidget* focus, const QKeyEvent& event) {
    if (!belongsToField(event.key(), event.modifiers())) {
        return false;
    }
    return isTypedIn(focus) || isOpenList(focus) || (qobject_cast<const QAbstractItemView*>(focus) && walks(event.key())) ||
           (qobject_cast<const QAbstractButton*>(focus) && presses(event.key()));
}

}  // namespace

KeyGuard::KeyGuard(std::function<bool()> stop_if_moving, QObject* parent)
    : QObject(parent), stop_if_moving_(std::move(stop_if_moving)) {
    qApp->installEventFilter(this);
}

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto& key = static_cast<QKeyEvent&>(*event);
        swallow_escape_ = key.key() == Qt::Key_Escape && stop_if_moving_();
        if (swallow_escape_ || belongsTo(QApplication::focusWidget(), key)) {
            event->accept();
            return swallow_escape_ || !isOpenList(QApplication::focusWidget());  // such a list chooses on seeing this very event
        }
    } else if (event->type() == QEvent::KeyPress && swallow_escape_ &&
               static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        return true;
    } else if (event->type() == QEvent::KeyRelease) {
        swallow_escape_ = false;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace pmts::gui
