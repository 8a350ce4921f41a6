#include "calibration_pdf.hpp"

#include "calibration_plot.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kResolution_dpi = 144;
constexpr double kPage_mm = 15;

QString say(const char* text) { return QCoreApplication::translate("CalibrationPdf", text); }

tl::unexpected<core::Error> cannotWrite(const QString& path) {
    return core::fail(core::ErrorKind::kFile, say("“%1” cannot be written.").arg(path), say("Choose another folder."));
}

bool canWrite(const QString& path) {
    QFile probe(path);
    return probe.open(QIODevice::WriteOnly);
}

/// Writes from the top of a page down; a new page when the room is used up.
class Sheet {
public:
    explicit Sheet(QPdfWriter& file) : file_(file), painter_(&file), width_(file.width()), height_(file.height()) {}
    [[nodiscard]] QPainter& painter() { return painter_; }
    [[nodiscard]] bool isOpen() const { return painter_.isActive(); }

    void paragraph(const QString& text, double points, bool bold = false) {
        useFont(points, bold);
        const QRectF used = painter_.boundingRect(QRectF(0, 0, width_, 10000), Qt::TextWordWrap, text);
        makeRoom(used.height());
        painter_.drawText(QRectF(0, top_, width_, used.height() + 4), Qt::TextWordWrap, text);
        top_ += used.height() + 6;
    }
    void row(const QStringList& cells, const std::vector<double>& shares, bool bold = false) {
        useFont(9, bold);
        double tallest = 0;
        double left = 0;
        std::vector<QRectF> places;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            const double wide = width_ * shares[static_cast<std::size_t>(i)];
            const QRectF used = painter_.boundingRect(QRectF(left, 0, wide - 8, 10000), Qt::TextWordWrap, cells[i]);
            tallest = std::max(tallest, used.height());
            places.emplace_back(left, 0, wide - 8, 0);
            left += wide;
        }
        makeRoom(tallest);
        for (qsizetype i = 0; i < cells.size(); ++i) {
            QRectF place = places[static_cast<std::size_t>(i)];
            place.moveTop(top_);
            place.setHeight(tallest + 4);
            painter_.drawText(place, Qt::TextWordWrap, cells[i]);
        }
        top_ += tallest + 4;
    }
    void figure(const app::CalibrationReport& report, CalibrationFigure figure, double tall) {
        paragraph(figureTitle(figure), 11, true);
        makeRoom(tall);
        useFont(8, false);
        paintFigure(painter_, QRectF(0, top_, width_, tall), report, figure, paperLook());
        top_ += tall + 16;
    }
    void newPage() {
        file_.newPage();
        top_ = 0;
    }
    [[nodiscard]] double height() const { return height_; }

private:
    void useFont(double points, bool bold) {
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPointSizeF(points);
        font.setBold(bold);
        painter_.setFont(font);
        painter_.setPen(Qt::black);
    }
    void makeRoom(double tall) {
        if (top_ > 0 && top_ + tall > height_) {
            newPage();
        }
    }

    QPdfWriter& file_;
    QPainter painter_;
    double width_, height_;
    double top_ = 0;
};

void writeTexts(Sheet& sheet, const app::CalibrationReport& report) {
    sheet.paragraph(say("Calibration report"), 18, true);
    sheet.paragraph(report.title, 13, true);
    for (const auto& [name, value] : report.facts) {
        sheet.row({name, value}, {0.25, 0.75});
    }
    sheet.paragraph(say("Parameters"), 12, true);
    sheet.row({say("Parameter"), say("Value"), say("Standard deviation")}, {0.34, 0.33, 0.33}, true);
    for (const auto& parameter : report.parameters) {
        sheet.row({parameter.name, parameter.value, parameter.deviation.isEmpty() ? say("not determined or fixed") : parameter.deviation}, {0.34, 0.33, 0.33});
    }
    if (!report.compared.isEmpty()) {
        sheet.paragraph(report.compared, 9);
    }
    sheet.paragraph(say("Checks"), 12, true);
    if (report.checks.empty()) {
        sheet.paragraph(say("Never checked against a known point."), 9);
    }
    for (const auto& check : report.checks) {
        sheet.row({check.date, check.target, check.result, check.state}, {0.24, 0.22, 0.4, 0.14});
    }
}

}  // namespace

core::Result<void> writeCalibrationPdf(const app::CalibrationReport& report, const QString& path) {
    if (!canWrite(path)) {
        return cannotWrite(path);
    }
    QPdfWriter file(path);
    file.setPageSize(QPageSize(QPageSize::A4));
    file.setPageMargins(QMarginsF(kPage_mm, kPage_mm, kPage_mm, kPage_mm), QPageLayout::Millimeter);
    file.setResolution(kResolution_dpi);
    file.setTitle(say("Calibration report"));
    file.setCreator(QStringLiteral("PMTS"));
    Sheet sheet(file);
    if (!sheet.isOpen()) {
        return cannotWrite(path);
    }
    writeTexts(sheet, report);
    const double half = sheet.height() / 2 - 60;
    sheet.newPage();
    sheet.figure(report, CalibrationFigure::kResiduals, half);
    sheet.figure(report, CalibrationFigure::kRadial, half);
    sheet.newPage();
    sheet.figure(report, CalibrationFigure::kAngleCurve, half);
    sheet.figure(report, CalibrationFigure::kWidthCurve, half);
    return {};
}

core::Result<void> writeBoardPdf(const cv::Mat& cells, double cell_mm, const QString& caption, const QString& path) {
    constexpr double kEdge_mm = 8;
    const QSizeF board_mm(cells.cols * cell_mm, cells.rows * cell_mm);
    const bool lies = board_mm.width() >= board_mm.height();
    const auto holds = [&](QPageSize::PageSizeId id) {
        QSizeF page_mm = QPageSize(id).size(QPageSize::Millimeter);
        page_mm = lies ? page_mm.transposed() : page_mm;
        return board_mm.width() + 2 * kEdge_mm <= page_mm.width() && board_mm.height() + 3 * kEdge_mm <= page_mm.height();
    };
    if (!holds(QPageSize::A3)) {
        return core::fail(core::ErrorKind::kBadInput, say("The board is %1 x %2 mm: no page holds it.").arg(board_mm.width(), 0, 'f', 0).arg(board_mm.height(), 0, 'f', 0),
                          say("Choose smaller squares or fewer of them."));
    }
    if (!canWrite(path)) {
        return cannotWrite(path);
    }
    QPdfWriter file(path);
    file.setPageSize(QPageSize(holds(QPageSize::A4) ? QPageSize::A4 : QPageSize::A3));
    file.setPageOrientation(lies ? QPageLayout::Landscape : QPageLayout::Portrait);
    file.setPageMargins(QMarginsF(0, 0, 0, 0));
    file.setResolution(600);
    file.setTitle(say("Calibration board"));
    QPainter painter(&file);
    if (!painter.isActive()) {
        return cannotWrite(path);
    }
    const double dot = 600 / 25.4;
    painter.scale(dot, dot);  // millimetres from here on
    const QSizeF page_mm(file.width() / dot, file.height() / dot);
    const QPointF corner((page_mm.width() - board_mm.width()) / 2, (page_mm.height() - board_mm.height()) / 2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::black);
    for (int row = 0; row < cells.rows; ++row) {
        for (int column = 0; column < cells.cols; ++column) {
            if (cells.at<unsigned char>(row, column) < 128) {
                painter.drawRect(QRectF(corner.x() + column * cell_mm, corner.y() + row * cell_mm, cell_mm, cell_mm));
            }
        }
    }
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(4);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(QRectF(kEdge_mm, page_mm.height() - kEdge_mm, page_mm.width() - 2 * kEdge_mm, 6), Qt::AlignCenter, caption);
    return {};
}

}  // namespace pmts::gui
