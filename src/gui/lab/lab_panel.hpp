#pragma once

#include "lab_step.hpp"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace pmts::gui {

class StateLamp;

/// What the panels of the mounting wizard have in common: a lamp with the next step in one sentence on top, the measured
/// value in large digits, buttons for gloves.
class LabPanel : public LabStep {
    Q_OBJECT
public:
    explicit LabPanel(QWidget* parent = nullptr);

protected:
    /// Lamp, sentence and the lamp in the list of steps.
    void showStep(app::DeviceState state, const QString& sentence);

    QPushButton* addButton(const QString& text, const char* object_name, QLayout* row = nullptr);
    QLabel* addText(const char* object_name = nullptr);
    QLabel* addValue(const char* object_name);  ///< large digits
    QLabel* addHeading(const QString& text);
    QHBoxLayout* addRow();
    void addStretch();
    [[nodiscard]] QVBoxLayout& column() { return *column_; }

private:
    QVBoxLayout* column_;
    StateLamp* lamp_;
    QLabel* sentence_;
    app::DeviceState state_ = app::DeviceState::kIdle;
};

}  // namespace pmts::gui
