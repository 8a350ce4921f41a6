#pragma once

#include "window/listed_page.hpp"
#include "pmts/app/line/axis_test_presenter.hpp"
#include "pmts/app/line/two_face_presenter.hpp"

#include <QPointer>
#include <QTimer>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QMessageBox;
class QPushButton;

namespace pmts::gui {

class StateLamp;

/// What is known of the instrument itself at the left, its tests beside it: collimation and index, a point in two faces.
class InstrumentPage : public ListedPage {
    Q_OBJECT
public:
    InstrumentPage(app::InstrumentHealth& health, app::AxisTestPresenter& axis_test, app::TwoFacePresenter& faces,
                   QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Instrument"); }
    void entered() override;
    void left() override;

private:
    struct Row {
        StateLamp* lamp;
        QLabel* text;
        QLabel* details;
    };
    QWidget* makeState();
    QWidget* makeTargetTest();
    Row makeRow(const QString& name, const char* object_name, QGridLayout& grid);
    static void show(const Row& row, const app::StatusItem& item);
    void showAll();
    void askBeforeCalibration();
    void askForInstrument();
    void endQuestion();
    void keepTargetTest();
    void editLimits();

    app::InstrumentHealth& health_;
    app::AxisTestPresenter& axis_test_;
    Row face_{}, compensator_{}, battery_{}, level_{}, air_{};
    QPushButton* switch_;
    QPushButton* calibrate_;
    QPushButton* cancel_;
    QCheckBox* test_on_;
    QDoubleSpinBox* test_mgon_;
    QDoubleSpinBox* test_cm_;
    QPointer<QMessageBox> question_;  ///< of the instrument, while it waits for yes or no
    QTimer refresh_;  ///< the ages of what is known
};

}  // namespace pmts::gui
