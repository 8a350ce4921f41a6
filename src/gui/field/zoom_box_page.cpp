#include "zoom_box_page.hpp"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace pmts::gui {

void PartView::setPart(const QRectF& part_px) {
    part_px_ = part_px;
    fit();
    setCenter(part_px.center());
}

double PartView::unzoomedScale() const {
    return part_px_.isEmpty() ? ImageView::unzoomedScale()
                              : std::min(width() / part_px_.width(), height() / part_px_.height());
}

ZoomBoxPage::ZoomBoxPage(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), view_(new PartView(this)) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    title_->setContentsMargins(6, 4, 6, 4);
    column->addWidget(title_);
    column->addWidget(view_, 1);
    view_->setObjectName(QStringLiteral("zoom_box_view"));
    view_->setAccessibleName(tr("Zoom box"));
    view_->setNotice(tr("No zoom box yet. Press B and drag a box in a picture."));
}

void ZoomBoxPage::open(app::Picture picture, const QRectF& box_px) {
    picture_ = picture;
    has_box_ = true;
    const QString of = picture == app::Picture::kLive ? tr("live view") : tr("still");
    title_->setText(
        tr("%1 x %2 pixels of the %3").arg(qRound(box_px.width())).arg(qRound(box_px.height())).arg(of));
    view_->setNotice({});
    view_->setPart(box_px);
}

void ZoomBoxPage::show(const camera::FramePtr& frame, const ImageOverlay& overlay) {
    view_->setFrame(frame);
    view_->setOverlay(overlay);
}

}  // namespace pmts::gui
