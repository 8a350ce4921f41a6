#pragma once

#include "image_view.hpp"
#include "pmts/app/desk/live_presenter.hpp"

#include <QWidget>

class QLabel;

namespace pmts::gui {

/// A part of a picture, as large as it fits.
class PartView : public ImageView {
    Q_OBJECT
public:
    using ImageView::ImageView;

    void setPart(const QRectF& part_px);

protected:
    [[nodiscard]] double unzoomedScale() const override;

private:
    QRectF part_px_;
};

/// Routine Zoombox: the boxed part of the live picture or of the still, enlarged, live and clickable.
class ZoomBoxPage : public QWidget {
    Q_OBJECT
public:
    explicit ZoomBoxPage(QWidget* parent = nullptr);

    [[nodiscard]] PartView& view() const { return *view_; }
    [[nodiscard]] app::Picture picture() const { return picture_; }
    [[nodiscard]] bool hasBox() const { return has_box_; }
    void open(app::Picture picture, const QRectF& box_px);
    void show(const camera::FramePtr& frame, const ImageOverlay& overlay);

private:
    QLabel* title_;
    PartView* view_;
    app::Picture picture_ = app::Picture::kLive;
    bool has_box_ = false;
};

}  // namespace pmts::gui
