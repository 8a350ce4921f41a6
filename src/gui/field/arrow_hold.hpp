#pragma once

#include "pmts/app/desk/step_runner.hpp"

#include <QAction>
#include <QObject>

#include <vector>

namespace pmts::gui {

class FieldActions;

/// Tells the step runner how long arrow keys and arrow buttons are held: an action alone says only that it
/// was triggered.
class ArrowHold : public QObject {
    Q_OBJECT
public:
    /// After everything that shows the arrows as buttons has been built.
    ArrowHold(const FieldActions& actions, app::StepRunner& steps, QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Arrow {
        QAction* action;
        app::Direction direction;
    };
    void wire(const Arrow& arrow);

    app::StepRunner& steps_;
    std::vector<Arrow> arrows_;
    int key_down_ = 0;
};

}  // namespace pmts::gui
