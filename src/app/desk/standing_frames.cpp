#include "pmts/app/desk/standing_frames.hpp"

namespace pmts::app {

StandingFrames::StandingFrames(LivePresenter& live, const InstrumentDesk& instrument, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument) {
    connect(&live_, &LivePresenter::sceneChanged, this, &StandingFrames::follow);
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &StandingFrames::follow);
}

void StandingFrames::setWanted(bool wanted) {
    wanted_ = wanted;
    startAfresh();
}

void StandingFrames::startAfresh() {
    candidate_.reset();
    last_ = live_.scene().frame;
}

void StandingFrames::follow() {
    if (!wanted_ || instrument_.isTurning()) {
        return candidate_.reset();
    }
    const auto tracked = candidate_ ? instrument_.track().at(candidate_->captured_at) : std::nullopt;
    if (tracked && tracked->settled) {
        auto frame = std::make_shared<camera::Frame>(*candidate_);  // shares the pixels
        frame->pointing = tracked->pointing;
        last_ = std::exchange(candidate_, nullptr);
        Q_EMIT stood(frame);
    }
    const auto newest = instrument_.track().newest();
    const bool is_void = candidate_ && newest && newest->at >= candidate_->captured_at;  // moving: nothing confirms it any more
    if ((!candidate_ || is_void) && live_.scene().frame && live_.scene().frame != last_) {
        candidate_ = live_.scene().frame;
    }
}

}  // namespace pmts::app
