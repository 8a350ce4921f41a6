#pragma once

#include "pmts/app/line/two_face_presenter.hpp"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace pmts::gui {

class StateLamp;

/// One point measured in both faces and recorded as their mean.
class TwoFacePanel : public QWidget {
    Q_OBJECT
public:
    explicit TwoFacePanel(app::TwoFacePresenter& faces, QWidget* parent = nullptr);

private:
    void showAll();
    void propose(bool done);

    app::TwoFacePresenter& faces_;
    StateLamp* lamp_;
    QLabel* instruction_;
    QLabel* outcome_;
    QLineEdit* id_;
    QString proposed_;  ///< what the program wrote into it
    QLineEdit* code_;
    QPushButton* measure_;
    QPushButton* record_;
    QPushButton* discard_;
    QPushButton* cancel_;
};

}  // namespace pmts::gui
