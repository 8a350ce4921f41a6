#include "evidence_dialog.hpp"

#include "parts/action_button.hpp"
#include "evidence_sheet.hpp"
#include "ui_evidence_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>

namespace pmts::gui {
namespace {

/// A heading and two columns, label and value.
QString tableOf(const QString& heading, const std::vector<app::EvidenceLine>& lines) {
    QString html = QStringLiteral("<p><b>%1</b></p><table cellspacing='0' cellpadding='2'>")
                       .arg(heading.toHtmlEscaped());
    for (const app::EvidenceLine& line : lines) {
        html +=
            QStringLiteral("<tr><td style='padding-right:12px'>%1</td><td>%2</td></tr>")
                .arg(line.label.toHtmlEscaped(), line.value.toHtmlEscaped().replace(
                                                     QStringLiteral("   "), QStringLiteral("&nbsp;&nbsp; ")));
    }
    return html + QStringLiteral("</table>");
}

/// A file name for a point, whatever it is called.
QString fileNameFor(const QString& point_id) {
    QString name = point_id;
    for (QChar& c : name) {
        if (!c.isLetterOrNumber() && c != u'-' && c != u'_') {
            c = u'_';
        }
    }
    return QStringLiteral("point-%1.pdf").arg(name);
}

}  // namespace

EvidenceDialog::EvidenceDialog(app::EvidencePresenter& evidence, QWidget* parent)
    : QDialog(parent), evidence_(evidence), ui_(std::make_unique<Ui::EvidenceDialog>()) {
    ui_->setupUi(this);
    for (QPushButton* button : {ui_->save, ui_->print, ui_->close}) {
        button->setMinimumHeight(ActionButton::kLeastSide_px);
        button->setAutoDefault(false);
    }
    connect(ui_->save, &QPushButton::clicked, this, &EvidenceDialog::choosePdf);
    connect(ui_->print, &QPushButton::clicked, this, &EvidenceDialog::print);
    connect(ui_->close, &QPushButton::clicked, this, &QDialog::close);
    connect(&evidence_, &app::EvidencePresenter::sheetChanged, this, &EvidenceDialog::showSheet);
    showSheet();
}

EvidenceDialog::~EvidenceDialog() = default;

void EvidenceDialog::showSheet() {
    const auto sheet = evidence_.sheet();
    if (!sheet) {
        close();  // its job was closed
        return;
    }
    setWindowTitle(tr("Evidence of point %1").arg(sheet->point_id));
    ui_->title->setText(tr("Point %1").arg(sheet->point_id));
    ui_->subtitle->setText(sheet->subtitle);
    ui_->verdict->setText(sheet->verdict);
    ui_->before->showThumbnail(sheet->before);
    ui_->after->showThumbnail(sheet->after);
    ui_->before_caption->setText(sheet->before.caption);
    ui_->after_caption->setText(sheet->after.caption);
    ui_->point->setText(tableOf(tr("Point"), sheet->place) + tableOf(tr("Observation"), sheet->observation));
    ui_->aiming->setText(tableOf(tr("Aiming by image"), sheet->aiming));
    ui_->outcome->clear();
}

void EvidenceDialog::choosePdf() {
    const auto sheet = evidence_.sheet();
    const QString proposed = sheet ? QDir(folder_).filePath(fileNameFor(sheet->point_id)) : folder_;
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the evidence"), proposed, tr("PDF (*.pdf)"));
    if (!path.isEmpty()) {
        saveTo(path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive) ? path
                                                                          : path + QStringLiteral(".pdf"));
    }
}

void EvidenceDialog::saveTo(const QString& path) {
    if (const auto sheet = evidence_.sheet()) {
        const auto written = writeEvidencePdf(*sheet, path);
        ui_->outcome->setText(written ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path))
                                      : written.error().sentence());
    }
}

void EvidenceDialog::print() {
    const auto sheet = evidence_.sheet();
    QPrinter printer(QPrinter::HighResolution);
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setFullPage(true);
    QPrintDialog dialog(&printer, this);
    if (!sheet || dialog.exec() != QDialog::Accepted) {
        return;
    }
    QPainter painter;
    const bool begun = painter.begin(&printer);
    if (begun) {
        usePageUnits(painter, printer.resolution());
        paintEvidenceSheet(painter, *sheet);
    }
    ui_->outcome->setText(begun && painter.end() ? tr("Sent to the printer.")
                                                 : tr("The printer took nothing: check it, or save a PDF."));
}

}  // namespace pmts::gui
