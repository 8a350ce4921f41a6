#include "action_watch.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QShortcutEvent>
#include <QTabBar>

namespace pmts::gui {
namespace {

/// `LineWorkspace/time_line_page/timeline_view`: names where there are some, else classes.
QString pathOf(const QWidget& widget) {
    QStringList names;
    for (const QWidget* part = &widget; part != nullptr && names.size() < 3; part = part->parentWidget()) {
        const QString class_name = QString::fromLatin1(part->metaObject()->className()).section(QStringLiteral("::"), -1);
        const bool has_name = !part->objectName().isEmpty() && !part->objectName().startsWith(QLatin1String("qt_"));
        names.prepend(has_name ? part->objectName() : class_name);
    }
    return names.join(u'/');
}

QString withoutMark(QString text) { return text.remove(u'&'); }

/// What stands where the click fell: never what was typed.
QString wordsAt(const QWidget& widget, const QPoint& at) {
    if (const auto* const button = qobject_cast<const QAbstractButton*>(&widget); button && !button->text().isEmpty()) {
        return withoutMark(button->text());
    }
    if (const auto* const tabs = qobject_cast<const QTabBar*>(&widget); tabs && tabs->tabAt(at) >= 0) {
        return withoutMark(tabs->tabText(tabs->tabAt(at)));
    }
    if (const auto* const menu = qobject_cast<const QMenu*>(&widget)) {
        const QAction* const action = menu->actionAt(at);
        return action ? withoutMark(action->text()) : QString();
    }
    if (const auto* const menus = qobject_cast<const QMenuBar*>(&widget)) {
        const QAction* const action = menus->actionAt(at);
        return action ? withoutMark(action->text()) : QString();
    }
    const auto* const list = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (list && list->viewport() == &widget) {  // lists, tables, and the list of a choice
        return list->indexAt(at).data().toString();
    }
    return widget.accessibleName();
}

}  // namespace

ActionWatch::ActionWatch(app::BlackBoxPresenter& black_box, QWidget& window) : QObject(&window), black_box_(black_box) {
    qApp->installEventFilter(this);
    for (QAction* const action : window.actions()) {
        connect(action, &QAction::triggered, this, [this, action] {
            black_box_.noteAction(withoutMark(action->text()), QStringLiteral("action"));
        });
    }
    told_ = window.actions();
}

bool ActionWatch::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType()) {
        noteClick(static_cast<const QWidget&>(*watched), static_cast<const QMouseEvent&>(*event));
    } else if (event->type() == QEvent::Shortcut) {
        noteShortcut(*watched, static_cast<const QShortcutEvent&>(*event));
    } else if (auto* const menu = event->type() == QEvent::Show ? qobject_cast<QMenu*>(watched) : nullptr) {
        connect(menu, &QMenu::triggered, this, &ActionWatch::noteChosen, Qt::UniqueConnection);
    }
    return QObject::eventFilter(watched, event);
}

void ActionWatch::noteClick(const QWidget& widget, const QMouseEvent& click) {
    if (click.timestamp() == last_click_ && click.globalPosition() == last_place_) {
        return;
    }
    last_click_ = click.timestamp();
    last_place_ = click.globalPosition();
    const QString words = wordsAt(widget, click.position().toPoint());
    black_box_.noteAction(words.isEmpty() ? tr("Click") : tr("Click on %1").arg(words), pathOf(widget), click.position().toPoint());
}

/// By mouse or keys. A menu hears of its submenus too, and the window's own actions tell themselves.
void ActionWatch::noteChosen(QAction* action) {
    const auto* const menu = qobject_cast<const QMenu*>(sender());
    if (menu && menu->actions().contains(action) && !told_.contains(action)) {
        black_box_.noteAction(withoutMark(menu->title() + QStringLiteral(" > ") + action->text()), QStringLiteral("menu"));
    }
}

void ActionWatch::noteShortcut(const QObject& owner, const QShortcutEvent& shortcut) {
    const auto* const action = qobject_cast<const QAction*>(&owner);
    const auto* const widget = qobject_cast<const QWidget*>(owner.parent());
    const QString where = action ? withoutMark(action->text()) : widget ? pathOf(*widget) : QString();
    black_box_.noteAction(tr("Key %1").arg(shortcut.key().toString()), where);
}

}  // namespace pmts::gui
