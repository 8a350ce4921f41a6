#pragma once

#include "lab_panel.hpp"
#include "pmts/app/lab/mount_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"

class QPushButton;

namespace pmts::gui {

class QuantityEdit;

/// What the camera is strapped to: the check that tilts the telescope, or the user's word.
class MountStep : public LabPanel {
    Q_OBJECT
public:
    MountStep(app::MountPresenter& mount, const app::Preferences& preferences, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Mount"); }
    void entered() override { showAll(); }
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void showAll();

    app::MountPresenter& mount_;
    const app::Preferences& preferences_;
    QLabel *verdict_, *evidence_, *profile_;
    QuantityEdit* tilt_;
    QPushButton *check_, *cancel_, *telescope_, *handle_;
};

}  // namespace pmts::gui
