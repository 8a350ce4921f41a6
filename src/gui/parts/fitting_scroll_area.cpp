#include "fitting_scroll_area.hpp"

#include <QEvent>

namespace pmts::gui {
namespace {

constexpr int kRoomyLines = 46;  ///< lines of text a window needs to show everything at once
constexpr int kLeastHeight_px = 84;

}  // namespace

FittingScrollArea::FittingScrollArea(QWidget* contents, QWidget* parent) : QScrollArea(parent) {
    setWidget(contents);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setFocusPolicy(Qt::NoFocus);
}

QSize FittingScrollArea::sizeHint() const { return widget()->sizeHint(); }

QSize FittingScrollArea::minimumSizeHint() const {
    const QSize whole = widget()->minimumSizeHint();
    const bool roomy = window()->height() >= kRoomyLines * fontMetrics().height();
    return {whole.width(), roomy ? whole.height() : std::min(whole.height(), kLeastHeight_px)};
}

bool FittingScrollArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry();
    }
    return QScrollArea::eventFilter(watched, event);
}

}  // namespace pmts::gui
