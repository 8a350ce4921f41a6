#pragma once

#include "pmts/app/line/black_box_presenter.hpp"

#include <QList>
#include <QObject>
#include <QPointF>

class QAction;
class QMouseEvent;
class QShortcutEvent;
class QWidget;

namespace pmts::gui {

/// Tells the black box what is clicked and done in this program: the widget, the place on it and what stands there, actions,
/// choices of menus, shortcuts. What is typed is not told.
class ActionWatch : public QObject {
    Q_OBJECT
public:
    /// Watches every window, and the actions of this one.
    ActionWatch(app::BlackBoxPresenter& black_box, QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void noteClick(const QWidget& widget, const QMouseEvent& click);
    void noteChosen(QAction* action);
    void noteShortcut(const QObject& owner, const QShortcutEvent& shortcut);

    app::BlackBoxPresenter& black_box_;
    quint64 last_click_ = 0;  ///< its time: a click that a widget passes on comes again
    QPointF last_place_;
    QList<QAction*> told_;  ///< of the window: they tell themselves
};

}  // namespace pmts::gui
