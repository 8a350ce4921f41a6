#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>

namespace pmts::gui {

/// Everything that can be done, once: the bottom bar, the menu, the key list and the tests take their actions
/// from here.
class FieldActions : public QObject {
    Q_OBJECT
public:
    explicit FieldActions(QWidget* window);

    QAction *capture, *move, *measure, *convert, *record, *all;
    QAction *left, *up, *down, *right, *step, *stop;
    QAction *edit_point, *aim, *change_face, *clear_target, *record_again;
    QAction *aiming, *recentre, *click_turns, *move_open;
    QAction *new_job, *open_job, *export_points, *import_planned, *evidence, *quit;
    QAction *station, *connection, *units, *keys, *about, *sounds;
    QAction *field, *lab, *line, *focus, *zoom_in, *zoom_out, *fit;
    QAction *snap, *drag_turns, *zoom_box, *mark, *range;
    QAction *pause_camera, *stop_camera, *video_format, *export_photos;
    QAction *open_black_box, *bug_report;
    QAction *day, *night, *sun;
    QAction *larger_text, *smaller_text;

    /// For the key list: in the order above, those with a key.
    [[nodiscard]] QList<QAction*> withKeys() const;

private:
    QAction* make(const QString& text, const QString& tip, const QKeySequence& key,
                  const char* icon = nullptr);

    QWidget* window_;
    QList<QAction*> all_;
};

/// True for a key without Ctrl, Alt or Meta that types or moves something in a field: while one has the
/// focus, the key is its.
[[nodiscard]] bool belongsToField(int key, Qt::KeyboardModifiers modifiers);

}  // namespace pmts::gui
