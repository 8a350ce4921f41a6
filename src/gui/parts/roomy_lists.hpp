#pragma once

#include <QObject>

namespace pmts::gui {

/// Gives the open list of every choice rows for a gloved finger and the accent under the chosen one: the delegate a
/// choice brings along knows nothing of the style sheet.
class RoomyLists : public QObject {
    Q_OBJECT
public:
    explicit RoomyLists(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace pmts::gui
