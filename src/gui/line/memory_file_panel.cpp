#include "memory_file_panel.hpp"

#include "memory_lines_model.hpp"
#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"
#include "send_file_dialog.hpp"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMessageBox>
#include <QTableView>

namespace pmts::gui {

MemoryFilePanel::MemoryFilePanel(app::MemoryPresenter& memory, const app::LabelBackupPresenter& backup, QWidget* parent)
    : QWidget(parent),
      memory_(memory),
      backup_(backup),
      heading_(labText("memory_heading", this)),
      lines_(new MemoryLinesModel(memory, this)),
      table_(new QTableView(this)) {
    auto* const column = new QVBoxLayout(this);
    QFont bold = heading_->font();
    bold.setBold(true);
    heading_->setFont(bold);
    table_->setObjectName(QStringLiteral("memory_lines"));
    table_->setAccessibleName(tr("Lines of the file"));
    table_->setModel(lines_);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    column->addWidget(heading_);
    column->addWidget(table_, 1);
    column->addWidget(makeVerdict());
    column->addWidget(makeButtons());
    connect(&memory_, &app::MemoryPresenter::documentChanged, this, &MemoryFilePanel::showDocument);
    connect(&memory_, &app::MemoryPresenter::transferChanged, this, &MemoryFilePanel::showEnabled);
    connect(&memory_, &app::MemoryPresenter::listingChanged, this, &MemoryFilePanel::showEnabled);
    connect(&backup_, &app::LabelBackupPresenter::transferChanged, this, &MemoryFilePanel::showEnabled);
    connect(&memory_, &app::MemoryPresenter::nameTaken, this,
            [this](const instrument::MemoryFileId& wanted, const QString& free_name) {
                askForName({wanted.directory, free_name},
                           tr("The instrument has a file %1 already. Nothing is overwritten: send it under another name?")
                               .arg(wanted.name));
            });
    connect(&memory_, &app::MemoryPresenter::badLinesFound, this, &MemoryFilePanel::askAboutBadLines);
    showDocument();
}

QWidget* MemoryFilePanel::makeVerdict() {
    auto* const holder = new QWidget(this);
    auto* const row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    lamp_ = new StateLamp(holder);
    verdict_ = labText("memory_verdict", holder);
    units_ = new QComboBox(holder);
    units_->setObjectName(QStringLiteral("memory_units"));
    units_->setAccessibleName(tr("Units of the file"));
    units_->setMinimumHeight(ActionButton::kLeastSide_px);
    units_->addItem(tr("Units: choose"), 0);
    units_->addItem(tr("gon, metre"), static_cast<int>(protocol::WireAngleUnit::kGon));
    units_->addItem(tr("degrees ddd.mmss, metre"), static_cast<int>(protocol::WireAngleUnit::kDms));
    units_->addItem(tr("decimal degrees, metre"), static_cast<int>(protocol::WireAngleUnit::kDegree));
    units_->addItem(tr("mil, metre"), static_cast<int>(protocol::WireAngleUnit::kMil));
    row->addWidget(lamp_);
    row->addWidget(verdict_, 1);
    row->addWidget(units_);
    connect(units_, &QComboBox::activated, this, &MemoryFilePanel::chooseUnits);
    return holder;
}

QWidget* MemoryFilePanel::makeButtons() {
    auto* const holder = new QWidget(this);
    auto* const row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    open_ = labButton(tr("&Open file…"), "memory_open", holder);
    save_ = labButton(tr("Save &as…"), "memory_save", holder);
    send_ = labButton(tr("Se&nd to the instrument…"), "memory_send", holder);
    take_ = labButton(tr("Take &points into the job"), "memory_take", holder);
    take_->setToolTip(tr("Its points with N, E and elevation become planned points of the open job."));
    for (QPushButton* const button : {open_, save_, send_, take_}) {
        row->addWidget(button);
    }
    connect(open_, &QPushButton::clicked, this, &MemoryFilePanel::open);
    connect(save_, &QPushButton::clicked, this, &MemoryFilePanel::save);
    connect(send_, &QPushButton::clicked, this, &MemoryFilePanel::send);
    connect(take_, &QPushButton::clicked, &memory_, &app::MemoryPresenter::takePoints);
    return holder;
}

void MemoryFilePanel::showDocument() {
    const app::MemoryDocument& document = memory_.document();
    heading_->setText(document.isEmpty() && memory_.documentSource().isEmpty()
                          ? tr("No file yet: read one from the instrument, or open one.")
                          : QStringLiteral("%1  –  %2").arg(document.name(), memory_.documentSource()));
    const app::StatusItem verdict = document.verdict();
    lamp_->setState(verdict.state);
    lamp_->setVisible(!verdict.text.isEmpty());
    verdict_->setText(verdict.details.isEmpty() ? verdict.text : verdict.text + u'\n' + verdict.details);
    units_->setVisible(!document.isEmpty() && !document.hasUnitsOfItsOwn());
    units_->setCurrentIndex(document.units() ? units_->findData(static_cast<int>(document.units()->angle)) : 0);
    lines_->showDocument();
    table_->resizeColumnsToContents();
    showEnabled();
}

void MemoryFilePanel::showEnabled() {
    const bool busy = memory_.transfer().busy;
    const bool has_lines = !memory_.document().file().lines.empty();
    open_->setEnabled(!busy);
    save_->setEnabled(!busy && has_lines);
    send_->setEnabled(!busy && !backup_.transfer().busy && has_lines && memory_.isReachable());
    take_->setEnabled(!busy && has_lines);
}

void MemoryFilePanel::open() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a job or area file"), QString(), app::MemoryPresenter::fileFilter());
    if (!path.isEmpty()) {
        memory_.openFile(path);
    }
}

void MemoryFilePanel::save() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save the file"), memory_.proposedFileName(),
                                                      app::MemoryPresenter::fileFilter());
    if (!path.isEmpty()) {
        memory_.saveFile(path);
    }
}

void MemoryFilePanel::send() {
    const bool is_area = memory_.proposedFileName().endsWith(QLatin1String(".ARE"));
    askForName({is_area ? protocol::Directory::kArea : protocol::Directory::kJob,
                app::MemoryPresenter::proposedName(memory_.document().name() + QStringLiteral(".x"))},
               QString());
}

void MemoryFilePanel::askForName(const instrument::MemoryFileId& proposed, const QString& reason) {
    auto* const dialog = new SendFileDialog(proposed, reason, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, &memory_, [this, dialog] { memory_.upload(dialog->file()); });
    dialog->open();
}

void MemoryFilePanel::askAboutBadLines(const instrument::MemoryFileId& wanted, int count) {
    auto* const box = new QMessageBox(
        QMessageBox::Question, tr("Bad lines"),
        tr("%1 lines are no label=data; the instrument would refuse them. Send the file without them?").arg(count),
        QMessageBox::Cancel, this);
    auto* const send = box->addButton(tr("Send without them"), QMessageBox::AcceptRole);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(send, &QPushButton::clicked, &memory_, [this, wanted] { memory_.upload(wanted, true); });
    box->open();
}

void MemoryFilePanel::chooseUnits(int index) {
    if (const int angle = units_->itemData(index).toInt(); angle != 0) {
        protocol::WireUnits units;
        units.angle = static_cast<protocol::WireAngleUnit>(angle);
        memory_.chooseUnits(units);
    }
}

}  // namespace pmts::gui
