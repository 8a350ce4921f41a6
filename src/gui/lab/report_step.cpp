#include "report_step.hpp"

#include "calibration_pdf.hpp"
#include "parts/lab_parts.hpp"

#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>

namespace pmts::gui {
namespace {

constexpr int kPlot_px = 250;
constexpr int kNotice_px = 48;  ///< of a plot without values

}  // namespace

ReportStep::ReportStep(app::ProfilesPresenter& profiles, const app::Preferences& preferences, QWidget* parent)
    : LabStep(parent), profiles_(profiles), preferences_(preferences), plots_(this) {
    auto* const column = new QVBoxLayout(this);
    auto* const pdf = labButton(tr("Save as PDF…"), "report_pdf", this);
    auto* const copy = labButton(tr("Copy text"), "report_copy", this);
    auto* const row = new QHBoxLayout;
    row->addWidget(pdf);
    row->addWidget(copy);
    said_ = labText("report_said", this);
    said_->hide();
    texts_ = labText("report_texts", this);
    column->addLayout(row);
    column->addWidget(said_);
    column->addWidget(texts_);
    for (const auto& [heading, plot] : plots_.all()) {
        column->addWidget(labHeading(heading, this));
        column->addWidget(plot);
    }
    column->addStretch(1);
    connect(pdf, &QPushButton::clicked, this, &ReportStep::savePdf);
    connect(copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(app::calibrationReportText(app::calibrationReport(profiles_.inUse().profile, preferences_.units())));
    });
    connect(&profiles_, &app::ProfilesPresenter::changed, this, [this] {
        if (isVisible()) {
            showAll();
        }
    });
    showAll();
}

void ReportStep::showAll() {
    const app::CalibrationReport report = app::calibrationReport(profiles_.inUse().profile, preferences_.units());
    QString text = QStringLiteral("<b>%1</b><table>").arg(report.title.toHtmlEscaped());
    const auto cell = [](const QString& value) { return QStringLiteral("<td style='padding-right:8px'>%1</td>").arg(value.toHtmlEscaped()); };
    for (const auto& [name, value] : report.facts) {
        text += QStringLiteral("<tr>%1<td colspan=2>%2</td></tr>").arg(cell(name), value.toHtmlEscaped());
    }
    for (const auto& parameter : report.parameters) {
        text += QStringLiteral("<tr>%1%2%3</tr>").arg(cell(parameter.name), cell(parameter.value), cell(parameter.deviation));
    }
    text += QStringLiteral("</table>");
    if (!report.compared.isEmpty()) {
        text += QStringLiteral("<p>%1</p>").arg(report.compared.toHtmlEscaped());
    }
    texts_->setText(text);
    plots_.show(report);
    for (const auto& [heading, plot] : plots_.all()) {
        plot->setMinimumHeight(plot->isEmpty() ? kNotice_px : kPlot_px);
    }
    Q_EMIT stateChanged(profiles_.inUse().profile.calibration ? app::DeviceState::kGood : app::DeviceState::kIdle);
}

void ReportStep::savePdf() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save as PDF"), QStringLiteral("calibration.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty()) {
        return;
    }
    const auto written = writeCalibrationPdf(app::calibrationReport(profiles_.inUse().profile, preferences_.units()), path);
    said_->setText(written ? tr("The report is written.") : written.error().sentence());
    said_->show();
}

}  // namespace pmts::gui
