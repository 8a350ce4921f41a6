#include "line_icon.hpp"

#include "pmts/gui/theme.hpp"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

/// A static library's resources are dropped by the linker unless somebody names them; outside every namespace
/// as Qt wants.
static void nameResources() { Q_INIT_RESOURCE(pmts); }

namespace pmts::gui {

void useResources() { nameResources(); }

namespace {

QColor strokeColor(QIcon::Mode mode, QIcon::State state) {
    const Theme& theme = currentTheme();
    if (mode == QIcon::Disabled) {
        return theme.disabled_text;
    }
    return state == QIcon::On || mode == QIcon::Selected ? theme.on_accent : theme.text;
}

QByteArray drawing(const QString& name) {
    useResources();
    QFile file(QStringLiteral(":/pmts/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        throw std::logic_error("no such icon: " + name.toStdString());
    }
    return file.readAll();
}

class LineIconEngine final : public QIconEngine {
public:
    explicit LineIconEngine(QByteArray svg) : svg_(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        QByteArray colored = svg_;
        colored.replace("#000000", strokeColor(mode, state).name().toLatin1());
        if (currentTheme().line_px > 1.0) {
            colored.replace("stroke-width=\"1.8\"", "stroke-width=\"2.4\"");
        }
        QSvgRenderer(colored).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return image;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(svg_); }

private:
    QByteArray svg_;
};

}  // namespace

QIcon lineIcon(const QString& name) { return QIcon(new LineIconEngine(drawing(name))); }

}  // namespace pmts::gui
