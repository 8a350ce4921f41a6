#include "memory_page.hpp"

#include "parts/lab_parts.hpp"
#include "label_backup_panel.hpp"
#include "memory_file_panel.hpp"
#include "transfer_row.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr int kFiles_px = 280;
constexpr int kRow_px = 40;

}  // namespace

MemoryPage::MemoryPage(app::MemoryPresenter& memory, app::LabelBackupPresenter& backup, QWidget* parent)
    : ListedPage(parent), memory_(memory), backup_(backup), transfer_(new TransferRow("memory_cancel", this)) {
    auto* const column = new QVBoxLayout(this);
    auto* const row = new QHBoxLayout;
    auto* const tabs = new QTabWidget(this);
    tabs->setObjectName(QStringLiteral("memory_tabs"));
    tabs->addTab(new MemoryFilePanel(memory_, backup_, tabs), tr("File"));
    tabs->addTab(new LabelBackupPanel(backup, memory_, tabs), tr("Label backup"));
    row->addWidget(makeFiles());
    row->addWidget(tabs, 1);
    column->addLayout(row, 1);
    column->addWidget(transfer_);
    connect(transfer_, &TransferRow::cancelled, &memory_, &app::MemoryPresenter::cancel);
    connect(&memory_, &app::MemoryPresenter::listingChanged, this, &MemoryPage::showListing);
    connect(&memory_, &app::MemoryPresenter::transferChanged, this, &MemoryPage::showTransfer);
    connect(&backup_, &app::LabelBackupPresenter::transferChanged, this, &MemoryPage::showTransfer);
    connect(&memory_, &app::MemoryPresenter::stateChanged, this, &MemoryPage::stateChanged);
    showListing();
}

QWidget* MemoryPage::makeFiles() {
    auto* const holder = new QWidget(this);
    holder->setFixedWidth(kFiles_px);
    auto* const column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    files_ = new QTableWidget(0, 2, holder);
    files_->setObjectName(QStringLiteral("memory_files"));
    files_->setAccessibleName(tr("Files in the instrument"));
    files_->setHorizontalHeaderLabels({tr("Kind"), tr("Name")});
    files_->horizontalHeader()->setStretchLastSection(true);
    files_->horizontalHeader()->setHighlightSections(false);
    files_->verticalHeader()->hide();
    files_->verticalHeader()->setDefaultSectionSize(kRow_px);
    files_->setSelectionBehavior(QAbstractItemView::SelectRows);
    files_->setSelectionMode(QAbstractItemView::SingleSelection);
    files_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    room_ = labText("memory_room", holder);
    list_ = labButton(tr("&Update the list"), "memory_list", holder);
    read_ = labButton(tr("&Read the chosen file"), "memory_read", holder);
    column->addWidget(labHeading(tr("In the instrument"), holder));
    column->addWidget(files_, 1);
    column->addWidget(room_);
    column->addWidget(list_);
    column->addWidget(read_);
    connect(list_, &QPushButton::clicked, &memory_, &app::MemoryPresenter::refresh);
    connect(read_, &QPushButton::clicked, this, &MemoryPage::readSelected);
    connect(files_, &QTableWidget::itemDoubleClicked, this, &MemoryPage::readSelected);
    connect(files_, &QTableWidget::itemSelectionChanged, this, &MemoryPage::showTransfer);
    return holder;
}

void MemoryPage::entered() {
    if (!memory_.isListed()) {
        memory_.refresh();
    }
}

void MemoryPage::showListing() {
    const auto& listing = memory_.listing();
    files_->setRowCount(memory_.isListed() ? static_cast<int>(listing.files.size()) : 0);
    for (int row = 0; row < files_->rowCount(); ++row) {
        const auto& file = listing.files[static_cast<std::size_t>(row)];
        files_->setItem(row, 0, new QTableWidgetItem(app::MemoryPresenter::nameOf(file.directory)));
        files_->setItem(row, 1, new QTableWidgetItem(file.name));
    }
    room_->setText(memory_.roomText());
    showTransfer();
}

void MemoryPage::showTransfer() {
    const bool busy = memory_.transfer().busy || backup_.transfer().busy;  // one at a time on the line
    transfer_->showTransfer(memory_.transfer());
    list_->setEnabled(!busy && memory_.isReachable());
    read_->setEnabled(!busy && memory_.isReachable() && files_->currentRow() >= 0);
    files_->setEnabled(!busy);
}

void MemoryPage::readSelected() {
    const int row = files_->currentRow();
    const auto& files = memory_.listing().files;
    if (row >= 0 && row < static_cast<int>(files.size())) {
        memory_.download(files[static_cast<std::size_t>(row)]);
    }
}

}  // namespace pmts::gui
