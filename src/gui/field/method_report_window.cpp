#include "method_report_window.hpp"

#include "parts/line_icon.hpp"
#include "method_page_view.hpp"
#include "parts/report_pdf.hpp"
#include "parts/text_table.hpp"
#include "ui_method_report_window.h"

#include <QFileDialog>
#include <QHeaderView>
#include <QStyle>

namespace pmts::gui {

using app::ReportField;

namespace {

constexpr QSize kFirstSize(1240, 730);  ///< fits 1280x800 with its frame
constexpr double kZoomStep = 1.5;
constexpr int kFixedTabs = 3;  ///< targets, collect, summary
constexpr int kSummaryTab = 2;

}  // namespace

MethodReportWindow::MethodReportWindow(app::MethodReportPresenter& report, QWidget* parent)
    : QDialog(parent), report_(report), ui_(std::make_unique<Ui::MethodReportWindow>()) {
    ui_->setupUi(this);
    setWindowFlags(Qt::Window);
    resize(kFirstSize);
    fields_ = {{ReportField::kWidth, ui_->width},         {ReportField::kHeight, ui_->height},
               {ReportField::kCentreX, ui_->centre_x},    {ReportField::kCentreY, ui_->centre_y},
               {ReportField::kPhotoHa, ui_->photo_ha},    {ReportField::kPhotoVa, ui_->photo_va},
               {ReportField::kF, ui_->f},                 {ReportField::kRight, ui_->right},
               {ReportField::kForward, ui_->forward},     {ReportField::kUp, ui_->up},
               {ReportField::kPixelAcross, ui_->pixel_across}, {ReportField::kPixelDown, ui_->pixel_down}};
    ui_->mount->addItems({tr("handle (turns with HA)"), tr("telescope (tilts too)")});
    ui_->rig->addItem(tr("the camera above"), static_cast<int>(app::RigOfReport::kNominal));
    ui_->rig->addItem(tr("the rig in use"), static_cast<int>(app::RigOfReport::kInUse));
    ui_->rig->addItem(tr("a rig fitted to the targets"), static_cast<int>(app::RigOfReport::kFitted));
    setUpTables();
    wireList();
    wireCollecting();
    wireReport();
    showForm();
    showList();
    showStills();
    showStill();
    showPoints();
    showReport();
    showRunning(report_.isRunning());
    say(tr("Open a table of targets, take the thesis's example, or collect targets in a still."));
}

MethodReportWindow::~MethodReportWindow() = default;

void MethodReportWindow::setUpTables() {
    ui_->targets->setModel(&report_.targets());
    ui_->targets->verticalHeader()->hide();
    ui_->targets->horizontalHeader()->setHighlightSections(false);
    ui_->targets->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    ui_->summary->horizontalHeader()->setStretchLastSection(true);
    ui_->summary->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // known errors wrap
    ui_->points->setColumnCount(3);
    ui_->points->setHorizontalHeaderLabels({tr("Point"), tr("SD"), tr("Clicked")});
    ui_->points->verticalHeader()->hide();
    ui_->points->horizontalHeader()->setHighlightSections(false);
    ui_->points->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    const std::pair<QToolButton*, const char*> icons[] = {
        {ui_->zoom_in, "zoom-in"}, {ui_->zoom_out, "zoom-out"}, {ui_->fit, "fit"}};
    for (const auto& [button, icon] : icons) {
        button->setIcon(lineIcon(QString::fromLatin1(icon)));
    }
}

void MethodReportWindow::wireList() {
    connect(ui_->example, &QPushButton::clicked, &report_, &app::MethodReportPresenter::openThesisExample);
    connect(ui_->open, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Table of targets"), {}, tr("Table (*.csv *.txt);;All (*)"));
        if (!path.isEmpty()) {
            report_.openTable(path);
        }
    });
    connect(ui_->save, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Save the table"), QStringLiteral("targets.csv"), tr("Table (*.csv)"));
        if (!path.isEmpty() && report_.keepForm(typedForm())) {
            report_.saveTable(path);
        }
    });
    connect(ui_->remove, &QPushButton::clicked, this, [this] {
        QList<int> rows;
        for (const QModelIndex& index : ui_->targets->selectionModel()->selectedRows()) {
            rows.append(index.row());
        }
        report_.targets().removeTargets(rows);
    });
    connect(ui_->clear, &QPushButton::clicked, &report_.targets(), &app::TargetListModel::clear);
    connect(&report_.targets(), &app::TargetListModel::targetsChanged, this, &MethodReportWindow::showList);
    connect(ui_->targets->selectionModel(), &QItemSelectionModel::selectionChanged, this, &MethodReportWindow::showList);
}

void MethodReportWindow::wireCollecting() {
    app::TargetCollector& collector = report_.collector();
    ImageView* const picture = ui_->picture;
    connect(ui_->capture, &QPushButton::clicked, &collector, &app::TargetCollector::capture);
    connect(ui_->still, &QComboBox::activated, &collector, &app::TargetCollector::chooseStill);
    connect(ui_->points, &QTableWidget::itemSelectionChanged, &collector, [this, &collector] {
        if (const auto rows = ui_->points->selectionModel()->selectedRows(); !rows.isEmpty()) {
            collector.pickPoint(rows.front().row());
        }
    });
    connect(picture, &ImageView::pixelClicked, &collector, &app::TargetCollector::click);
    connect(picture, &ImageView::hovered, this, [this](const QPointF& px) { showCaption(px); });
    connect(picture, &ImageView::hoverEnded, this, [this] { showCaption({}); });
    connect(ui_->zoom_in, &QToolButton::clicked, picture, [picture] { picture->setZoom(picture->zoom() * kZoomStep); });
    connect(ui_->zoom_out, &QToolButton::clicked, picture, [picture] { picture->setZoom(picture->zoom() / kZoomStep); });
    connect(ui_->fit, &QToolButton::clicked, picture, &ImageView::fit);
    connect(&collector, &app::TargetCollector::stillsChanged, this, &MethodReportWindow::showStills);
    connect(&collector, &app::TargetCollector::stillChosen, this, &MethodReportWindow::showStill);
    connect(&collector, &app::TargetCollector::pointsChanged, this, &MethodReportWindow::showPoints);
}

void MethodReportWindow::wireReport() {
    using Presenter = app::MethodReportPresenter;
    connect(ui_->run, &QPushButton::clicked, this, [this] {
        for (const auto& [field, edit] : fields_) {
            edit->setProperty("wrong", false);
            edit->style()->polish(edit);
        }
        report_.run(typedForm());
    });
    connect(ui_->cancel, &QPushButton::clicked, &report_, &Presenter::cancel);
    connect(ui_->save_text, &QPushButton::clicked, this, [this] { chooseReportFile(QStringLiteral("txt"), tr("Text (*.txt)")); });
    connect(ui_->save_csv, &QPushButton::clicked, this, [this] { chooseReportFile(QStringLiteral("csv"), tr("Table (*.csv)")); });
    connect(ui_->save_pdf, &QPushButton::clicked, this, [this] { chooseReportFile(QStringLiteral("pdf"), tr("PDF (*.pdf)")); });
    connect(&report_, &Presenter::formChanged, this, &MethodReportWindow::showForm);
    connect(&report_, &Presenter::fieldRejected, this, &MethodReportWindow::markWrong);
    connect(&report_, &Presenter::runningChanged, this, &MethodReportWindow::showRunning);
    connect(&report_, &Presenter::progressChanged, this, [this](int done, int all) {
        ui_->progress->setMaximum(all);
        ui_->progress->setValue(done);
    });
    connect(&report_, &Presenter::viewChanged, this, &MethodReportWindow::showReport);
    connect(&report_, &Presenter::said, this, &MethodReportWindow::say);
    connect(&report_, &Presenter::problemReported, this, &MethodReportWindow::complain);
}

void MethodReportWindow::showForm() {
    const app::MethodReportForm form = report_.form();
    for (const auto& [field, edit] : fields_) {
        edit->setText(form.fields.at(field));
        edit->setCursorPosition(0);
        edit->setProperty("wrong", false);
        edit->style()->polish(edit);
        edit->setToolTip({});
    }
    ui_->mount->setCurrentIndex(form.on_handle ? 0 : 1);
    ui_->rig->setCurrentIndex(ui_->rig->findData(static_cast<int>(form.rig)));
}

app::MethodReportForm MethodReportWindow::typedForm() const {
    app::MethodReportForm form{.fields = {},
                               .on_handle = ui_->mount->currentIndex() == 0,
                               .rig = static_cast<app::RigOfReport>(ui_->rig->currentData().toInt())};
    for (const auto& [field, edit] : fields_) {
        form.fields[field] = edit->text();
    }
    return form;
}

void MethodReportWindow::markWrong(ReportField field, const core::Error& error) {
    QLineEdit* const edit = fields_.at(field);
    edit->setProperty("wrong", true);
    edit->style()->polish(edit);
    edit->setToolTip(error.sentence());
    edit->setFocus();
    edit->selectAll();
    complain(error);
}

void MethodReportWindow::showList() {
    const int count = report_.targets().rowCount();
    ui_->targets_hint->setText(count > 0 ? tr("%n target(s) of %1", nullptr, count).arg(report_.targets().source())
                                         : tr("No targets yet."));
    ui_->remove->setEnabled(ui_->targets->selectionModel()->hasSelection());
    ui_->clear->setEnabled(count > 0);
    ui_->save->setEnabled(count > 0);
}

void MethodReportWindow::showStills() {
    ui_->still->clear();
    ui_->still->addItems(report_.collector().stillNames());
    ui_->still->setEnabled(ui_->still->count() > 0);
    ui_->still->setCurrentIndex(report_.collector().chosenStill());
}

void MethodReportWindow::showStill() {
    ui_->still->setCurrentIndex(report_.collector().chosenStill());
    const app::CollectibleStill* const still = report_.collector().still();
    ui_->picture->setFrame(still != nullptr ? still->frame : nullptr);
    ui_->picture->setNotice(still == nullptr  ? tr("Choose a still of the job, or take one now.")
                            : !still->frame ? tr("The picture is loaded.")
                                            : QString());
}

void MethodReportWindow::showPoints() {
    const app::TargetCollector& collector = report_.collector();
    const QSignalBlocker quiet(ui_->points);
    ui_->points->setRowCount(static_cast<int>(collector.points().size()));
    ImageOverlay overlay;
    int row = 0;
    for (const app::CollectiblePoint& point : collector.points()) {
        ui_->points->setItem(row, 0, new QTableWidgetItem(point.id));
        ui_->points->setItem(row, 1, new QTableWidgetItem(point.distance_text));
        ui_->points->setItem(row, 2, new QTableWidgetItem(point.clicked ? tr("✓") : QString()));
        if (point.clicked) {
            overlay.points.push_back({.px = *point.clicked, .label = point.id, .selected = row == collector.pickedPoint()});
        }
        ++row;
    }
    ui_->points->selectRow(collector.pickedPoint());
    ui_->picture->setOverlay(overlay);
    showCaption({});
}

void MethodReportWindow::showCaption(const std::optional<QPointF>& cursor_px) {
    const app::TargetCollector& collector = report_.collector();
    const auto place = [](const QPointF& px) { return tr("column %1, row %2").arg(qRound(px.x())).arg(qRound(px.y())); };
    QString caption;
    if (collector.pickedPoint() >= 0) {
        const app::CollectiblePoint& picked = collector.points()[static_cast<std::size_t>(collector.pickedPoint())];
        caption = tr("Click %1, expected about %2").arg(picked.id, place(picked.expected_px));
    } else if (collector.still() != nullptr && collector.points().empty()) {
        caption = tr("No point recorded at this station lies in this still.");
    }
    ui_->picture->setCaption(cursor_px && !caption.isEmpty() ? tr("%1 (cursor: %2)").arg(caption, place(*cursor_px)) : caption);
}

void MethodReportWindow::showReport() {
    const QString shown = ui_->tabs->tabText(ui_->tabs->currentIndex());
    while (ui_->tabs->count() > kFixedTabs) {
        QWidget* const old = ui_->tabs->widget(kFixedTabs);
        ui_->tabs->removeTab(kFixedTabs);
        old->deleteLater();
    }
    const auto& view = report_.view();
    for (QPushButton* save : {ui_->save_text, ui_->save_csv, ui_->save_pdf}) {
        save->setEnabled(view.has_value());
    }
    ui_->head->setText(view ? view->head : tr("No report yet: Run all methods."));
    showTexts(*ui_->summary, view ? view->summary : app::TextTable{});
    ui_->fit_text->setText(view ? view->fit.join(QStringLiteral("   ")) : QString());
    ui_->fit_text->setVisible(!ui_->fit_text->text().isEmpty());
    if (!view) {
        return;
    }
    bool kept = shown == ui_->tabs->tabText(kSummaryTab);
    for (const app::MethodPage& page : view->pages) {
        const int tab = ui_->tabs->addTab(new MethodPageView(page, *view), page.name);
        if (page.name == shown) {
            ui_->tabs->setCurrentIndex(tab);
            kept = true;
        }
    }
    if (!kept) {
        ui_->tabs->setCurrentIndex(kSummaryTab);
    }
}

void MethodReportWindow::showRunning(bool running) {
    ui_->progress->setVisible(running);
    ui_->progress->setRange(0, 0);
    ui_->cancel->setVisible(running);
    for (QWidget* widget : {static_cast<QWidget*>(ui_->run), static_cast<QWidget*>(ui_->options), static_cast<QWidget*>(ui_->example),
                            static_cast<QWidget*>(ui_->open)}) {
        widget->setEnabled(!running);
    }
    if (running) {
        ui_->lamp->setState(app::DeviceState::kBusy);
        ui_->message->setText(tr("The rig is fitted to the targets, and once without each of them."));
    }
}

void MethodReportWindow::say(const QString& sentence) {
    ui_->lamp->setState(app::DeviceState::kIdle);
    ui_->message->setText(sentence);
}

void MethodReportWindow::complain(const core::Error& error) {
    ui_->lamp->setState(app::DeviceState::kFailed);
    ui_->message->setText(error.sentence());
}

void MethodReportWindow::chooseReportFile(const QString& ending, const QString& filter) {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save the report"), QStringLiteral("method-report.") + ending, filter);
    if (!path.isEmpty()) {
        saveReport(QFileInfo(path).suffix() == ending ? path : path + u'.' + ending);
    }
}

void MethodReportWindow::saveReport(const QString& path) {
    if (path.endsWith(QStringLiteral(".txt"))) {
        report_.saveText(path);
    } else if (path.endsWith(QStringLiteral(".csv"))) {
        report_.saveCsv(path);
    } else if (report_.view()) {
        const auto written = writeReportPdf(*report_.view(), path);
        written ? say(tr("Saved as %1.").arg(path)) : complain(written.error());
    }
}

}  // namespace pmts::gui
