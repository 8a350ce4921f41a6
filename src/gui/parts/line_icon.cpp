#include "line_icon.hpp"

#include "painted_icon.hpp"
#include "pmts/gui/theme.hpp"

#include <QFile>
#include <QPainter>
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

void paintDrawing(QPainter& painter, const QRect& rect, QByteArray svg, const QColor& color) {
    svg.replace("#000000", color.name().toLatin1());
    if (currentTheme().line_px > 1.0) {
        svg.replace("stroke-width=\"1.8\"", "stroke-width=\"2.4\"");
    }
    QSvgRenderer(svg).render(&painter, rect);
}

}  // namespace

QIcon lineIcon(const QString& name) {
    return paintedIcon([svg = drawing(name)](QPainter& painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) {
        paintDrawing(painter, rect, svg, strokeColor(mode, state));
    });
}

}  // namespace pmts::gui
