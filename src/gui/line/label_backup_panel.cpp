#include "label_backup_panel.hpp"

#include "parts/lab_parts.hpp"
#include "parts/text_table.hpp"
#include "transfer_row.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>

namespace pmts::gui {
namespace {

QString filter() { return LabelBackupPanel::tr("Label backups (*.txt);;All files (*)"); }

}  // namespace

LabelBackupPanel::LabelBackupPanel(app::LabelBackupPresenter& backup, const app::MemoryPresenter& memory, QWidget* parent)
    : QWidget(parent),
      backup_(backup),
      memory_(memory),
      sentence_(labText("backup_sentence", this)),
      comparison_(labText("backup_comparison", this)),
      table_(new QTableWidget(this)),
      transfer_(new TransferRow("backup_cancel", this)),
      read_(labButton(tr("Read all la&bels"), "backup_read", this)),
      save_(labButton(tr("Save &as…"), "backup_save", this)),
      compare_(labButton(tr("&Compare with an earlier one…"), "backup_compare", this)) {
    auto* const column = new QVBoxLayout(this);
    table_->setObjectName(QStringLiteral("backup_table"));
    table_->setAccessibleName(tr("Labels"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->horizontalHeader()->setStretchLastSection(true);
    auto* const row = new QHBoxLayout;
    for (QPushButton* const button : {read_, save_, compare_}) {
        row->addWidget(button);
    }
    column->addWidget(sentence_);
    column->addWidget(comparison_);
    column->addWidget(table_, 1);
    column->addWidget(transfer_);
    column->addLayout(row);
    connect(read_, &QPushButton::clicked, &backup_, &app::LabelBackupPresenter::read);
    connect(save_, &QPushButton::clicked, this, &LabelBackupPanel::save);
    connect(compare_, &QPushButton::clicked, this, &LabelBackupPanel::compare);
    connect(transfer_, &TransferRow::cancelled, &backup_, &app::LabelBackupPresenter::cancel);
    connect(&backup_, &app::LabelBackupPresenter::changed, this, &LabelBackupPanel::showAll);
    connect(&backup_, &app::LabelBackupPresenter::transferChanged, this, &LabelBackupPanel::showTransfer);
    connect(&memory_, &app::MemoryPresenter::listingChanged, this, &LabelBackupPanel::showTransfer);
    connect(&memory_, &app::MemoryPresenter::transferChanged, this, &LabelBackupPanel::showTransfer);
    showAll();
}

void LabelBackupPanel::showTransfer() {
    const bool busy = backup_.transfer().busy;
    transfer_->showTransfer(backup_.transfer());
    read_->setEnabled(!busy && !memory_.transfer().busy && memory_.isReachable());
    save_->setEnabled(!busy && backup_.backup().has_value());
    compare_->setEnabled(!busy && backup_.backup().has_value());
}

void LabelBackupPanel::showAll() {
    sentence_->setText(backup_.sentence());
    comparison_->setText(backup_.comparison());
    comparison_->setVisible(!backup_.comparison().isEmpty());
    backup_.comparison().isEmpty() ? showLabels() : showChanges();
    showTransfer();
}

void LabelBackupPanel::showLabels() {
    app::TextTable texts;
    texts.header = QStringList{tr("Label"), tr("Value")};
    for (const auto& row : backup_.labels()) {
        texts.rows.push_back({row.label, row.after});
    }
    texts.plain_rows = static_cast<int>(texts.rows.size());
    showTexts(*table_, texts);
}

void LabelBackupPanel::showChanges() {
    app::TextTable texts;
    texts.header = QStringList{tr("Label"), tr("Before"), tr("Now"), tr("Kind")};
    for (const auto& row : backup_.changes()) {
        texts.rows.push_back({row.label, row.before, row.after, row.is_setting ? tr("setting") : tr("reading")});
    }
    texts.plain_rows = static_cast<int>(texts.rows.size());
    showTexts(*table_, texts);
}

void LabelBackupPanel::save() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the label backup"), backup_.proposedFileName(), filter());
    if (!path.isEmpty()) {
        backup_.saveFile(path);
    }
}

void LabelBackupPanel::compare() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Choose an earlier label backup"), QString(), filter());
    if (!path.isEmpty()) {
        backup_.compareWith(path);
    }
}

}  // namespace pmts::gui
