#include "points_page.hpp"

#include "parts/line_icon.hpp"
#include "pmts/app/field/plane_range.hpp"
#include "ui_points_page.h"

#include <QHeaderView>
#include <QMenu>
#include <QShortcut>

namespace pmts::gui {

using app::PointsModel;

namespace {

constexpr int kLeastTable_px = 64;  ///< header and one row

}  // namespace

PointsPage::PointsPage(PointsModel& points, QUndoStack& undo, QWidget* parent)
    : QWidget(parent), points_(points), ui_(std::make_unique<Ui::PointsPage>()) {
    ui_->setupUi(this);
    sorted_.setSourceModel(&points_);
    sorted_.setSortRole(PointsModel::kSortRole);
    sorted_.setSortCaseSensitivity(Qt::CaseInsensitive);
    ui_->table->setModel(&sorted_);
    wireTable();
    wireTools(undo);
    enableTools();
}

PointsPage::~PointsPage() = default;

void PointsPage::wireTable() {
    QTableView* const table = ui_->table;
    table->setEditTriggers(QAbstractItemView::EditKeyPressed);  // the double-click is for turning
    table->setContextMenuPolicy(Qt::CustomContextMenu);
    table->verticalHeader()->hide();
    table->setMinimumHeight(kLeastTable_px);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setResizeContentsPrecision(
        0);  // rows in view: a long job must not slow recording down
    table->horizontalHeader()->setSortIndicatorShown(true);
    table->horizontalHeader()->setSectionsMovable(true);
    table->sortByColumn(-1, Qt::AscendingOrder);
    const auto fit_columns = [table] { table->resizeColumnsToContents(); };
    connect(&points_, &QAbstractItemModel::modelReset, table, fit_columns);
    connect(&sorted_, &QAbstractItemModel::rowsInserted, this, [this, fit_columns] {
        fit_columns();
        ui_->table->scrollToBottom();
    });
    connect(table, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { Q_EMIT turnRequested(rowIdAt(index)); });
    connect(table, &QWidget::customContextMenuRequested, this, &PointsPage::showMenu);
    connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        enableTools();
        if (const auto row_id = selectedPoint()) {
            Q_EMIT pointSelected(*row_id);
        }
    });
}

void PointsPage::wireTools(QUndoStack& undo) {
    ui_->turn->setIcon(lineIcon(QStringLiteral("move")));
    ui_->edit->setIcon(lineIcon(QStringLiteral("edit")));
    ui_->strike->setIcon(lineIcon(QStringLiteral("close")));
    ui_->evidence->setIcon(lineIcon(QStringLiteral("evidence")));
    connect(ui_->evidence, &QToolButton::clicked, this, [this] {
        if (const auto row_id = selectedPoint()) {
            Q_EMIT evidenceRequested(*row_id);
        }
    });
    connect(ui_->turn, &QToolButton::clicked, this, &PointsPage::turnToCurrent);
    connect(ui_->edit, &QToolButton::clicked, this, &PointsPage::editCurrent);
    connect(ui_->strike, &QToolButton::clicked, this, &PointsPage::strikeSelected);
    auto* const strike_key =
        new QShortcut(QKeySequence::Delete, ui_->table, this, &PointsPage::strikeSelected);
    strike_key->setContext(Qt::WidgetWithChildrenShortcut);
    QAction* const undo_action = undo.createUndoAction(this, tr("Undo"));
    QAction* const redo_action = undo.createRedoAction(this, tr("Redo"));
    undo_action->setIcon(lineIcon(QStringLiteral("undo")));
    redo_action->setIcon(lineIcon(QStringLiteral("redo")));
    ui_->undo->setDefaultAction(undo_action);
    ui_->redo->setDefaultAction(redo_action);
    ui_->undo->setAccessibleName(tr("Undo"));
    ui_->redo->setAccessibleName(tr("Redo"));
}

qint64 PointsPage::rowIdAt(const QModelIndex& proxy_index) const {
    return sorted_.data(proxy_index, PointsModel::kRowIdRole).toLongLong();
}

QList<qint64> PointsPage::selectedPoints() const {
    QList<qint64> row_ids;
    for (const QModelIndex& index : ui_->table->selectionModel()->selectedRows()) {
        row_ids.append(rowIdAt(index));
    }
    return row_ids;
}

std::optional<qint64> PointsPage::selectedPoint() const {
    const QList<qint64> selected = selectedPoints();
    return selected.size() == 1 ? std::optional(selected.front()) : std::nullopt;
}

void PointsPage::selectPoint(qint64 row_id) {
    const int row = points_.rowOf(row_id);
    if (row >= 0) {
        const QModelIndex index = sorted_.mapFromSource(points_.index(row, PointsModel::kId));
        ui_->table->setCurrentIndex(index);
        ui_->table->scrollTo(index);
    }
}

void PointsPage::turnToCurrent() {
    if (const auto row_id = selectedPoint()) {
        Q_EMIT turnRequested(*row_id);
    }
}

void PointsPage::editCurrent() {
    QModelIndex index = ui_->table->currentIndex();
    if (index.isValid() && !(sorted_.flags(index) & Qt::ItemIsEditable)) {
        index = index.siblingAtColumn(PointsModel::kId);
        ui_->table->setCurrentIndex(index);
    }
    if (index.isValid()) {
        ui_->table->edit(index);
    }
}

void PointsPage::strikeSelected() {
    QList<qint64> live, struck;
    for (const QModelIndex& index : ui_->table->selectionModel()->selectedRows()) {
        (sorted_.data(index, PointsModel::kStruckOutRole).toBool() ? struck : live).append(rowIdAt(index));
    }
    if (!live.isEmpty()) {
        points_.strikeOut(live);
    } else if (!struck.isEmpty()) {
        points_.restore(struck);
    }
    enableTools();
}

void PointsPage::showMenu(const QPoint& at) {
    const QList<qint64> selected = selectedPoints();
    if (selected.isEmpty()) {
        return;
    }
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (selected.size() == 1) {
        addOnePointEntries(*menu, selected.front());
    }
    menu->addAction(ui_->strike->text(), this, &PointsPage::strikeSelected);
    QAction* const plane = menu->addAction(tr("Ranges from the plane of these points"), this,
                                           [this, selected] { Q_EMIT planeRequested(selected); });
    plane->setEnabled(selected.size() >= app::PlaneRange::kLeastPoints);
    menu->popup(ui_->table->viewport()->mapToGlobal(at));
}

void PointsPage::addOnePointEntries(QMenu& menu, qint64 row_id) {
    menu.addAction(tr("Turn to"), this, [this, row_id] { Q_EMIT turnRequested(row_id); });
    menu.addAction(lineIcon(QStringLiteral("evidence")), tr("Evidence…"), this,
                   [this, row_id] { Q_EMIT evidenceRequested(row_id); });
    menu.addAction(tr("Edit"), this, &PointsPage::editCurrent);
    menu.addAction(tr("Orient: the telescope points at it now"), this,
                   [this, row_id] { Q_EMIT orientRequested(row_id); });
}

void PointsPage::enableTools() {
    const auto selected = ui_->table->selectionModel()->selectedRows();
    ui_->turn->setEnabled(selected.size() == 1);
    ui_->edit->setEnabled(selected.size() == 1);
    ui_->evidence->setEnabled(selected.size() == 1);
    ui_->strike->setEnabled(!selected.isEmpty());
    const bool struck =
        selected.size() == 1 && sorted_.data(selected.front(), PointsModel::kStruckOutRole).toBool();
    ui_->strike->setText(struck ? tr("Restore") : tr("Strike out"));
}

}  // namespace pmts::gui
