#pragma once

#include "pmts/app/line/axis_test_presenter.hpp"

#include <QWidget>

class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

class StateLamp;

/// Collimation and index test: the next step in words, the pairs taken, the result, and the test that is kept.
class AxisTestPanel : public QWidget {
    Q_OBJECT
public:
    explicit AxisTestPanel(app::AxisTestPresenter& test, QWidget* parent = nullptr);

private:
    QLayout* makeTemperature();
    void showAll();

    app::AxisTestPresenter& test_;
    StateLamp* kept_lamp_;
    QLabel* kept_;
    StateLamp* lamp_;
    QLabel* instruction_;
    QTableWidget* table_;
    QLabel* result_;
    QLineEdit* temperature_;
    QLabel* temperature_text_;
    QPushButton* take_;
    QPushButton* turn_;
    QPushButton* accept_;
    QPushButton* discard_;
    QPushButton* cancel_;
};

}  // namespace pmts::gui
