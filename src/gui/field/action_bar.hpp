#pragma once

#include <QWidget>

#include <memory>

namespace Ui {
class ActionBar;
}

namespace pmts::gui {

class FieldActions;

/// The bottom bar: the main job from left to right, arrows with their step, STOP.
class ActionBar : public QWidget {
    Q_OBJECT
public:
    explicit ActionBar(QWidget* parent = nullptr);
    ~ActionBar() override;

    void setActions(const FieldActions& actions);
    void showStep(const QString& step_text);

private:
    std::unique_ptr<Ui::ActionBar> ui_;
};

}  // namespace pmts::gui
