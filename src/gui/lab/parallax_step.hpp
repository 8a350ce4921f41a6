#pragma once

#include "lab_panel.hpp"
#include "pmts/app/lab/parallax_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <vector>

class QButtonGroup;
class QCheckBox;
class QPushButton;

namespace pmts::gui {

class QuantityEdit;

/// The two boards at D and 2D, steps a to k.
class ParallaxStep : public LabPanel {
    Q_OBJECT
public:
    ParallaxStep(app::ParallaxPresenter& parallax, const app::Preferences& preferences, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Parallax"); }
    void entered() override { showAll(); }
    bool pictureClicked(const QPointF& frame_px) override;
    [[nodiscard]] bool wantsClearCentre() const override { return parallax_.wantsClick(); }
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void buildCase();
    void buildStages();
    void takeCase();
    void showAll();
    void showSteps();

    app::ParallaxPresenter& parallax_;
    const app::Preferences& preferences_;
    QCheckBox *x_, *y_, *z_, *others_;
    QButtonGroup* stages_;
    QPushButton *measure_, *accept_, *again_;
    QuantityEdit* distance_;
    QLabel *advice_, *gap_, *offsets_, *proof_, *steps_;
};

}  // namespace pmts::gui
