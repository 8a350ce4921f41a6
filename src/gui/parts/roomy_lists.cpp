#include "roomy_lists.hpp"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QStyledItemDelegate>

namespace pmts::gui {

RoomyLists::RoomyLists(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool RoomyLists::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish) {
        if (auto* const choice = qobject_cast<QComboBox*>(watched)) {
            choice->setItemDelegate(new QStyledItemDelegate(choice));
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace pmts::gui
