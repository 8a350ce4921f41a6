#include "painted_icon.hpp"

#include <QIconEngine>
#include <QPainter>
#include <QPixmap>

#include <utility>

namespace pmts::gui {
namespace {

class PaintedIconEngine final : public QIconEngine {
public:
    explicit PaintedIconEngine(PaintIcon paint_icon) : paint_icon_(std::move(paint_icon)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        paint_icon_(*painter, rect, mode, state);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return image;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new PaintedIconEngine(paint_icon_); }

private:
    PaintIcon paint_icon_;
};

}  // namespace

QIcon paintedIcon(PaintIcon paint) { return QIcon(new PaintedIconEngine(std::move(paint))); }

}  // namespace pmts::gui
