#pragma once

#include "image_view.hpp"
#include "pmts/app/live_presenter.hpp"
#include "pmts/app/targeting_presenter.hpp"

namespace pmts::gui {

/// The frozen picture with its HA and VA. Clicks aim, double-clicks turn, at the pointing it was taken with.
class StillView : public ImageView {
    Q_OBJECT
public:
    StillView(app::LivePresenter& live, app::TargetingPresenter& targeting, QWidget* parent = nullptr);

private:
    void showStill();
    void showWaiting(const QString& reason);

    app::LivePresenter& live_;
};

}  // namespace pmts::gui
