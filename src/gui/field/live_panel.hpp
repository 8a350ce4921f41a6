#pragma once

#include "image_view.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"

#include <QWidget>

#include <memory>

namespace Ui {
class ViewBar;
}

namespace pmts::gui {

class FieldActions;
class ProgressOverlay;
class Toast;

/// What the presenters say is drawn over a picture, as the view paints it.
[[nodiscard]] ImageOverlay overlayOf(const std::vector<app::OverlayItem>& items,
                                     const std::optional<QPointF>& reticle_px, qint64 selected_row_id,
                                     const QString& target_note);
void addParallax(ImageOverlay& overlay, const app::ParallaxCurve& curve);

/// The live view with its bar: range, rate, tools, zoom, points on or off, near and far. PictureInput does the clicks.
class LivePanel : public QWidget {
    Q_OBJECT
public:
    LivePanel(app::LivePresenter& live, app::TargetingPresenter& targeting, QWidget* parent = nullptr);
    ~LivePanel() override;

    void setActions(const FieldActions& actions);
    [[nodiscard]] ImageView& view() const { return *view_; }
    /// Without the tools that belong to the field's pages: zoom box and marks.
    void hideFieldTools();
    /// Reticle and parallax curve, off while what lies under them must be seen.
    void setReticleShown(bool shown);
    void selectPoint(qint64 row_id);
    void showToast(const QString& text);
    void showBusy(bool busy, const QString& text, double fraction);

Q_SIGNALS:
    void cancelRequested();
    void rangeRequested();
    void depthRequested(const QWidget& button);
    void overlayChanged();

private:
    void wireView();
    void showScene();
    void showStatistics(const app::LiveStatistics& statistics);
    void showCameraStatus();

    app::LivePresenter& live_;
    app::TargetingPresenter& targeting_;
    std::unique_ptr<Ui::ViewBar> bar_;
    ImageView* view_;
    Toast* toast_;
    ProgressOverlay* progress_;
    qint64 selected_row_id_ = 0;
    bool reticle_shown_ = true;
};

}  // namespace pmts::gui
