#pragma once

#include "pmts/app/line/replay_presenter.hpp"

#include <QToolBar>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace pmts::gui {

/// The bar of a shown recording: play and pause, speed, place in time.
class ReplayBar : public QToolBar {
    Q_OBJECT
public:
    explicit ReplayBar(app::ReplayPresenter& replay, QWidget* parent = nullptr);

private:
    void fillSpeeds();
    void showSpeed();
    void takeSpeed();
    void wire();
    void showMoment();
    void showPlaying(bool playing);
    void showSentence(const QString& sentence);

    app::ReplayPresenter& replay_;
    QPushButton* play_;
    QComboBox* speed_;
    QSlider* place_;
    QLabel* time_;
    QLabel* said_;
};

}  // namespace pmts::gui
