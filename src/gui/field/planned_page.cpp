#include "planned_page.hpp"

#include "parts/line_icon.hpp"
#include "ui_planned_page.h"

#include <QHeaderView>
#include <QShortcut>

namespace pmts::gui {

using app::PlannedPointsModel;

namespace {

constexpr int kLeastTable_px = 64;  ///< header and one row

}  // namespace

PlannedPage::PlannedPage(PlannedPointsModel& planned, QWidget* parent)
    : QWidget(parent), planned_(planned), ui_(std::make_unique<Ui::PlannedPage>()) {
    ui_->setupUi(this);
    sorted_.setSourceModel(&planned_);
    sorted_.setSortRole(PlannedPointsModel::kSortRole);
    sorted_.setSortCaseSensitivity(Qt::CaseInsensitive);
    ui_->table->setModel(&sorted_);
    wireTable();
    wireTools();
    enableTools();
}

PlannedPage::~PlannedPage() = default;

void PlannedPage::wireTable() {
    QTableView* const table = ui_->table;
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->verticalHeader()->hide();
    table->setMinimumHeight(kLeastTable_px);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setResizeContentsPrecision(0);  // rows in view: a long design must not be slow
    table->sortByColumn(-1, Qt::AscendingOrder);
    connect(&sorted_, &QAbstractItemModel::modelReset, this, [this] {
        ui_->table->resizeColumnsToContents();
        enableTools();
    });
    connect(table, &QTableView::doubleClicked, this, &PlannedPage::turnToCurrent);
    connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        enableTools();
        if (const auto row_id = selectedPoint()) {
            Q_EMIT pointSelected(*row_id);
        }
    });
}

void PlannedPage::wireTools() {
    ui_->turn->setIcon(lineIcon(QStringLiteral("move")));
    ui_->remove->setIcon(lineIcon(QStringLiteral("close")));
    ui_->import->setIcon(lineIcon(QStringLiteral("import")));
    ui_->import->setToolTip(tr("Planned points from a CSV file: ID, E, N, H, code, remark in metres"));
    connect(ui_->turn, &QToolButton::clicked, this, &PlannedPage::turnToCurrent);
    connect(ui_->remove, &QToolButton::clicked, this, &PlannedPage::removeSelected);
    connect(ui_->import, &QToolButton::clicked, this, &PlannedPage::importRequested);
    auto* const remove_key =
        new QShortcut(QKeySequence::Delete, ui_->table, this, &PlannedPage::removeSelected);
    remove_key->setContext(Qt::WidgetWithChildrenShortcut);
}

QList<qint64> PlannedPage::selectedPoints() const {
    QList<qint64> row_ids;
    for (const QModelIndex& index : ui_->table->selectionModel()->selectedRows()) {
        row_ids.append(sorted_.data(index, PlannedPointsModel::kRowIdRole).toLongLong());
    }
    return row_ids;
}

std::optional<qint64> PlannedPage::selectedPoint() const {
    const QList<qint64> selected = selectedPoints();
    return selected.size() == 1 ? std::optional(selected.front()) : std::nullopt;
}

void PlannedPage::selectPoint(qint64 row_id) {
    const int row = planned_.rowOf(row_id);
    if (row >= 0) {
        const QModelIndex index = sorted_.mapFromSource(planned_.index(row, PlannedPointsModel::kId));
        ui_->table->setCurrentIndex(index);
        ui_->table->scrollTo(index);
    }
}

void PlannedPage::turnToCurrent() {
    if (const auto row_id = selectedPoint()) {
        Q_EMIT turnRequested(*row_id);
    }
}

void PlannedPage::removeSelected() { planned_.remove(selectedPoints()); }

void PlannedPage::enableTools() {
    const qsizetype count = ui_->table->selectionModel()->selectedRows().size();
    ui_->turn->setEnabled(count == 1);
    ui_->remove->setEnabled(count > 0);
}

}  // namespace pmts::gui
