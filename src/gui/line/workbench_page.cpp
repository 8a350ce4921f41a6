#include "workbench_page.hpp"

#include "framing_panel.hpp"
#include "parts/lab_parts.hpp"
#include "match_panel.hpp"
#include "window/progress_overlay.hpp"
#include "signal_view.hpp"
#include "parts/state_lamp.hpp"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTableView>
#include <QTableWidget>

namespace pmts::gui {
namespace {

enum PinColumn { kPin, kUse, kChanges, kHigh, kPinColumns };
constexpr int kRow_px = 28;
constexpr int kMiddle_px = 244;
constexpr int kTimeWidth_px = 110, kWayWidth_px = 70, kTextWidth_px = 420, kDoubtWidth_px = 60;

QString useText(protocol::LineUse use) {
    switch (use) {
        case protocol::LineUse::kConstant:
            return WorkbenchPage::tr("constant");
        case protocol::LineUse::kSwitching:
            return WorkbenchPage::tr("switching");
        case protocol::LineUse::kData:
            break;
    }
    return WorkbenchPage::tr("data");
}

app::DeviceState lampOf(const app::FoundLine& line) {
    if (line.activity.use != protocol::LineUse::kData) {
        return app::DeviceState::kIdle;
    }
    return line.is_decoded && line.unsure > 0 ? app::DeviceState::kWarning : app::DeviceState::kGood;
}

/// The first local file that is dragged; empty: none.
QString draggedFile(const QMimeData& data) {
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            return url.toLocalFile();
        }
    }
    return {};
}

}  // namespace

WorkbenchPage::WorkbenchPage(app::LineBenchPresenter& bench, QWidget* parent) : ListedPage(parent), bench_(bench) {
    setAcceptDrops(true);
    auto* const column = new QVBoxLayout(this);
    column->setSpacing(6);
    column->addWidget(makeBar());
    summary_ = labText("bench_summary", this);
    column->addWidget(summary_);
    column->addWidget(makeMiddle());
    signal_ = new SignalView(this);
    signal_->setObjectName(QStringLiteral("bench_signal"));
    column->addWidget(signal_, 2);
    makeTalk();
    column->addWidget(talk_, 3);
    progress_ = new ProgressOverlay(this);
    wire();
    addKeys();
    showAll();
    showBusy();
}

QWidget* WorkbenchPage::makeBar() {
    auto* const bar = new QWidget(this);
    import_ = labButton(tr("Import… (Ctrl+I)"), "bench_import", bar);
    import_->setToolTip(tr("A recording; it can be dropped on the page as well"));
    format_ = new QComboBox(bar);
    format_->setObjectName(QStringLiteral("bench_format"));
    format_->setAccessibleName(tr("What the file is read as"));
    format_->setToolTip(format_->accessibleName());
    format_->addItems({tr("Told from the file"), tr("Runs as text"), tr("CSV"), tr("VCD"), tr("Samples"),
                       tr("Log or black box of PMTS"), tr("Bytes")});
    rate_ = new QLineEdit(bar);
    rate_->setObjectName(QStringLiteral("bench_rate"));
    rate_->setAccessibleName(tr("Samples each second"));
    rate_->setToolTip(tr("Samples each second, where the file does not say; Enter reads the file again"));
    rate_->setPlaceholderText(tr("Samples a second, 1 MHz"));
    rate_->setMaximumWidth(180);
    save_ = labButton(tr("Save as table… (Ctrl+S)"), "bench_save", bar);
    save_->setToolTip(tr("Every command and reply becomes a routine of an instruction table, the names its remarks"));
    search_ = new QLineEdit(bar);
    search_->setObjectName(QStringLiteral("bench_search"));
    search_->setAccessibleName(tr("Search text or bytes"));
    search_->setToolTip(tr("Text, <CR> and its kin, bytes such as 0D 41, or [? for what is not sure"));
    search_->setPlaceholderText(tr("Search (Ctrl+F): 96.1, <CR>, 0D 41, [?"));
    previous_ = labButton(tr("▲ Shift+F3"), "bench_previous", bar);
    next_ = labButton(tr("▼ F3"), "bench_next", bar);
    search_sentence_ = new QLabel(bar);
    search_sentence_->setObjectName(QStringLiteral("bench_search_sentence"));
    auto* const row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* field : std::initializer_list<QWidget*>{format_, rate_, search_}) {
        field->setMinimumHeight(ActionButton::kLeastSide_px);
    }
    for (QWidget* part : std::initializer_list<QWidget*>{import_, format_, rate_, save_}) {
        row->addWidget(part);
    }
    row->addWidget(search_, 1);
    row->addWidget(previous_);
    row->addWidget(next_);
    row->addWidget(search_sentence_);
    search_sentence_->hide();
    return bar;
}

QWidget* WorkbenchPage::makeMiddle() {
    auto* const middle = new QWidget(this);
    pins_ = new QTableWidget(0, kPinColumns, middle);
    pins_->setObjectName(QStringLiteral("bench_pins"));
    pins_->setAccessibleName(tr("Pins of the recording"));
    pins_->setHorizontalHeaderLabels({tr("Pin"), tr("Class"), tr("Changes"), tr("High")});
    pins_->setSelectionBehavior(QAbstractItemView::SelectRows);
    pins_->setSelectionMode(QAbstractItemView::SingleSelection);
    pins_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    pins_->verticalHeader()->hide();
    pins_->verticalHeader()->setDefaultSectionSize(kRow_px);
    pins_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    pins_->horizontalHeader()->setSectionResizeMode(kPin, QHeaderView::Stretch);
    framing_ = new FramingPanel(bench_, middle);
    matches_ = new MatchPanel(bench_, middle);
    auto* const row = new QHBoxLayout(middle);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addWidget(pins_, 5);
    row->addWidget(framing_, 4);
    row->addWidget(matches_, 5);
    middle->setFixedHeight(kMiddle_px);
    return middle;
}

void WorkbenchPage::makeTalk() {
    talk_ = new QTableView(this);
    talk_->setObjectName(QStringLiteral("bench_talk"));
    talk_->setAccessibleName(tr("Decoded lines, as text and as bytes"));
    talk_->setModel(&bench_.talk());
    talk_->setSelectionBehavior(QAbstractItemView::SelectRows);
    talk_->setSelectionMode(QAbstractItemView::SingleSelection);
    talk_->verticalHeader()->hide();
    talk_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    talk_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    talk_->horizontalHeader()->setHighlightSections(false);
    talk_->setColumnWidth(app::TalkModel::kTime, kTimeWidth_px);
    talk_->setColumnWidth(app::TalkModel::kSide, kWayWidth_px);
    talk_->setColumnWidth(app::TalkModel::kText, kTextWidth_px);
    talk_->setColumnWidth(app::TalkModel::kDoubt, kDoubtWidth_px);
    talk_->horizontalHeader()->setSectionResizeMode(app::TalkModel::kHex, QHeaderView::Stretch);
    talk_->setWordWrap(false);
}

void WorkbenchPage::wire() {
    connect(import_, &QPushButton::clicked, this, &WorkbenchPage::chooseFile);
    connect(save_, &QPushButton::clicked, this, &WorkbenchPage::saveTable);
    const auto again = [this] {
        const int format = format_->currentIndex();
        bench_.importAgain(format > 0 ? std::optional(static_cast<protocol::CaptureFormat>(format - 1)) : std::nullopt,
                           rate_->text());
    };
    connect(format_, &QComboBox::activated, this, again);
    connect(rate_, &QLineEdit::returnPressed, this, again);
    connect(search_, &QLineEdit::returnPressed, next_, &QPushButton::click);
    connect(next_, &QPushButton::clicked, this, [this] { bench_.search(search_->text(), true); });
    connect(previous_, &QPushButton::clicked, this, [this] { bench_.search(search_->text(), false); });
    connect(&bench_, &app::LineBenchPresenter::searched, this, &WorkbenchPage::showSearched);
    connect(&bench_, &app::LineBenchPresenter::changed, this, &WorkbenchPage::showAll);
    connect(&bench_, &app::LineBenchPresenter::busyChanged, this, &WorkbenchPage::showBusy);
    connect(&bench_, &app::LineBenchPresenter::progressed, this,
            [this](double share) { progress_->showBusy(bench_.reason(), share); });
    connect(progress_, &ProgressOverlay::cancelled, &bench_, &app::LineBenchPresenter::cancel);
    connect(pins_, &QTableWidget::currentCellChanged, this, [this](int row) { framing_->showLine(row); });
    connect(signal_, &SignalView::sampleClicked, this, [this](std::uint64_t sample) { showRow(bench_.talk().rowAt(sample)); });
    connect(talk_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (row.isValid()) {
            const auto [from, to] = bench_.talk().samplesOf(row.row());
            signal_->select(from, to);
        }
    });
}

void WorkbenchPage::addKeys() {
    const auto key = [this](const QKeySequence& keys, auto slot) {
        new QShortcut(keys, this, slot);  // works while the page is seen
    };
    key(Qt::CTRL | Qt::Key_I, [this] { chooseFile(); });
    key(Qt::CTRL | Qt::Key_S, [this] { saveTable(); });
    key(Qt::CTRL | Qt::Key_F, [this] {
        search_->setFocus();
        search_->selectAll();
    });
    key(Qt::Key_F3, [this] { next_->click(); });
    key(Qt::SHIFT | Qt::Key_F3, [this] { previous_->click(); });
}

void WorkbenchPage::showBusy() {
    if (bench_.isBusy()) {
        progress_->showBusy(bench_.reason(), 0.0);
    } else {
        progress_->hide();
    }
    import_->setEnabled(!bench_.isBusy());
    for (QWidget* field : std::initializer_list<QWidget*>{format_, rate_}) {
        field->setEnabled(!bench_.path().isEmpty());
    }
    Q_EMIT stateChanged(bench_.state());
}

void WorkbenchPage::showAll() {
    const auto& findings = bench_.findings();
    QString text = bench_.summary();
    if (findings) {
        text = QStringLiteral("%1: %2").arg(QFileInfo(findings->recording->path).fileName(), text);
    }
    const QStringList doubts = bench_.doubts();
    summary_->setText(doubts.isEmpty() ? text : QStringLiteral("%1 %2").arg(text, doubts.size() == 1 ? doubts.front() : tr("%1 (and %2 more)").arg(doubts.front()).arg(doubts.size() - 1)));
    summary_->setToolTip(doubts.join(u'\n'));
    for (QWidget* part : std::initializer_list<QWidget*>{save_, search_, previous_, next_}) {
        part->setEnabled(findings != nullptr);
    }
    showPins();
    signal_->showFindings(findings);
    Q_EMIT stateChanged(bench_.state());
}

void WorkbenchPage::showPins() {
    const auto& findings = bench_.findings();
    const int kept = pins_->currentRow();
    int busiest = 0;
    {
        const QSignalBlocker quiet(pins_);
        pins_->setRowCount(findings ? static_cast<int>(findings->lines.size()) : 0);
        for (int row = 0; row < pins_->rowCount(); ++row) {
            const app::FoundLine& line = findings->lines[static_cast<std::size_t>(row)];
            const QString name = findings->recording->capture.names.value(row);
            const QStringList texts{name.isEmpty() ? QString::number(row) : QStringLiteral("%1 %2").arg(row).arg(name),
                                    line.is_decoded ? tr("%1, decoded").arg(useText(line.activity.use)) : useText(line.activity.use),
                                    QString::number(line.activity.changes), tr("%1 %").arg(100.0 * line.activity.high_share, 0, 'f', 0)};
            for (int column = 0; column < kPinColumns; ++column) {
                auto* const item = new QTableWidgetItem(texts[column]);
                item->setToolTip(texts[column]);
                if (column == kUse) {
                    item->setIcon(lampIcon(lampOf(line)));
                }
                pins_->setItem(row, column, item);
            }
            busiest = line.is_decoded && busiest == 0 ? row : busiest;
        }
    }
    const bool keep = kept >= 0 && kept < pins_->rowCount();
    pins_->setCurrentCell(keep ? kept : busiest, kPin);
    framing_->showLine(pins_->currentRow());
}

void WorkbenchPage::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import a recording"), {}, app::LineBenchPresenter::fileFilter());
    if (!path.isEmpty()) {
        import(path);
    }
}

/// Another file: what was said about the last one does not hold.
void WorkbenchPage::import(const QString& path) {
    format_->setCurrentIndex(0);
    rate_->clear();
    bench_.import(path);
}

void WorkbenchPage::saveTable() {
    if (!bench_.findings() || bench_.isBusy()) {
        return;
    }
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Save as instruction table"), tr("Name of the routine: letters, digits and _"),
                                               QLineEdit::Normal, QStringLiteral("seen"), &accepted);
    if (!accepted) {
        return;
    }
    const QString path = QFileDialog::getSaveFileName(this, tr("Save as instruction table"), bench_.suggestedTablePath(name),
                                                      tr("Instruction tables (*.txt)"));
    if (!path.isEmpty()) {
        bench_.saveTable(path, name);
    }
}

void WorkbenchPage::showSearched(qsizetype character) {
    search_sentence_->setText(bench_.searchSentence());
    search_sentence_->setVisible(!bench_.searchSentence().isEmpty());
    if (character >= 0) {
        showRow(bench_.talk().rowOf(static_cast<std::size_t>(character)));
    }
}

void WorkbenchPage::showRow(int row) {
    if (row >= 0) {
        const QModelIndex index = bench_.talk().index(row, app::TalkModel::kText);
        talk_->setCurrentIndex(index);
        talk_->scrollTo(index, QAbstractItemView::PositionAtCenter);
    }
}

void WorkbenchPage::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedFile(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void WorkbenchPage::dropEvent(QDropEvent* event) {
    import(draggedFile(*event->mimeData()));
    event->acceptProposedAction();
}

}  // namespace pmts::gui
