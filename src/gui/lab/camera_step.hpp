#pragma once

#include "control_row.hpp"
#include "lab_step.hpp"

#include <QImage>

#include <memory>
#include <vector>

namespace Ui {
class CameraStep;
}

namespace pmts::gui {

/// The first step of the laboratory: the camera runs, its exposure is right, its picture sharp, its automatics locked.
class CameraStep : public LabStep {
    Q_OBJECT
public:
    explicit CameraStep(app::CameraPresenter& camera, QWidget* parent = nullptr);
    ~CameraStep() override;

    [[nodiscard]] QString title() const override { return tr("Camera"); }
    void entered() override;
    void left() override;
    bool pictureClicked(const QPointF& frame_px) override;  ///< measures the sharpness there
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

Q_SIGNALS:
    void formatRequested();

private:
    void wire();
    void showState();
    void showControls();
    void showMeters();
    void showOptions();

    app::CameraPresenter& camera_;
    std::unique_ptr<Ui::CameraStep> ui_;
    std::vector<ControlRow*> rows_;
    QImage stripes_;  ///< over what is burnt out
    std::vector<video::ControlRange> ranges_;  ///< of the rows as they stand
};

}  // namespace pmts::gui
