#pragma once

#include "lab_panel.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/lab/twist_presenter.hpp"

class QPushButton;

namespace pmts::gui {

class QuantityEdit;

/// Twist removal with a plumb line: the twist in large digits, which way to turn, the proof.
class TwistStep : public LabPanel {
    Q_OBJECT
public:
    TwistStep(app::TwistPresenter& twist, const app::Preferences& preferences, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Twist"); }
    void entered() override { twist_.setActive(true); }
    void left() override { twist_.setActive(false); }
    bool pictureClicked(const QPointF& frame_px) override;
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void showAll();

    app::TwistPresenter& twist_;
    const app::Preferences& preferences_;
    QLabel *value_, *quality_, *proof_;
    QuantityEdit* tolerance_;
    QPushButton *verify_, *accept_;
};

}  // namespace pmts::gui
