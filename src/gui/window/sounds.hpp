#pragma once

#include "pmts/app/desk/message_centre.hpp"

#include <QObject>

namespace pmts::gui {

/// The system's beep, told apart by count: arrived once, recorded twice, failed three times.
class Sounds : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    void setOn(bool on) { on_ = on; }
    void play(app::Cue cue);

private:
    bool on_ = false;
};

}  // namespace pmts::gui
