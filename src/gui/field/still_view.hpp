#pragma once

#include "image_view.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/lab/still_filters.hpp"
#include "pmts/app/field/targeting_presenter.hpp"

class QPushButton;

namespace pmts::gui {

/// The frozen picture with its HA and VA; everything is drawn over it at the pointing it was taken with.
class StillView : public ImageView {
    Q_OBJECT
public:
    StillView(app::LivePresenter& live, app::StillFilters& filters, QWidget* parent = nullptr);
    void selectPoint(qint64 row_id);

Q_SIGNALS:
    void overlayChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showStill();
    void placeFilterButton();
    void showWaiting(const QString& reason);

    app::LivePresenter& live_;
    app::StillFilters& filters_;
    QPushButton* filter_;  ///< opens the sliders
    qint64 selected_row_id_ = 0;
};

}  // namespace pmts::gui
