#include "sounds.hpp"

#include <QApplication>
#include <QTimer>

namespace pmts::gui {
namespace {

constexpr int kBetweenBeeps_ms = 180;

int beepsFor(app::Cue cue) {
    switch (cue) {
        case app::Cue::kArrived:
            return 1;
        case app::Cue::kRecorded:
            return 2;
        case app::Cue::kFailed:
            break;
    }
    return 3;
}

}  // namespace

void Sounds::play(app::Cue cue) {
    if (!on_) {
        return;
    }
    for (int beep = 0; beep < beepsFor(cue); ++beep) {
        QTimer::singleShot(beep * kBetweenBeeps_ms, this, [] { QApplication::beep(); });
    }
}

}  // namespace pmts::gui
