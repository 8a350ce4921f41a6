#pragma once

#include "image_view.hpp"
#include "pmts/app/live_presenter.hpp"
#include "pmts/app/targeting_presenter.hpp"

namespace pmts::gui {

/// The frozen picture with its HA and VA; everything is drawn over it at the pointing it was taken with.
class StillView : public ImageView {
    Q_OBJECT
public:
    explicit StillView(app::LivePresenter& live, QWidget* parent = nullptr);
    void selectPoint(qint64 row_id);

Q_SIGNALS:
    void overlayChanged();

private:
    void showStill();
    void showWaiting(const QString& reason);

    app::LivePresenter& live_;
    qint64 selected_row_id_ = 0;
};

}  // namespace pmts::gui
