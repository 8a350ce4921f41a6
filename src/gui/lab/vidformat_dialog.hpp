#pragma once

#include "pmts/app/lab/camera_presenter.hpp"

#include <QDialog>

#include <memory>

namespace Ui {
class VidformatDialog;
}

namespace pmts::gui {

/// Size, pixel format and rate of the live view, and the rate that is measured (routine Vidformat). Modeless.
class VidformatDialog : public QDialog {
    Q_OBJECT
public:
    explicit VidformatDialog(app::CameraPresenter& camera, QWidget* parent = nullptr);
    ~VidformatDialog() override;

private:
    void showCamera();
    void showPixels();
    void showRates();
    void showMeasured();
    void apply();

    app::CameraPresenter& camera_;
    std::unique_ptr<Ui::VidformatDialog> ui_;
};

}  // namespace pmts::gui
