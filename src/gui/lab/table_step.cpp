#include "table_step.hpp"

#include "curve_plot.hpp"
#include "parts/line_grid.hpp"
#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace pmts::gui {
namespace {

using calibration::RadiusDirection;

constexpr int kTouch_px = 36;
constexpr int kPage_px = 6;
constexpr double kPlace_px = 4.0;
constexpr double kSeen_px = 6.0;

struct Arrow {
    RadiusDirection direction;
    const char* sign;
    int row, column;
};
constexpr std::array<Arrow, calibration::kRadiusDirections> kArrows{{{RadiusDirection::kRight, "→", 1, 2},
                                                                     {RadiusDirection::kLeft, "←", 1, 0},
                                                                     {RadiusDirection::kUp, "↑", 0, 1},
                                                                     {RadiusDirection::kDown, "↓", 2, 1},
                                                                     {RadiusDirection::kUpRight, "↗", 0, 2},
                                                                     {RadiusDirection::kUpLeft, "↖", 0, 0},
                                                                     {RadiusDirection::kDownRight, "↘", 2, 2},
                                                                     {RadiusDirection::kDownLeft, "↙", 2, 0}}};

}  // namespace

TableStep::TableStep(app::DistortionTablePresenter& table, QWidget* parent) : LabPanel(parent), table_(table) {
    auto* const tabs = new QTabWidget(this);
    tabs->setObjectName(QStringLiteral("pages"));
    tabs->addTab(measurePage(), tr("Measure"));
    tabs->addTab(rowsPage(), tr("Rows"));
    angles_ = new CurvePlot(tabs);
    widths_ = new CurvePlot(tabs);
    for (CurvePlot* const plot : {angles_, widths_}) {
        plot->setNotice(tr("No rows yet: measure a target,\nor type them on the page Rows."));
    }
    tabs->addTab(angles_, tr("Angle"));
    tabs->addTab(widths_, tr("Pixel width"));
    column().addWidget(tabs, 1);
    buildResult();
    connect(&table_, &app::DistortionTablePresenter::changed, this, &TableStep::showAll);
    connect(&table_, &app::DistortionTablePresenter::progressed, this, &TableStep::showProgress);
    showAll();
}

/// The way to the rows: grid, sweep, the distances measured so far.
QWidget* TableStep::measurePage() {
    auto* const page = new QWidget(this);
    auto* const column = new QVBoxLayout(page);
    column->setContentsMargins(kPage_px, kPage_px, kPage_px, kPage_px);
    buildGrid(*column);
    buildRun(*column);
    column->addStretch(1);
    return page;
}

void TableStep::buildGrid(QVBoxLayout& column) {
    auto* const row = new QHBoxLayout;
    column.addLayout(row);
    auto* const left = new QVBoxLayout;
    row->addLayout(left, 1);
    auto* const label = new QLabel(tr("&Lines every"), this);
    spacing_ = new QDoubleSpinBox(this);
    spacing_->setObjectName(QStringLiteral("spacing"));
    spacing_->setRange(5, 200);
    spacing_->setDecimals(0);
    spacing_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    spacing_->setSuffix(tr(" px"));
    spacing_->setMinimumHeight(kTouch_px);
    label->setBuddy(spacing_);
    left->addWidget(label);
    left->addWidget(spacing_);
    target_ = new QLabel(this);
    target_->setWordWrap(true);
    left->addWidget(target_);
    left->addStretch(1);
    auto* const arrows = new QGridLayout;
    arrows->setSpacing(2);
    row->addLayout(arrows);
    for (std::size_t i = 0; i < kArrows.size(); ++i) {
        auto* const button = new QToolButton(this);
        button->setText(QString::fromUtf8(kArrows[i].sign));
        button->setCheckable(true);
        button->setProperty("boxed", true);
        button->setFixedSize(kTouch_px + 8, kTouch_px);
        button->setAccessibleName(calibration::directionName(kArrows[i].direction));
        button->setToolTip(tr("Lead the target: %1").arg(button->accessibleName()));
        arrows->addWidget(button, kArrows[i].row, kArrows[i].column);
        directions_[i] = button;
        connect(button, &QToolButton::clicked, this, &TableStep::takeDirections);
    }
    connect(spacing_, &QDoubleSpinBox::editingFinished, this, [this] {
        if (spacing_->value() != table_.stepPx()) {
            table_.setStep(spacing_->value());
        }
    });
}

void TableStep::buildRun(QVBoxLayout& column) {
    auto* const how = new QHBoxLayout;
    column.addLayout(how);
    automatic_ = addButton(tr("Automatic"), "automatic", how);
    by_hand_ = addButton(tr("By hand"), "by_hand", how);
    automatic_->setCheckable(true);
    by_hand_->setCheckable(true);
    auto* const run = new QHBoxLayout;
    column.addLayout(run);
    start_ = addButton(tr("Start"), "start", run);
    cancel_ = addButton(tr("Cancel"), "cancel", run);
    other_target_ = addButton(tr("Other target"), "other_target", run);
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    column.addWidget(progress_);
    missed_ = addText("missed");
    column.addWidget(missed_);
    auto* const runs = new QHBoxLayout;
    column.addLayout(runs);
    runs_ = new QComboBox(this);
    runs_->setAccessibleName(tr("Measured distances"));
    runs->addWidget(runs_, 1);
    remove_run_ = addButton(tr("Remove"), "remove_run", runs);
    connect(automatic_, &QPushButton::clicked, this, [this] { table_.setByHand(false); });
    connect(by_hand_, &QPushButton::clicked, this, [this] { table_.setByHand(true); });
    connect(start_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::start);
    connect(cancel_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::cancel);
    connect(other_target_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::newTarget);
    connect(remove_run_, &QPushButton::clicked, this, [this] { table_.removeRun(runs_->currentIndex()); });
}

/// What the table is worth stays in sight whatever page is open.
void TableStep::buildResult() {
    trouble_ = addText("rows_trouble");
    summary_ = addText("summary");
    accept_ = addButton(tr("Accept as the lens of the rig"), "accept");
    connect(accept_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::accept);
}

QWidget* TableStep::rowsPage() {
    auto* const page = new QWidget(this);
    auto* const column = new QVBoxLayout(page);
    column->setContentsMargins(kPage_px, kPage_px, kPage_px, kPage_px);
    rows_ = new QTableWidget(0, 4, page);
    rows_->setObjectName(QStringLiteral("rows"));
    rows_->setHorizontalHeaderLabels({tr("px"), tr("angle"), tr("off ideal"), tr("apart")});
    rows_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    rows_->verticalHeader()->hide();
    column->addWidget(rows_, 1);
    auto* const edits = new QHBoxLayout;
    add_row_ = addButton(tr("Add"), "add_row", edits);
    remove_row_ = addButton(tr("Delete"), "remove_row", edits);
    forget_ = addButton(tr("Measured"), "forget", edits);
    forget_->setToolTip(tr("Back to what was measured"));
    column->addLayout(edits);
    auto* const files = new QHBoxLayout;
    import_ = addButton(tr("Import…"), "import", files);
    export_ = addButton(tr("Export…"), "export", files);
    column->addLayout(files);
    connect(rows_, &QTableWidget::cellChanged, this, [this](int row) {
        table_.setRow(row, rows_->item(row, 0)->text(), rows_->item(row, 1)->text());
    });
    connect(add_row_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::addRow);
    connect(remove_row_, &QPushButton::clicked, this, [this] { table_.removeRow(rows_->currentRow()); });
    connect(forget_, &QPushButton::clicked, &table_, &app::DistortionTablePresenter::forgetEdits);
    connect(import_, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Import table"), {}, tr("Tables (*.csv)"));
        if (!path.isEmpty()) {
            table_.importCsv(path);
        }
    });
    connect(export_, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Export table"), QStringLiteral("distortion.csv"), tr("Tables (*.csv)"));
        if (!path.isEmpty()) {
            table_.exportCsv(path);
        }
    });
    return page;
}

void TableStep::takeDirections() {
    std::vector<RadiusDirection> chosen;
    for (std::size_t i = 0; i < kArrows.size(); ++i) {
        if (directions_[i]->isChecked()) {
            chosen.push_back(kArrows[i].direction);
        }
    }
    table_.setDirections(chosen);
}

void TableStep::showAll() {
    {
        const QSignalBlocker quiet(spacing_);
        spacing_->setValue(table_.stepPx());
    }
    const auto& chosen = table_.directions();
    for (std::size_t i = 0; i < kArrows.size(); ++i) {
        directions_[i]->setChecked(std::find(chosen.begin(), chosen.end(), kArrows[i].direction) != chosen.end());
        directions_[i]->setEnabled(!table_.isSweeping());
    }
    target_->setText(tr("Target: %1").arg(table_.targetText()));
    automatic_->setChecked(!table_.isByHand());
    by_hand_->setChecked(table_.isByHand());
    start_->setEnabled(table_.canStart() && !table_.isByHand());
    cancel_->setEnabled(table_.isSweeping());
    other_target_->setEnabled(!table_.isSweeping());
    runs_->clear();
    runs_->addItems(table_.runTexts());
    remove_run_->setEnabled(runs_->count() > 0 && !table_.isSweeping());
    accept_->setEnabled(table_.canAccept());
    trouble_->setText(runs_->count() > 0 || rows_->rowCount() > 0 ? table_.rowsTrouble() : QString());
    trouble_->setVisible(!trouble_->text().isEmpty());
    summary_->setText(table_.summary());
    summary_->setVisible(!summary_->text().isEmpty());
    showRows();
    const app::TablePlots plots = table_.plots();
    angles_->showCurves(plots.angle, tr("angle off the axis, gon"));
    widths_->showCurves(plots.width, tr("width of a pixel, gon"));
    showProgress();
}

void TableStep::showProgress() {
    showStep(table_.state(), table_.step());
    progress_->setValue(qRound(1000 * table_.progress()));
    progress_->setVisible(table_.isSweeping());
    missed_->setText(table_.progressText());
    missed_->setVisible(!table_.progressText().isEmpty());
    Q_EMIT overlayChanged();
}

void TableStep::showRows() {
    const QSignalBlocker quiet(rows_);
    const auto texts = table_.rows();
    rows_->setRowCount(static_cast<int>(texts.size()));
    for (int row = 0; row < rows_->rowCount(); ++row) {
        const app::TableRowText& text = texts[static_cast<std::size_t>(row)];
        const std::array cells{text.radius, text.angle, text.deviation, text.spread};
        for (int column = 0; column < rows_->columnCount(); ++column) {
            auto* const item = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            if (row == 0 || column > 1) {
                item->setFlags(item->flags() & ~Qt::ItemIsEditable);
            }
            rows_->setItem(row, column, item);
        }
    }
}

bool TableStep::pictureClicked(const QPointF& frame_px) {
    table_.click(frame_px);
    return true;
}

void TableStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const Theme& theme = currentTheme();
    const QPointF centre(table_.centre().x(), table_.centre().y());
    paintLineGrid(painter, widget_from_frame, {.size = table_.pictureSize(), .centre = centre, .spacing_px = table_.stepPx()}, theme);
    QPainterPath places, seen;
    for (const calibration::PlannedSpot& spot : table_.grid()) {
        places.addPath(circlePath(widget_from_frame.map(QPointF(spot.px.x(), spot.px.y())), kPlace_px));
    }
    for (const QPointF& px : table_.seenPixels()) {
        seen.addPath(crossPath(widget_from_frame.map(px), kSeen_px));
    }
    strokeEdged(painter, places, theme.accent, theme);
    strokeEdged(painter, seen, theme.good, theme);
}

}  // namespace pmts::gui
