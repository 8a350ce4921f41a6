#pragma once

#include "lab_step.hpp"
#include "pmts/app/lab/board_presenter.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace pmts::gui {

/// Views of a printed board as a second opinion on the lens.
class BoardStep : public LabStep {
    Q_OBJECT
public:
    explicit BoardStep(app::BoardPresenter& board, QWidget* parent = nullptr);
    [[nodiscard]] QString title() const override { return tr("Boards"); }
    void left() override;
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void addPattern(QVBoxLayout& column);
    void takePattern();
    void showAll();
    void print();

    app::BoardPresenter& board_;
    QComboBox* kind_;
    QSpinBox *columns_, *rows_;
    QDoubleSpinBox* square_mm_;
    QLabel *sentence_, *verdict_;
    QListWidget* views_;
    QPlainTextEdit* result_;
    QPushButton *look_, *calibrate_, *accept_;
};

}  // namespace pmts::gui
