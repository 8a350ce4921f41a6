#include "report_pdf.hpp"

#include "error_plot.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <numeric>

namespace pmts::gui {
namespace {

constexpr int kResolution_dpi = 144;
constexpr double kGap = 14.0;
constexpr double kCellGap = 10.0;

QString say(const char* text) { return QCoreApplication::translate("ReportPdf", text); }

/// Writes from the top of a page down.
class Paper {
public:
    explicit Paper(QPdfWriter& file) : file_(file), painter_(&file), page_(0, 0, file.width(), file.height()) {
        painter_.setPen(Qt::black);
    }
    [[nodiscard]] bool isOpen() const { return painter_.isActive(); }

    void newPage() {
        file_.newPage();
        top_ = 0;
    }
    void paragraph(const QString& text, double points, bool bold = false) {
        if (text.isEmpty()) {
            return;
        }
        painter_.setFont(fontOf(points, bold));
        const QRectF room(0, top_, page_.width(), page_.height() - top_);
        QRectF used;
        painter_.drawText(room, Qt::TextWordWrap, text, &used);
        top_ += used.height() + kGap / 3;
    }
    void table(const app::TextTable& table) {
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
    void plot(ErrorPlot& plot, double height) {
        const QSize size(static_cast<int>(page_.width() / kPlotScale), static_cast<int>(height / kPlotScale));
        painter_.save();
        painter_.translate(0, top_);
        const QPicture drawn = plot.picture(size);
        // drawPicture() itself scales from the picture's resolution to the paper's.
        const double scale = kPlotScale * drawn.logicalDpiX() / file_.logicalDpiX();
        painter_.scale(scale, scale);
        painter_.drawPicture(0, 0, drawn);
        painter_.restore();
        top_ += height + kGap;
    }
    [[nodiscard]] double roomLeft() const { return page_.height() - top_; }

private:
    static constexpr double kPlotScale = 1.3;  ///< letters of the plots as large as those of the tables

    [[nodiscard]] QFont fontOf(double points, bool bold) const {
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPointSizeF(points);
        font.setBold(bold);
        return font;
    }
    /// The last column may wrap: it is what is left of the page, or its text.
    [[nodiscard]] std::vector<double> widthsOf(const app::TextTable& table, double points) const {
        const QFontMetricsF metrics(fontOf(points, true), &file_);
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
    [[nodiscard]] double fittingPoints(const app::TextTable& table) const {
        double points = 9.0;
        const auto total = [&] {
            const std::vector<double> widths = widthsOf(table, points);
            return std::accumulate(widths.begin(), widths.end(), 0.0);
        };
        while (points > 4.0 && total() > page_.width()) {
            points -= 0.25;
        }
        return points;
    }
    void row(const QStringList& cells, const std::vector<double>& widths, double points, bool bold) {
        painter_.setFont(fontOf(points, bold));
        const double height = QFontMetricsF(painter_.font(), &file_).height() * 1.25;
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
    void line() { painter_.drawLine(QPointF(0, top_), QPointF(page_.width(), top_)); }

    QPdfWriter& file_;
    QPainter painter_;
    QRectF page_;
    double top_ = 0;
};

void writeMethod(Paper& paper, const app::MethodPage& page, const app::MethodReportView& report) {
    paper.newPage();
    paper.paragraph(page.title, 14, true);
    paper.paragraph(page.setting, 9);
    paper.paragraph(page.known_error, 9);
    paper.paragraph(page.off_printed, 9);
    paper.table(page.table);
    if (page.errors.empty()) {
        return;
    }
    ErrorPlot bars, vectors;
    bars.setLook(paperLook());
    vectors.setLook(paperLook());
    bars.showBars(page, report.plot_unit);
    vectors.showVectors(page, report.image_px, report.plot_unit);
    const double each = (paper.roomLeft() - 2 * kGap) / 2;
    paper.plot(bars, std::max(each, 120.0));
    paper.plot(vectors, std::max(each, 120.0));
}

}  // namespace

core::Result<void> writeReportPdf(const app::MethodReportView& report, const QString& path) {
    const auto refused = [&path] {
        return core::fail(core::ErrorKind::kFile, say("“%1” cannot be written.").arg(path), say("Choose another folder."));
    };
    if (QFile probe(path); !probe.open(QIODevice::WriteOnly)) {
        return refused();
    }
    QPdfWriter file(path);
    file.setPageSize(QPageSize(QPageSize::A4));
    file.setPageMargins(QMarginsF(15, 15, 15, 15), QPageLayout::Millimeter);
    file.setResolution(kResolution_dpi);
    file.setTitle(say("Method report"));
    file.setCreator(QStringLiteral("PMTS"));
    Paper paper(file);
    if (!paper.isOpen()) {
        return refused();
    }
    paper.paragraph(say("Method report"), 18, true);
    paper.paragraph(report.head, 10);
    paper.paragraph(say("Errors are computed less observed."), 10);
    paper.table(report.summary);
    for (const QString& line : report.fit) {
        paper.paragraph(line, 9);
    }
    for (const app::MethodPage& page : report.pages) {
        writeMethod(paper, page, report);
    }
    return {};
}

}  // namespace pmts::gui
