#include "field_actions.hpp"

#include "parts/line_icon.hpp"

#include <QActionGroup>
#include <QWidget>

#include <algorithm>

namespace pmts::gui {

FieldActions::FieldActions(QWidget* window) : QObject(window), window_(window) {
    capture = make(tr("Capture"), tr("Freeze a picture with its HA and VA"), Qt::Key_C, "capture");
    move = make(tr("Move"), tr("Turn to the target"), Qt::Key_Return, "move");
    move->setShortcuts({Qt::Key_Return, Qt::Key_Enter});
    measure = make(tr("Measure"), tr("Measure the distance"), Qt::Key_D, "measure");
    convert = make(tr("Convert"), tr("Compute E, N, H"), Qt::Key_M, "convert");
    record = make(tr("Record"), tr("Record the point under the next ID"), Qt::Key_R, "record");
    all = make(tr("All"), tr("Measure, convert and record"), Qt::Key_Space, "all");
    left = make(tr("Left"), tr("Turn left by a step"), Qt::Key_Left, "left");
    up = make(tr("Up"), tr("Turn up by a step"), Qt::Key_Up, "up");
    down = make(tr("Down"), tr("Turn down by a step"), Qt::Key_Down, "down");
    right = make(tr("Right"), tr("Turn right by a step"), Qt::Key_Right, "right");
    step = make(tr("Step"), tr("Step of the arrow keys"), Qt::Key_S, "step");
    stop = make(tr("STOP"), tr("Stop whatever moves or measures"), Qt::Key_Escape, "stop");
    edit_point =
        make(tr("Edit next point"), tr("Type ID, code and remark of the next point"), Qt::Key_P, "edit");
    aim = make(tr("Aim at HA, VA…"), tr("Type where to turn"), Qt::Key_A, "target");
    aiming = make(tr("Aiming…"), tr("Method, re-centring, limits, Sun, cable"), Qt::SHIFT | Qt::Key_A, "target");
    recentre = make(tr("Re-centre"), tr("Find the clicked spot after the move and turn until it is on the reticle"),
                    Qt::Key_X);
    click_turns = make(tr("One click turns"), tr("A click turns at once, without Move"), Qt::Key_O);
    move_open = make(tr("Move without re-centring"), tr("Turn to the target once, without the picture"),
                     Qt::SHIFT | Qt::Key_Return);
    change_face = make(tr("Change face"), tr("The same target in the other face"), Qt::Key_F);
    clear_target = make(tr("Clear target"), tr("Forget the target"), Qt::Key_Backspace);
    record_again = make(tr("Record the same shot again"), tr("Under the next ID"), Qt::SHIFT | Qt::Key_R);
    new_job = make(tr("New job…"), tr("A new job file"), QKeySequence::New, "new");
    open_job = make(tr("Open job…"), tr("Another job file"), QKeySequence::Open, "job");
    export_points = make(tr("Export points…"), tr("CSV, GeoJSON or DXF"), Qt::CTRL | Qt::Key_E, "export");
    import_planned = make(tr("Import planned points…"), tr("ID, E, N, H from a CSV file"), {}, "import");
    evidence = make(tr("Evidence…"), tr("How the selected point, or the newest, was aimed by image"),
                    Qt::Key_E, "evidence");
    quit = make(tr("Quit"), tr("Close PMTS"), Qt::CTRL | Qt::Key_Q);
    station = make(tr("Station…"), tr("Coordinates, instrument height, orientation"), Qt::Key_T, "station");
    connection = make(tr("Connection…"), tr("Instrument, camera, rig"), Qt::Key_I, "link");
    units = make(tr("Units…"), tr("gon, degrees, DMS, mil; m, ft"), Qt::Key_U, "units");
    keys = make(tr("Keys"), tr("All keys"), Qt::Key_F1, "keys");
    about = make(tr("About PMTS"), {}, {}, "info");
    sounds = make(tr("Sounds"), tr("Arrived, recorded, failed"), {});
    field = make(tr("Field"), tr("Workspace Field"), Qt::CTRL | Qt::Key_1, "field");
    lab = make(tr("Lab"), tr("Workspace Lab: mount, adjust and calibrate the camera"), Qt::CTRL | Qt::Key_4, "lab");
    line = make(tr("Line"), tr("Workspace Line: traffic and log"), Qt::CTRL | Qt::Key_5, "line");
    focus = make(tr("Only live view"), tr("Hide all but live view, readings and bottom bar"), Qt::Key_F11,
                 "full");
    zoom_in = make(tr("Zoom in"), tr("Live view larger"), Qt::Key_Plus, "zoom-in");
    zoom_out = make(tr("Zoom out"), tr("Live view smaller"), Qt::Key_Minus, "zoom-out");
    fit = make(tr("Whole picture"), tr("Live view as a whole"), Qt::Key_0, "fit");
    snap = make(tr("Snap"), tr("A click takes the corner, crossing, circle or ellipse beside it"), Qt::Key_N, "snap");
    drag_turns = make(tr("Drag turns"), tr("Drag a spot in the live view to where it shall come; with Shift always"),
                      Qt::Key_G, "drag");
    zoom_box = make(tr("Zoom box"), tr("Drag a box in a picture: that part is shown enlarged"), Qt::Key_B, "zoom-box");
    mark = make(tr("Mark"), tr("Click to mark a picture; drag a mark to move it"), Qt::Key_K, "mark");
    range = make(tr("Range…"), tr("Range in use, assumed range, parallax curve"), Qt::Key_W);
    pause_camera = make(tr("Pause camera"), tr("The picture stands still, the camera is kept; again: it goes on"), Qt::Key_V, "pause");
    stop_camera = make(tr("Stop camera"), tr("Let the camera go, for other programs; Pause camera starts it again"),
                       Qt::SHIFT | Qt::Key_V);
    video_format = make(tr("Video format…"), tr("Size, rate and pixel format of the live view"), Qt::SHIFT | Qt::Key_I, "camera");
    export_photos = make(tr("Export photos…"), tr("JPEG files with EXIF, XMP and a sidecar file"), Qt::CTRL | Qt::SHIFT | Qt::Key_E,
                         "export");
    open_black_box = make(tr("Open black box…"), tr("Show in a window of its own what a black box file recorded"), {});
    bug_report = make(tr("Bug report…"), tr("The last minutes of the black box in one file, without personal names"), {});
    day = make(tr("Day"), tr("Light grey"), {}, "day");
    night = make(tr("Night"), tr("Dark"), {}, "night");
    sun = make(tr("Sun"), tr("Black and white, thick lines"), {}, "sun");
    larger_text = make(tr("Larger text"), {}, QKeySequence::ZoomIn);
    smaller_text = make(tr("Smaller text"), {}, QKeySequence::ZoomOut);

    snap->setCheckable(true);
    auto* const tools = new QActionGroup(this);
    tools->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction* tool : {drag_turns, zoom_box, mark}) {
        tool->setCheckable(true);
        tools->addAction(tool);
    }
    auto* const palettes = new QActionGroup(this);
    for (QAction* palette : {day, night, sun}) {
        palette->setCheckable(true);
        palettes->addAction(palette);
    }
    focus->setCheckable(true);
    pause_camera->setCheckable(true);
    recentre->setCheckable(true);
    click_turns->setCheckable(true);
    sounds->setCheckable(true);
}

QAction* FieldActions::make(const QString& text, const QString& tip, const QKeySequence& key,
                            const char* icon) {
    auto* const action = new QAction(text, this);
    action->setShortcut(key);
    action->setAutoRepeat(false);  // a key held down must not queue moves
    action->setToolTip(
        key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
    action->setStatusTip(tip);
    if (icon != nullptr) {
        action->setIcon(lineIcon(QString::fromLatin1(icon)));
    }
    window_->addAction(action);
    all_.append(action);
    return action;
}

QList<QAction*> FieldActions::withKeys() const {
    QList<QAction*> keyed;
    std::ranges::copy_if(all_, std::back_inserter(keyed),
                         [](const QAction* action) { return !action->shortcut().isEmpty(); });
    return keyed;
}

bool belongsToField(int key, Qt::KeyboardModifiers modifiers) {
    if (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        return false;
    }
    return key != Qt::Key_Escape && !(key >= Qt::Key_F1 && key <= Qt::Key_F35);
}

}  // namespace pmts::gui
