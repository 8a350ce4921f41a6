#include "instructions_page.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"
#include "table_editor.hpp"

#include <QCheckBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QFrame>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSignalBlocker>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QStyle>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr int kRow_px = 44;  ///< a gloved finger in a list
constexpr int kShownRoutines = 3;
constexpr int kShownProblems = 3;

enum Column { kNumber, kSent, kReceived, kAt, kTook, kVerdict, kColumns };

QListWidget* rowList(const char* object_name, const QString& accessible_name, int rows, QWidget* parent) {
    auto* const list = new QListWidget(parent);
    list->setObjectName(QLatin1String(object_name));
    list->setAccessibleName(accessible_name);
    list->setFixedHeight(rows * kRow_px + 2 * list->frameWidth() + 2);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setTextElideMode(Qt::ElideRight);
    list->setWordWrap(true);
    return list;
}

QListWidgetItem* addRow(QListWidget& list, const QString& text, int line) {
    auto* const item = new QListWidgetItem(text, &list);
    item->setSizeHint({0, kRow_px});
    item->setData(Qt::UserRole, line);
    item->setToolTip(text);
    return item;
}

void setWrong(QLineEdit& field, bool is_wrong) {
    if (field.property("wrong").toBool() != is_wrong) {
        field.setProperty("wrong", is_wrong);
        field.style()->unpolish(&field);
        field.style()->polish(&field);
    }
}

}  // namespace

InstructionsPage::InstructionsPage(app::InstructionsPresenter& instructions, QWidget* parent)
    : ListedPage(parent), instructions_(instructions) {
    auto* const column = new QVBoxLayout(this);
    auto* const split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->addWidget(makeTextSide());
    split->addWidget(makeRunSide());
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 1);
    column->addWidget(split);
    editor_->setPlainText(instructions_.text());  // nothing to undo yet
    wire();
    addKeys();
    showTable();
    showChosen();
    showRun();
}

QWidget* InstructionsPage::makeTextSide() {
    auto* const side = new QWidget(this);
    auto* const column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 4, 0);
    auto* const buttons = new QHBoxLayout;
    save_ = labButton(tr("Save"), "instructions_save", side);
    save_->setToolTip(tr("Save your copy of the table (Ctrl+S)"));
    revert_ = labButton(tr("Revert"), "instructions_revert", side);
    revert_->setToolTip(tr("Drop what was not saved (Ctrl+R); undo brings it back"));
    auto* const import = labButton(tr("Import…"), "instructions_import", side);
    auto* const exporting = labButton(tr("Export…"), "instructions_export", side);
    for (auto* const button : {save_, revert_, import, exporting}) {
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    file_ = labText("instructions_file", side);
    file_->setProperty("muted", true);
    editor_ = new TableEditor(side);
    editor_->setObjectName(QStringLiteral("instructions_text"));
    editor_->setAccessibleName(tr("Instruction table"));
    problems_ = rowList("instructions_problems", tr("Problems of the table"), kShownProblems, side);
    column->addLayout(buttons);
    column->addWidget(file_);
    column->addWidget(editor_, 1);
    column->addWidget(problems_);
    connect(import, &QPushButton::clicked, this, &InstructionsPage::importTable);
    connect(exporting, &QPushButton::clicked, this, &InstructionsPage::exportTable);
    return side;
}

QWidget* InstructionsPage::makeRunSide() {
    auto* const side = new QWidget(this);
    auto* const column = new QVBoxLayout(side);
    column->setContentsMargins(4, 0, 0, 0);
    routines_ = rowList("instructions_routines", tr("Routines of the table"), kShownRoutines, side);
    note_ = labText("instructions_note", side);
    auto* const fields = new QWidget(side);
    fields_ = new QFormLayout(fields);
    fields_->setContentsMargins(0, 0, 0, 0);
    believes_ = new QCheckBox(tr("The simulated base answers as the table expects"), side);
    believes_->setObjectName(QStringLiteral("instructions_believes"));
    believes_->setToolTip(tr("For routines that the simulated base does not know: it answers with the first expected reply."));
    believes_->setMinimumHeight(kRow_px);
    auto* const buttons = new QHBoxLayout;
    dry_run_ = labButton(tr("Dry run"), "instructions_dry_run", side);
    run_ = labButton(tr("Run"), "instructions_run", side);
    dry_run_->setToolTip(tr("The text of the editor, against a simulated base"));
    run_->setToolTip(tr("The table as it was last saved without a problem, on the connected base"));
    cancel_ = labButton(tr("Cancel"), "instructions_cancel", side);
    cancel_->setToolTip(tr("The step on the line is waited for, steps marked \"always\" still run (Esc)"));
    for (auto* const button : {dry_run_, run_, cancel_}) {
        buttons->addWidget(button, 1);
    }
    trouble_ = labText("instructions_trouble", side);
    trouble_->setProperty("muted", true);
    confirmation_ = makeConfirmation();
    steps_ = new QTableWidget(0, kColumns, side);
    steps_->setObjectName(QStringLiteral("instructions_steps"));
    steps_->setAccessibleName(tr("Steps of the routine"));
    steps_->setHorizontalHeaderLabels({tr("Step"), tr("Sent"), tr("Received"), tr("At"), tr("Took"), tr("Verdict")});
    steps_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    steps_->horizontalHeader()->setStretchLastSection(true);
    steps_->verticalHeader()->hide();
    steps_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    steps_->setSelectionBehavior(QAbstractItemView::SelectRows);
    steps_->setSelectionMode(QAbstractItemView::SingleSelection);
    auto* const ending = new QHBoxLayout;
    lamp_ = new StateLamp(side);
    outcome_ = labText("instructions_outcome", side);
    ending->addWidget(lamp_);
    ending->addWidget(outcome_, 1);
    column->addWidget(routines_);
    column->addWidget(note_);
    column->addWidget(fields);
    column->addWidget(believes_);
    column->addLayout(buttons);
    column->addWidget(confirmation_);
    column->addWidget(trouble_);
    column->addLayout(ending);
    column->addWidget(steps_, 1);
    return side;
}

/// The note of a routine, before it runs on hardware for the first time.
QFrame* InstructionsPage::makeConfirmation() {
    auto* const frame = new QFrame(this);
    frame->setObjectName(QStringLiteral("instructions_confirmation"));
    frame->setFrameShape(QFrame::StyledPanel);
    auto* const column = new QVBoxLayout(frame);
    confirmation_text_ = labText("instructions_confirmation_text", frame);
    auto* const row = new QHBoxLayout;
    auto* const go = labButton(tr("Run on the base"), "instructions_confirm", frame);
    go->setToolTip(tr("Sends the routine to the connected instrument (Space)"));
    auto* const leave = labButton(tr("Not now"), "instructions_not_now", frame);
    row->addWidget(go, 1);
    row->addWidget(leave, 1);
    column->addWidget(confirmation_text_);
    column->addLayout(row);
    frame->hide();
    connect(go, &QPushButton::clicked, this, [this] {
        instructions_.confirmNote();
        run();
    });
    connect(leave, &QPushButton::clicked, frame, &QFrame::hide);
    return frame;
}

void InstructionsPage::wire() {
    using Presenter = app::InstructionsPresenter;
    connect(editor_, &QPlainTextEdit::textChanged, this, [this] {
        if (!is_showing_text_) {
            instructions_.setText(editor_->toPlainText());
        }
    });
    connect(save_, &QPushButton::clicked, &instructions_, &Presenter::save);
    connect(revert_, &QPushButton::clicked, &instructions_, &Presenter::revert);
    connect(dry_run_, &QPushButton::clicked, &instructions_, &Presenter::startDryRun);
    connect(run_, &QPushButton::clicked, this, &InstructionsPage::run);
    connect(cancel_, &QPushButton::clicked, &instructions_, &Presenter::cancel);
    connect(believes_, &QCheckBox::toggled, &instructions_, &Presenter::setBelievesTable);
    connect(problems_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { editor_->jumpTo(item->data(Qt::UserRole).toInt()); });
    connect(routines_, &QListWidget::currentTextChanged, &instructions_, &Presenter::choose);
    connect(routines_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { editor_->jumpTo(item->data(Qt::UserRole).toInt()); });
    connect(steps_, &QTableWidget::cellClicked, this, [this](int row) {
        const auto& steps = instructions_.steps();
        if (static_cast<std::size_t>(row) < steps.size()) {
            editor_->jumpTo(steps[static_cast<std::size_t>(row)].line);
        }
    });
    connect(&instructions_, &Presenter::textChanged, this, &InstructionsPage::showText);
    connect(&instructions_, &Presenter::tableChanged, this, &InstructionsPage::showTable);
    connect(&instructions_, &Presenter::chosenChanged, this, &InstructionsPage::showChosen);
    connect(&instructions_, &Presenter::runChanged, this, &InstructionsPage::showRun);
}

void InstructionsPage::addKeys() {
    const auto key = [this](const QKeySequence& keys, QPushButton* button) {
        connect(new QShortcut(keys, this), &QShortcut::activated, button, [button] { button->click(); });
    };
    key(QKeySequence::Save, save_);
    key(Qt::CTRL | Qt::Key_R, revert_);
    key(Qt::Key_F5, dry_run_);
    key(Qt::Key_F6, run_);
    dry_run_->setText(tr("Dry run (F5)"));
    run_->setText(tr("Run (F6)"));
    cancel_->setText(tr("Cancel (Esc)"));
}

void InstructionsPage::entered() { editor_->setFocus(); }

/// Undo brings back what Revert, Import or another program replaced.
void InstructionsPage::showText() {
    if (editor_->toPlainText() != instructions_.text()) {
        const QScopedValueRollback showing(is_showing_text_, true);
        QTextCursor whole(editor_->document());
        whole.select(QTextCursor::Document);
        whole.insertText(instructions_.text());
        editor_->moveCursor(QTextCursor::Start);
    }
}

void InstructionsPage::showTable() {
    file_->setText(instructions_.fileSentence());
    save_->setEnabled(instructions_.isModified());
    revert_->setEnabled(instructions_.isModified());
    std::map<int, QString> by_line;
    problems_->clear();
    for (const auto& problem : instructions_.table().problems) {
        auto& sentence = by_line[problem.line];
        sentence += (sentence.isEmpty() ? QString() : QStringLiteral("\n")) + problem.sentence;
        addRow(*problems_, tr("Line %1: %2").arg(problem.line).arg(problem.sentence), problem.line);
    }
    problems_->setVisible(!by_line.empty());
    editor_->setProblems(std::move(by_line));
    showRoutines();
}

void InstructionsPage::showRoutines() {
    const QSignalBlocker quiet(routines_);
    routines_->clear();
    for (const auto& routine : instructions_.table().routines) {
        auto* const item = addRow(*routines_, QString::fromStdString(routine.name), routine.line);
        if (&routine == instructions_.chosen()) {
            routines_->setCurrentItem(item);
        }
    }
}

void InstructionsPage::showChosen() {
    note_->setText(instructions_.note());
    note_->setVisible(!instructions_.note().isEmpty());
    confirmation_->hide();
    showFields();
}

void InstructionsPage::showFields() {
    const auto fields = instructions_.fields();
    QStringList shown;  // of another range the usual number is another one too
    for (const auto& field : fields) {
        shown << field.name + u'\n' + field.range;
    }
    if (shown != shown_fields_) {
        shown_fields_ = shown;
        while (fields_->rowCount() > 0) {
            fields_->removeRow(0);
        }
        for (const auto& field : fields) {
            auto* const edit = new QLineEdit(field.text, this);
            edit->setObjectName(QStringLiteral("instructions_field_") + field.name);
            edit->setPlaceholderText(field.range.isEmpty() ? tr("a number") : field.range);
            edit->setMinimumHeight(ActionButton::kLeastSide_px);
            connect(edit, &QLineEdit::textEdited, this,
                    [this, name = field.name](const QString& text) { instructions_.setField(name, text); });
            fields_->addRow(field.range.isEmpty() ? field.name : tr("%1 (%2)").arg(field.name, field.range), edit);
        }
    }
    for (int i = 0; i < static_cast<int>(fields.size()); ++i) {
        if (auto* const edit = qobject_cast<QLineEdit*>(fields_->itemAt(i, QFormLayout::FieldRole)->widget())) {
            setWrong(*edit, !fields[static_cast<std::size_t>(i)].is_right);
        }
    }
}

void InstructionsPage::run() {
    if (!instructions_.runTrouble().isEmpty()) {
        return;
    }
    if (instructions_.mustConfirmNote()) {
        const QString question = tr("%1\nRun it on the connected base? %2").arg(instructions_.runNote(), instructions_.runSentence());
        confirmation_text_->setText(question.trimmed());
        confirmation_->show();
        confirmation_->findChild<QPushButton*>(QStringLiteral("instructions_confirm"))->setFocus();
        return;
    }
    confirmation_->hide();
    instructions_.startRun();
}

void InstructionsPage::showRun() {
    using Running = app::InstructionsPresenter::Running;
    const bool busy = instructions_.running() != Running::kNothing;
    dry_run_->setEnabled(instructions_.dryRunTrouble().isEmpty());
    run_->setEnabled(instructions_.runTrouble().isEmpty());
    cancel_->setEnabled(busy);
    routines_->setEnabled(!busy);
    const QString trouble = busy ? QString() : instructions_.runTrouble();
    const QString sentence = busy ? QString() : instructions_.runSentence();
    trouble_->setText(trouble.isEmpty() ? sentence : tr("Run: %1").arg(trouble));
    trouble_->setVisible(!trouble_->text().isEmpty());
    const app::StatusItem outcome = instructions_.outcome();
    lamp_->setState(outcome.state);
    lamp_->setVisible(!outcome.text.isEmpty());
    outcome_->setText(outcome.details.isEmpty() ? outcome.text : QStringLiteral("%1. %2").arg(outcome.text, outcome.details));
    showSteps();
    const bool is_broken = !instructions_.table().problems.empty() && outcome.state == app::DeviceState::kIdle;
    Q_EMIT stateChanged(is_broken ? app::DeviceState::kWarning : outcome.state);
}

void InstructionsPage::showSteps() {
    const auto& steps = instructions_.steps();
    steps_->setRowCount(static_cast<int>(steps.size()));
    for (int row = 0; row < steps_->rowCount(); ++row) {
        const auto& step = steps[static_cast<std::size_t>(row)];
        const QStringList texts{QString::number(row + 1), step.sent, step.received, step.at, step.took, step.verdict};
        for (int column = 0; column < kColumns; ++column) {
            auto* item = steps_->item(row, column);
            if (item == nullptr) {
                item = new QTableWidgetItem;
                steps_->setItem(row, column, item);
            }
            item->setText(texts[column]);
            item->setToolTip(texts[column]);
        }
        steps_->item(row, kNumber)->setIcon(lampIcon(step.state));
        if (step.state == app::DeviceState::kBusy) {
            steps_->scrollToItem(steps_->item(row, kNumber));
        }
    }
}

void InstructionsPage::importTable() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import an instruction table"), {},
                                                      tr("Instruction tables (*.txt);;All files (*)"));
    if (!path.isEmpty()) {
        instructions_.importFrom(path);
    }
}

void InstructionsPage::exportTable() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export the instruction table"),
                                                      QStringLiteral("instructions.txt"), tr("Instruction tables (*.txt)"));
    if (!path.isEmpty()) {
        instructions_.exportTo(path);
    }
}

}  // namespace pmts::gui
