#include "thumbnail_painting.hpp"

#include <QCoreApplication>

namespace pmts::gui {
namespace {

const QColor kHalo(0, 0, 0);
const QColor kReticle(255, 255, 255);
const QColor kSpot(255, 176, 0);
constexpr double kSpotRadius = 9.0;  ///< in widths of a stroke
constexpr double kArmFrom = 4.0;
constexpr double kArmTo = 20.0;

QRectF largestIn(const QRectF& room, const QSizeF& size) {
    QRectF place(QPointF(), size.scaled(room.size(), Qt::KeepAspectRatio));
    place.moveCenter(room.center());
    return place;
}

/// Light on dark: seen on every picture, also on a black and white print.
template <class Draw>
void withHalo(QPainter& painter, const QColor& color, double line, Draw draw) {
    painter.setPen(QPen(kHalo, 2.6 * line, Qt::SolidLine, Qt::FlatCap));
    draw();
    painter.setPen(QPen(color, line, Qt::SolidLine, Qt::FlatCap));
    draw();
}

void paintReticle(QPainter& painter, const QPointF& at, double line) {
    withHalo(painter, kReticle, line, [&] {
        for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
            painter.drawLine(at + arm * kArmFrom * line, at + arm * kArmTo * line);
        }
    });
}

void paintSpot(QPainter& painter, const QPointF& at, double line) {
    withHalo(painter, kSpot, line, [&] { painter.drawEllipse(at, kSpotRadius * line, kSpotRadius * line); });
}

}  // namespace

QRectF paintThumbnail(QPainter& painter, const QRectF& room, const app::EvidenceThumbnail& thumbnail,
                      double line) {
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.setBrush(Qt::NoBrush);
    if (thumbnail.image.isNull()) {
        const QRectF place = largestIn(room, {16, 9});
        painter.drawRect(place);
        painter.drawText(place, Qt::AlignCenter,
                         QCoreApplication::translate("EvidenceDialog", "No picture was kept."));
        painter.restore();
        return place;
    }
    const QRectF place = largestIn(room, thumbnail.image.size());
    painter.drawImage(place, thumbnail.image);
    painter.setClipRect(place);
    const double scale = place.width() / thumbnail.image.width();
    const auto placed = [&](const QPointF& px) { return place.topLeft() + (px + QPointF(0.5, 0.5)) * scale; };
    if (thumbnail.spot_px) {
        paintSpot(painter, placed(*thumbnail.spot_px), line);
    }
    if (thumbnail.reticle_px) {
        paintReticle(painter, placed(*thumbnail.reticle_px), line);
    }
    painter.restore();
    return place;
}

}  // namespace pmts::gui
