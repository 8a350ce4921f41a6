#include "report_pdf.hpp"

#include "error_plot.hpp"
#include "pdf_sheet.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr double kLeastPlot = 120.0;

QString say(const char* text) { return QCoreApplication::translate("ReportPdf", text); }

void writeMethod(PdfSheet& sheet, const app::MethodPage& page, const app::MethodReportView& report) {
    sheet.newPage();
    sheet.paragraph(page.title, 14, true);
    sheet.paragraph(page.setting, 9);
    sheet.paragraph(page.known_error, 9);
    sheet.paragraph(page.off_printed, 9);
    sheet.table(page.table);
    if (page.errors.empty()) {
        return;
    }
    ErrorPlot bars, vectors;
    bars.showBars(page, report.plot_unit);
    vectors.showVectors(page, report.image_px, report.plot_unit);
    const double each = (sheet.roomLeft() - 2 * PdfSheet::kGap) / 2;
    sheet.plot(bars, std::max(each, kLeastPlot));
    sheet.plot(vectors, std::max(each, kLeastPlot));
}

}  // namespace

core::Result<void> writeReportPdf(const app::MethodReportView& report, const QString& path) {
    const auto paper = PdfSheet::open(path, say("Method report"));
    if (!paper) {
        return tl::unexpected(paper.error());
    }
    PdfSheet& sheet = **paper;
    sheet.paragraph(say("Method report"), 18, true);
    sheet.paragraph(report.head, 10);
    sheet.paragraph(say("Errors are computed less observed."), 10);
    sheet.table(report.summary);
    for (const QString& line : report.fit) {
        sheet.paragraph(line, 9);
    }
    for (const app::MethodPage& page : report.pages) {
        writeMethod(sheet, page, report);
    }
    return sheet.finish();
}

}  // namespace pmts::gui
