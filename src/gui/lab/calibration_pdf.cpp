#include "calibration_pdf.hpp"

#include "calibration_plots.hpp"
#include "parts/pdf_sheet.hpp"
#include "pmts/app/desk/whole_file.hpp"

#include <QCoreApplication>

namespace pmts::gui {
namespace {

constexpr double kHeading = 60;  ///< above a plot, dots
constexpr double kNotice = 40;   ///< of a plot without values

QString say(const char* text) { return QCoreApplication::translate("CalibrationPdf", text); }

app::TextTable parametersOf(const app::CalibrationReport& report) {
    app::TextTable table{.header = {say("Parameter"), say("Value"), say("Standard deviation")}, .rows = {}};
    for (const auto& parameter : report.parameters) {
        table.rows.push_back({parameter.name, parameter.value, parameter.deviation.isEmpty() ? say("not determined or fixed") : parameter.deviation});
    }
    table.plain_rows = static_cast<int>(table.rows.size());
    return table;
}

app::TextTable checksOf(const app::CalibrationReport& report) {
    app::TextTable table{.header = {say("Date"), say("Point"), say("Result"), say("State")}, .rows = {}};
    for (const auto& check : report.checks) {
        table.rows.push_back({check.date, check.target, check.result, check.state});
    }
    table.plain_rows = static_cast<int>(table.rows.size());
    return table;
}

void writeTexts(PdfSheet& sheet, const app::CalibrationReport& report) {
    sheet.paragraph(say("Calibration report"), 18, true);
    sheet.paragraph(report.title, 13, true);
    for (const auto& [name, value] : report.facts) {
        sheet.pair(name, value);
    }
    sheet.paragraph(say("Parameters"), 12, true);
    sheet.table(parametersOf(report));
    sheet.paragraph(report.compared, 9);
    sheet.paragraph(say("Checks"), 12, true);
    if (report.checks.empty()) {
        sheet.paragraph(say("Never checked against a known point."), 9);
    } else {
        sheet.table(checksOf(report));
    }
}

}  // namespace

core::Result<void> writeCalibrationPdf(const app::CalibrationReport& report, const QString& path) {
    const auto paper = PdfSheet::open(path, say("Calibration report"));
    if (!paper) {
        return tl::unexpected(paper.error());
    }
    PdfSheet& sheet = **paper;
    writeTexts(sheet, report);
    QWidget holder;
    CalibrationPlots plots(&holder);
    plots.show(report);
    const double half = sheet.height() / 2 - kHeading;
    sheet.newPage();
    for (const auto& [heading, plot] : plots.all()) {
        const double tall = plot->isEmpty() ? kNotice : half;
        sheet.makeRoom(kHeading + tall);
        sheet.paragraph(heading, 11, true);
        sheet.plot(*plot, tall);
    }
    return sheet.finish();
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
    QSaveFile kept(path);
    if (!kept.open(QIODevice::WriteOnly)) {
        return app::cannotWrite(path, kept.errorString());
    }
    QPdfWriter file(&kept);
    file.setPageSize(QPageSize(holds(QPageSize::A4) ? QPageSize::A4 : QPageSize::A3));
    file.setPageOrientation(lies ? QPageLayout::Landscape : QPageLayout::Portrait);
    file.setPageMargins(QMarginsF(0, 0, 0, 0));
    file.setResolution(600);
    file.setTitle(say("Calibration board"));
    QPainter painter(&file);
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
    if (!painter.end() || !kept.commit()) {
        return app::cannotWrite(path, kept.errorString());
    }
    return {};
}

}  // namespace pmts::gui
