#include "plot_widget.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/gui/theme.hpp"

#include <QBuffer>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QSvgGenerator>
#include <QToolTip>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kMargin = 0.04;  ///< of the frame's width, around it
constexpr QSize kSaved_px(1000, 700);
constexpr int kLegendIcon_px = 32;
constexpr double kBitmapScale = 2.0;

}  // namespace

PlotLook screenLook() {
    const Theme& theme = currentTheme();
    return {theme.field, theme.text, theme.border, theme.accent, theme.text, theme.line_px};
}

PlotLook paperLook() { return {Qt::white, Qt::black, QColor(0xb0, 0xb0, 0xb0), QColor(0x1b, 0x5e, 0xa8), Qt::black, 1.0}; }

double roundBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

QString csvCell(QString text) { return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"'; }

PlotWidget::PlotWidget(QString file_name, QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), said_(new QLabel(this)), file_name_(std::move(file_name)), look_(screenLook()) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(plot_, 1);
    column->addWidget(said_);
    said_->setObjectName(QStringLiteral("plot_said"));
    said_->setWordWrap(true);
    said_->hide();
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);  // else the wheel would not scroll the panel around it
    setMouseTracking(true);
    connect(plot_, &QCustomPlot::afterLayout, this, &PlotWidget::keepSquarePixels);
}

void PlotWidget::setNotice(const QString& why_empty) { notice_ = why_empty; }

void PlotWidget::setLook(const PlotLook& look) {
    look_ = look;
    follows_palette_ = false;
    redraw();
}

void PlotWidget::redraw() {
    plot_->clearPlottables();
    plot_->clearItems();
    square_px_.reset();
    is_empty_ = false;
    styleAxes();
    styleLegend();
    draw();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotWidget::styleAxes() {
    plot_->setBackground(look_.ground);
    plot_->axisRect()->setVisible(true);
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setVisible(true);
        axis->grid()->setVisible(true);
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
        axis->ticker()->setTickCount(4);
        axis->setBasePen(QPen(look_.text, look_.line_px));
        axis->setTickPen(QPen(look_.text, look_.line_px));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(look_.text);
        axis->setLabelColor(look_.text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(look_.grid, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(look_.grid, 1, Qt::DotLine));
        axis->setRangeReversed(false);
    }
}

void PlotWidget::styleLegend() {
    QCPLegend* const legend = plot_->legend;
    legend->setVisible(false);
    legend->setBrush(look_.ground);
    legend->setTextColor(look_.text);
    legend->setBorderPen(QPen(look_.grid, look_.line_px));
    legend->setFont(font());
    legend->setIconSize(kLegendIcon_px, QFontMetrics(font()).height());
}

void PlotWidget::addArrow(const QPointF& from, const QPointF& to, const QPen& pen) {
    auto* const arrow = new QCPItemLine(plot_);
    arrow->start->setCoords(from);
    arrow->end->setCoords(to);
    arrow->setPen(pen);
    arrow->setHead(QCPLineEnding(QCPLineEnding::esSpikeArrow, 6, 8));
}

QCPGraph* PlotWidget::addDots(const QVector<double>& x, const QVector<double>& y, const QCPScatterStyle& style) {
    QCPGraph* const dots = plot_->addGraph();
    dots->setData(x, y);
    dots->setLineStyle(QCPGraph::lsNone);
    dots->setScatterStyle(style);
    return dots;
}

void PlotWidget::drawFrame(const QSize& frame_px, const QString& columns) {
    auto* const frame = new QCPItemRect(plot_);
    frame->topLeft->setCoords(-0.5, -0.5);
    frame->bottomRight->setCoords(frame_px.width() - 0.5, frame_px.height() - 0.5);
    frame->setPen(QPen(look_.text, look_.line_px));
    frame->setBrush(Qt::NoBrush);
    plot_->xAxis->setLabel(columns);
    plot_->yAxis->setLabel(tr("Row [px]"));
    plot_->yAxis->setRangeReversed(true);
    square_px_ = frame_px;
}

void PlotWidget::drawNotice() {
    is_empty_ = true;
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setVisible(false);
        axis->grid()->setVisible(false);
    }
    auto* const notice = new QCPItemText(plot_);
    notice->setClipToAxisRect(false);
    notice->position->setType(QCPItemPosition::ptViewportRatio);
    notice->position->setCoords(0.5, 0.5);
    notice->setText(notice_);
    notice->setColor(look_.text);
    notice->setFont(font());
}

/// The whole frame with a margin, at every size the plot is laid out in. The ticks' labels share the room with it: once more
/// for those of the new range.
void PlotWidget::keepSquarePixels() {
    if (!square_px_) {
        return;
    }
    fitFrame();
    for (const auto phase : {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout}) {
        plot_->plotLayout()->update(phase);
    }
    fitFrame();
}

void PlotWidget::fitFrame() {
    const QSize room = plot_->axisRect()->size();
    if (room.isEmpty()) {
        return;
    }
    const double margin = kMargin * square_px_->width();
    plot_->xAxis->setRange(-margin, square_px_->width() + margin);
    plot_->yAxis->setRange(-margin, square_px_->height() + margin);
    if (plot_->xAxis->range().size() / room.width() > plot_->yAxis->range().size() / room.height()) {
        plot_->yAxis->setScaleRatio(plot_->xAxis, 1.0);
    } else {
        plot_->xAxis->setScaleRatio(plot_->yAxis, 1.0);
    }
}

QPicture PlotWidget::picture(const QSize& size) {
    QPicture drawn;
    QCPPainter painter;
    painter.begin(&drawn);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot_->toPainter(&painter, size.width(), size.height());
    painter.end();
    plot_->replot(QCustomPlot::rpQueuedReplot);  // the layout of the screen again
    return drawn;
}

QByteArray PlotWidget::drawing() {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator file;
    file.setOutputDevice(&buffer);
    file.setResolution(logicalDpiX());
    file.setSize(kSaved_px);
    file.setViewBox(QRect(QPoint(), kSaved_px));
    QCPPainter painter(&file);
    plot_->toPainter(&painter, kSaved_px.width(), kSaved_px.height());
    painter.end();
    return bytes;
}

QByteArray PlotWidget::bitmap() {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    plot_->toPixmap(kSaved_px.width(), kSaved_px.height(), kBitmapScale).save(&buffer, "PNG");
    return bytes;
}

core::Result<void> PlotWidget::write(const QString& path) {
    if (path.endsWith(QLatin1String(".csv"))) {
        return app::writeWhole(path, csv().toUtf8());
    }
    const PlotLook on_screen = std::exchange(look_, paperLook());
    redraw();
    const QByteArray bytes = path.endsWith(QLatin1String(".svg")) ? drawing() : bitmap();
    look_ = on_screen;
    redraw();
    return app::writeWhole(path, bytes);
}

void PlotWidget::save(const QString& path) {
    const auto written = write(path);
    said_->setText(written ? tr("“%1” is written.").arg(QDir::toNativeSeparators(path)) : written.error().sentence());
    said_->show();
}

void PlotWidget::ask(const QString& heading, const QString& filters) {
    const auto ending_of = [](const QString& filter) { return filter.section(u'*', 1).section(u')', 0, 0); };  // "Picture (*.png)"
    QString chosen = filters;
    QString path = QFileDialog::getSaveFileName(this, heading, file_name_ + ending_of(filters), filters, &chosen);
    if (path.isEmpty()) {
        return;
    }
    if (!filters.contains(QStringLiteral("*.%1)").arg(QFileInfo(path).suffix()))) {
        path += ending_of(chosen);
    }
    save(path);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save picture…"), this, [this] { ask(tr("Save picture"), tr("Picture (*.png);;Drawing (*.svg)")); });
    menu->addAction(tr("Save values…"), this, [this] { ask(tr("Save values"), tr("Values (*.csv)")); });
    menu->popup(event->globalPos());
}

QString PlotWidget::textAt(const QPoint&) const { return {}; }

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
    QToolTip::showText(event->globalPosition().toPoint(), textAt(plot_->mapFrom(this, event->position().toPoint())), this);
}

void PlotWidget::mousePressEvent(QMouseEvent* event) {
    said_->hide();
    QWidget::mousePressEvent(event);
}

void PlotWidget::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    const bool other_look = event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (other_look && follows_palette_) {
        look_ = screenLook();
        redraw();
    }
}

}  // namespace pmts::gui
