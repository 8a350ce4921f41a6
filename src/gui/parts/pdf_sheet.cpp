#include "pdf_sheet.hpp"

#include "plot_widget.hpp"
#include "pmts/app/desk/whole_file.hpp"

#include <algorithm>
#include <numeric>

namespace pmts::gui {
namespace {

constexpr int kResolution_dpi = 144;
constexpr double kMargin_mm = 15;
constexpr double kCellGap = 10.0;
constexpr double kLineHeight = 1.25;  ///< of a table's row, letters' heights
constexpr double kTable_points = 9.0;
constexpr double kLeast_points = 4.0;
constexpr double kNameShare = 0.25;
constexpr double kPlotScale = 1.3;  ///< letters of the plots as large as those of the tables

QFont fontOf(double points, bool bold) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPointSizeF(points);
    font.setBold(bold);
    return font;
}

}  // namespace

PdfSheet::PdfSheet(const QString& path) : file_(path), pdf_(&file_) {}

core::Result<std::unique_ptr<PdfSheet>> PdfSheet::open(const QString& path, const QString& title) {
    std::unique_ptr<PdfSheet> sheet(new PdfSheet(path));
    if (!sheet->file_.open(QIODevice::WriteOnly)) {
        return app::cannotWrite(path, sheet->file_.errorString());
    }
    QPdfWriter& pdf = sheet->pdf_;
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
    pdf.setResolution(kResolution_dpi);
    pdf.setTitle(title);
    pdf.setCreator(QStringLiteral("PMTS"));
    sheet->painter_.begin(&pdf);
    sheet->painter_.setPen(Qt::black);
    return sheet;
}

core::Result<void> PdfSheet::finish() {
    if (!painter_.end() || !file_.commit()) {
        return app::cannotWrite(file_.fileName(), file_.errorString());
    }
    return {};
}

void PdfSheet::newPage() {
    pdf_.newPage();
    top_ = 0;
}

void PdfSheet::makeRoom(double height) {
    if (top_ > 0 && height > roomLeft()) {
        newPage();
    }
}

void PdfSheet::paragraph(const QString& text, double points, bool bold) {
    if (text.isEmpty()) {
        return;
    }
    top_ += bold && top_ > 0 ? kGap / 2 : 0;
    painter_.setFont(fontOf(points, bold));
    const QRectF used = painter_.boundingRect(QRectF(0, 0, pdf_.width(), height()), Qt::TextWordWrap, text);
    makeRoom(used.height());
    painter_.drawText(QRectF(0, top_, pdf_.width(), used.height()), Qt::TextWordWrap | Qt::TextDontClip, text);
    top_ += used.height() + kGap / 3;
}

void PdfSheet::pair(const QString& name, const QString& value) {
    painter_.setFont(fontOf(kTable_points, false));
    const double left = kNameShare * pdf_.width();
    const QSizeF name_room(left - kCellGap, height());
    const QSizeF value_room(pdf_.width() - left, height());
    const double tall = std::max(painter_.boundingRect(QRectF({}, name_room), Qt::TextWordWrap, name).height(),
                                 painter_.boundingRect(QRectF({}, value_room), Qt::TextWordWrap, value).height());
    makeRoom(tall);
    painter_.drawText(QRectF({0, top_}, name_room), Qt::TextWordWrap, name);
    painter_.drawText(QRectF({left, top_}, value_room), Qt::TextWordWrap, value);
    top_ += tall + kGap / 4;
}

void PdfSheet::table(const app::TextTable& table) {
    const double points = fittingPoints(table);
    const std::vector<double> widths = widthsOf(table, points);
    row(table.header, widths, points, true);
    line();
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (static_cast<int>(i) == table.plain_rows) {
            line();
        }
        row(table.rows[i], widths, points, static_cast<int>(i) >= table.plain_rows);
    }
    top_ += kGap;
}

std::vector<double> PdfSheet::widthsOf(const app::TextTable& table, double points) const {
    const QFontMetricsF metrics(fontOf(points, true), &pdf_);
    std::vector<double> widths;
    for (qsizetype column = 0; column < table.header.size(); ++column) {
        double width = metrics.horizontalAdvance(table.header[column]);
        for (const QStringList& cells : table.rows) {
            width = std::max(width, metrics.horizontalAdvance(cells.value(column)));
        }
        widths.push_back(width + kCellGap);
    }
    return widths;
}

double PdfSheet::fittingPoints(const app::TextTable& table) const {
    double points = kTable_points;
    const auto total = [&] {
        const std::vector<double> widths = widthsOf(table, points);
        return std::accumulate(widths.begin(), widths.end(), 0.0);
    };
    while (points > kLeast_points && total() > pdf_.width()) {
        points -= 0.25;
    }
    return points;
}

void PdfSheet::row(const QStringList& cells, const std::vector<double>& widths, double points, bool bold) {
    painter_.setFont(fontOf(points, bold));
    const double height = QFontMetricsF(painter_.font(), &pdf_).height() * kLineHeight;
    makeRoom(height);
    double left = 0;
    for (qsizetype column = 0; column < cells.size(); ++column) {
        const QString& text = cells[column];
        const bool number = column > 0 && !text.isEmpty() && (text[0].isDigit() || text[0] == u'-');
        const double width = widths[static_cast<std::size_t>(column)];
        const QRectF cell(left, top_, width - kCellGap, height);
        painter_.drawText(cell, (number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter | Qt::TextDontClip, text);
        left += width;
    }
    top_ += height;
}

void PdfSheet::line() { painter_.drawLine(QPointF(0, top_), QPointF(pdf_.width(), top_)); }

void PdfSheet::plot(PlotWidget& plot, double height) {
    makeRoom(height);
    const QSize size(static_cast<int>(pdf_.width() / kPlotScale), static_cast<int>(height / kPlotScale));
    painter_.save();
    painter_.translate(0, top_);
    plot.setLook(paperLook());
    const QPicture drawn = plot.picture(size);
    // drawPicture() itself scales from the picture's resolution to the paper's.
    const double scale = kPlotScale * drawn.logicalDpiX() / pdf_.logicalDpiX();
    painter_.scale(scale, scale);
    painter_.drawPicture(0, 0, drawn);
    painter_.restore();
    top_ += height + kGap;
}

}  // namespace pmts::gui
