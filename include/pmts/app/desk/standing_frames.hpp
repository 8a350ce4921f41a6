#pragma once

#include "pmts/app/desk/live_presenter.hpp"

#include <QObject>

namespace pmts::app {

/// Pictures of the live view during which the telescope stood still, each with the circle readings of its moment: a
/// reading after it must say the same as the one before. Nothing is handed out while nobody wants any.
class StandingFrames : public QObject {
    Q_OBJECT
public:
    StandingFrames(LivePresenter& live, const InstrumentDesk& instrument, QObject* parent = nullptr);

    void setWanted(bool wanted);
    void startAfresh();  ///< only pictures that come from now on

Q_SIGNALS:
    void stood(const pmts::camera::FramePtr& frame);  ///< its `pointing` is set

private:
    void follow();

    LivePresenter& live_;
    const InstrumentDesk& instrument_;
    camera::FramePtr candidate_, last_;
    bool wanted_ = false;
};

}  // namespace pmts::app
