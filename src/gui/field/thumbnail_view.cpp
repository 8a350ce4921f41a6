#include "thumbnail_view.hpp"

#include "pmts/gui/theme.hpp"
#include "thumbnail_painting.hpp"

namespace pmts::gui {

ThumbnailView::ThumbnailView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ThumbnailView::showThumbnail(const app::EvidenceThumbnail& thumbnail) {
    thumbnail_ = thumbnail;
    setAccessibleName(thumbnail.caption);
    update();
}

void ThumbnailView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = currentTheme();
    painter.setPen(QPen(theme.text, theme.line_px));
    paintThumbnail(painter, QRectF(rect()).adjusted(1, 1, -1, -1), thumbnail_, 1.6 * theme.line_px);
}

}  // namespace pmts::gui
