#include "arrow_hold.hpp"

#include "field_actions.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>

#include <algorithm>

namespace pmts::gui {

ArrowHold::ArrowHold(const FieldActions& actions, app::StepRunner& steps, QObject* parent)
    : QObject(parent),
      steps_(steps),
      arrows_{{actions.left, app::Direction::kLeft},
              {actions.right, app::Direction::kRight},
              {actions.up, app::Direction::kUp},
              {actions.down, app::Direction::kDown}} {
    std::ranges::for_each(arrows_, [this](const Arrow& arrow) { wire(arrow); });
    qApp->installEventFilter(this);
}

void ArrowHold::wire(const Arrow& arrow) {
    connect(arrow.action, &QAction::triggered, this, [this, arrow] {
        if (key_down_ != 0 && arrow.action->shortcut() == QKeySequence(key_down_)) {
            steps_.keyPressed(arrow.direction);
        } else {
            steps_.step(arrow.direction);
        }
    });
    for (QObject* const shown : arrow.action->associatedObjects()) {
        if (const auto* const button = qobject_cast<QAbstractButton*>(shown)) {
            connect(button, &QAbstractButton::pressed, this,
                    [this, arrow] { steps_.buttonPressed(arrow.direction); });
            connect(button, &QAbstractButton::released, &steps_, &app::StepRunner::released);
        }
    }
}

bool ArrowHold::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride: {
            const auto& key = static_cast<const QKeyEvent&>(*event);
            const bool is_arrow = std::ranges::any_of(arrows_, [&](const Arrow& arrow) {
                return arrow.action->shortcut() == QKeySequence(key.key());
            });
            if (is_arrow && !key.isAutoRepeat()) {
                key_down_ = key.key();
            }
            break;
        }
        case QEvent::KeyRelease: {
            const auto& key = static_cast<const QKeyEvent&>(*event);
            if (key.key() == key_down_ && !key.isAutoRepeat()) {
                key_down_ = 0;
                steps_.keyReleased();
            }
            break;
        }
        case QEvent::WindowDeactivate:  // the release would go to another window
            if (key_down_ != 0) {
                key_down_ = 0;
                steps_.released();
            }
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace pmts::gui
