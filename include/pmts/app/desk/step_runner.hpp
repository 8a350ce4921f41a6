#pragma once

#include "pmts/app/field/targeting_presenter.hpp"
#include "pmts/core/clock.hpp"

#include <QObject>

#include <optional>

namespace pmts::app {

/// Arrow keys and buttons: one press is one step, held longer than kHold they run. While running the next step is sent
/// when the last one has arrived, so that nothing queues up and releasing ends it within one step.
class StepRunner : public QObject {
    Q_OBJECT
public:
    static constexpr core::Duration kHold = std::chrono::milliseconds(400);
    /// Some screens repeat a held key as release and press: a press this soon after a release is such a repeat.
    static constexpr core::Duration kKeyGap = std::chrono::milliseconds(40);

    StepRunner(TargetingPresenter& targeting, core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] bool isRunning() const { return running_; }

public Q_SLOTS:
    void keyPressed(pmts::app::Direction direction);     ///< a step at once; runs when held
    void buttonPressed(pmts::app::Direction direction);  ///< nothing yet; runs when held
    /// A step by a button's click or the menu; not the click that ends a run.
    void step(pmts::app::Direction direction);
    void keyReleased();
    void released();  ///< a button, or everything: nothing runs any more

private:
    void hold(Direction direction);
    void startRunning();
    void goOn();

    TargetingPresenter& targeting_;
    core::Clock& clock_;
    core::Timer held_long_;
    core::Timer let_go_;
    bool letting_go_ = false;  ///< the key came up just now
    std::optional<Direction> direction_;  ///< of what is pressed
    bool running_ = false;
};

}  // namespace pmts::app
