#pragma once

#include "pmts/app/lab/camera_presenter.hpp"

#include <QObject>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace pmts::gui {

/// One control of the camera as a row of a grid: name, slider, number and Auto.
class ControlRow : public QObject {
    Q_OBJECT
public:
    ControlRow(app::CameraPresenter& camera, const app::ControlRow& row, QGridLayout& grid, int at, QWidget* parent);

    void showRow(const app::ControlRow& row);

private:
    void buildValue(const app::ControlRow& row, QGridLayout& grid, int at, QWidget* parent);
    [[nodiscard]] int tickOf(double value) const;
    [[nodiscard]] double valueOf(int tick) const;

    app::CameraPresenter& camera_;
    video::ControlRange range_;
    QLabel* name_;
    QCheckBox* automatic_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* number_ = nullptr;
};

}  // namespace pmts::gui
