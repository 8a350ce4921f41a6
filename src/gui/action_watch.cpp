#include "action_watch.hpp"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QMouseEvent>

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

}  // namespace

ActionWatch::ActionWatch(app::BlackBoxPresenter& black_box, QWidget& window) : QObject(&window), black_box_(black_box) {
    qApp->installEventFilter(this);
    for (QAction* const action : window.actions()) {
        connect(action, &QAction::triggered, this, [this, action] {
            black_box_.noteAction(action->text().remove(u'&'), QStringLiteral("action"));
        });
    }
}

bool ActionWatch::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType()) {
        noteClick(static_cast<const QWidget&>(*watched), static_cast<const QMouseEvent&>(*event));
    }
    return QObject::eventFilter(watched, event);
}

void ActionWatch::noteClick(const QWidget& widget, const QMouseEvent& click) {
    if (click.timestamp() == last_click_ && click.globalPosition() == last_place_) {
        return;
    }
    last_click_ = click.timestamp();
    last_place_ = click.globalPosition();
    const auto* const button = qobject_cast<const QAbstractButton*>(&widget);
    const QString what = button && !button->text().isEmpty() ? tr("Click on %1").arg(button->text().remove(u'&')) : tr("Click");
    black_box_.noteAction(what, pathOf(widget), click.position().toPoint());
}

}  // namespace pmts::gui
