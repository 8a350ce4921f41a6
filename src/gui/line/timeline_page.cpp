#include "timeline_page.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"
#include "timeline_csv.hpp"
#include "timeline_view.hpp"
#include "transfer_row.hpp"

#include <QAction>
#include <QBuffer>
#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSplitter>
#include <QTableView>

namespace pmts::gui {
namespace {

constexpr int kRepaint_ms = 100;
constexpr int kDetails_px = 320;
constexpr int kColumn_px[] = {112, 82, 262, 262, 62, 90};

app::DeviceState lampOf(app::LineHealth health) {
    switch (health) {
        case app::LineHealth::kGood: return app::DeviceState::kGood;
        case app::LineHealth::kNote: return app::DeviceState::kIdle;
        case app::LineHealth::kSlow: return app::DeviceState::kWarning;
        case app::LineHealth::kFailed: return app::DeviceState::kFailed;
    }
    return app::DeviceState::kIdle;
}

}  // namespace

void TimelineFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void TimelineFilter::setProblemsOnly(bool on) {
    problems_only_ = on;
    invalidateFilter();
}

QVariant TimelineFilter::data(const QModelIndex& index, int role) const {
    if (role == Qt::DecorationRole && index.column() == app::Timeline::kTime) {
        return lampIcon(lampOf(static_cast<app::LineHealth>(index.data(app::Timeline::kHealthRole).toInt())));
    }
    return QSortFilterProxyModel::data(index, role);
}

bool TimelineFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto health = sourceModel()->index(row, 0, parent).data(app::Timeline::kHealthRole).toInt();
    if (problems_only_ && health < static_cast<int>(app::LineHealth::kSlow)) {
        return false;
    }
    if (text_.isEmpty()) {
        return true;
    }
    for (const int column : {app::Timeline::kWho, app::Timeline::kWhat, app::Timeline::kAnswer, app::Timeline::kOutcome}) {
        if (sourceModel()->index(row, column, parent).data().toString().contains(text_, Qt::CaseInsensitive)) {
            return true;
        }
    }
    return false;
}

TimelinePage::TimelinePage(app::Timeline& timeline, QWidget* parent, app::Threading threading)
    : ListedPage(parent), timeline_(timeline), view_(new TimelineView(timeline, this)), details_(new QLabel(this)),
      said_(new QLabel(this)), saving_(threading) {
    filter_.setSourceModel(&timeline_);
    view_->setObjectName(QStringLiteral("timeline_view"));
    details_->setObjectName(QStringLiteral("timeline_details"));
    details_->setWordWrap(true);
    details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setFixedWidth(kDetails_px);
    details_->setContentsMargins(8, 4, 4, 4);
    said_->setObjectName(QStringLiteral("timeline_said"));
    said_->setWordWrap(true);
    said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    said_->hide();
    auto* const upper = new QWidget(this);
    auto* const row = new QHBoxLayout(upper);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(view_, 1);
    row->addWidget(details_);
    auto* const parts = new QSplitter(Qt::Vertical, this);
    parts->addWidget(upper);
    parts->addWidget(makeTable());
    parts->setChildrenCollapsible(false);
    parts->setSizes({300, 300});
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addWidget(makeTools());
    column->addWidget(parts, 1);
    column->addWidget(said_);
    column->addWidget(makeSavingRow());
    wire();
    showEvent(std::nullopt);
}

QWidget* TimelinePage::makeTools() {
    auto* const tools = new QWidget(this);
    auto* const row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    follow_ = labButton({}, "timeline_follow", tools);
    follow_->setCheckable(true);
    follow_->setChecked(true);
    auto* const closer = labButton(tr("Closer"), "timeline_closer", tools);
    auto* const wider = labButton(tr("Wider"), "timeline_wider", tools);
    auto* const all = labButton(tr("All"), "timeline_all", tools);
    closer->setToolTip(tr("More detail: wheel, Up or +"));
    wider->setToolTip(tr("More time: wheel, Down or −"));
    all->setToolTip(tr("From the oldest to now (0)"));
    text_ = new QLineEdit(tools);
    text_->setObjectName(QStringLiteral("timeline_filter"));
    text_->setPlaceholderText(tr("Show lines that hold this text"));
    text_->setClearButtonEnabled(true);
    text_->setAccessibleName(tr("Filter of the time line"));
    problems_ = new QCheckBox(tr("Problems only"), tools);
    problems_->setObjectName(QStringLiteral("timeline_problems"));
    auto* const save = labButton(tr("Save…"), "timeline_save", tools);
    save->setToolTip(tr("The table as CSV, the lanes as PNG or SVG"));
    for (QWidget* part : {static_cast<QWidget*>(follow_), static_cast<QWidget*>(closer), static_cast<QWidget*>(wider),
                          static_cast<QWidget*>(all)}) {
        row->addWidget(part);
    }
    row->addWidget(text_, 1);
    row->addWidget(problems_);
    row->addWidget(save);
    connect(closer, &QPushButton::clicked, view_, [this] { view_->zoomBy(2.0); });
    connect(wider, &QPushButton::clicked, view_, [this] { view_->zoomBy(0.5); });
    connect(all, &QPushButton::clicked, view_, &TimelineView::showAll);
    connect(save, &QPushButton::clicked, this, &TimelinePage::chooseFile);
    return tools;
}

QWidget* TimelinePage::makeSavingRow() {
    auto* const row = new TransferRow("timeline_save_cancel", this);
    QSizePolicy gives_way = row->sizePolicy();
    gives_way.setRetainSizeWhenHidden(false);
    row->setSizePolicy(gives_way);
    connect(&saving_, &app::FileSaving::transferChanged, row, &TransferRow::showTransfer);
    connect(row, &TransferRow::cancelled, &saving_, &app::FileSaving::cancel);
    connect(&saving_, &app::FileSaving::ended, this, &TimelinePage::say);
    return row;
}

QWidget* TimelinePage::makeTable() {
    table_ = new QTableView(this);
    table_->setObjectName(QStringLiteral("timeline_table"));
    table_->setAccessibleName(tr("Events of the line"));
    table_->setModel(&filter_);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setAlternatingRowColors(true);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setWordWrap(false);
    table_->setShowGrid(false);
    for (int i = 0; i < static_cast<int>(std::size(kColumn_px)); ++i) {
        table_->setColumnWidth(i, kColumn_px[i]);
    }
    table_->horizontalHeader()->setStretchLastSection(true);
    return table_;
}

void TimelinePage::wire() {
    follow_key_ = new QAction(tr("Follow the line"), this);
    follow_key_->setShortcut(Qt::Key_L);
    follow_key_->setEnabled(false);  // until the page is shown
    addAction(follow_key_);
    connect(follow_key_, &QAction::triggered, this, [this] { view_->setFollowing(!view_->isFollowing()); });
    connect(follow_, &QPushButton::clicked, view_, &TimelineView::setFollowing);
    connect(view_, &TimelineView::followingChanged, this, &TimelinePage::showFollowing);
    connect(text_, &QLineEdit::textChanged, &filter_, &TimelineFilter::setText);
    connect(problems_, &QCheckBox::toggled, &filter_, &TimelineFilter::setProblemsOnly);
    connect(view_, &TimelineView::eventChosen, this, [this](quint64 number) {
        showEvent(number);
        const auto& events = timeline_.events();
        const auto row = static_cast<int>(number - events.front().number);
        const QModelIndex index = filter_.mapFromSource(timeline_.index(row, 0));
        table_->setCurrentIndex(index);
    });
    connect(view_, &TimelineView::eventPointed, this, [this](const QString& text) {
        text.isEmpty() ? showEvent(view_->chosen()) : details_->setText(text);
    });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
        if (const app::LineEvent* const event = index.isValid() ? eventOfRow(index.row()) : nullptr) {
            showEvent(event->number);
            if (view_->chosen() != event->number) {
                view_->choose(event->number);
            }
        }
    });
    connect(&timeline_, &QAbstractItemModel::modelReset, this, [this] { showEvent(std::nullopt); });
    connect(&repaint_, &QTimer::timeout, this, &TimelinePage::refresh);
    repaint_.setInterval(kRepaint_ms);
    showFollowing(true);
}

void TimelinePage::entered() {
    repaint_.start();
    follow_key_->setEnabled(true);
    view_->update();
}

void TimelinePage::left() {
    repaint_.stop();
    follow_key_->setEnabled(false);
}

void TimelinePage::showFollowing(bool on) {
    follow_->setChecked(on);
    follow_->setText(on ? tr("Pause (L)") : tr("Follow (L)"));
    follow_->setToolTip(on ? tr("The newest is at the right edge; pause to look at what was")
                           : tr("Show the newest again"));
}

void TimelinePage::refresh() {
    view_->tick();
    if (view_->isFollowing() && isVisible()) {
        table_->scrollToBottom();
    }
}

void TimelinePage::showEvent(std::optional<std::uint64_t> number) {
    const app::LineEvent* const event = number ? timeline_.find(*number) : nullptr;
    details_->setText(event ? timeline_.words().details(*event).join(u'\n')
                            : tr("Point at a bar, or choose a line of the table, to see its bytes and times.\n\n"
                                 "Full bars were answered, hatched ones with a triangle were slow, those with a crossed "
                                 "square failed, hollow ones were cancelled or may stay silent. A cross above the pictures: dropped.\n\n"
                                 "Unasked: a block of the REG key is a stroke, angles that come by themselves are a thin bar; "
                                 "late and doubled answers and noise have a triangle."));
}

const app::LineEvent* TimelinePage::eventOfRow(int row) const {
    const int source = filter_.mapToSource(filter_.index(row, 0)).row();
    const auto& events = timeline_.events();
    return source >= 0 && static_cast<std::size_t>(source) < events.size() ? &events[static_cast<std::size_t>(source)] : nullptr;
}

std::vector<app::LineEvent> TimelinePage::shownEvents() const {
    std::vector<app::LineEvent> events;
    events.reserve(static_cast<std::size_t>(filter_.rowCount()));
    for (int row = 0; row < filter_.rowCount(); ++row) {
        events.push_back(*eventOfRow(row));
    }
    return events;
}

/// Painted here, where the lanes are; words, compression and the disk are the pool's.
app::FileSaving::Make TimelinePage::makerOf(const QString& path) const {
    if (path.endsWith(QLatin1String(".csv"))) {
        return [events = shownEvents(), words = timeline_.words()](const app::FileSaving::Progress& progress) {
            return timelineCsv(events, words, progress);
        };
    }
    if (path.endsWith(QLatin1String(".svg"))) {
        return [drawing = view_->drawing()](const app::FileSaving::Progress&) { return drawing; };
    }
    return [picture = view_->picture()](const app::FileSaving::Progress&) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        picture.save(&buffer, "PNG");
        return bytes;
    };
}

void TimelinePage::save(const QString& path) {
    said_->hide();
    if (const auto begun = saving_.save(path, makerOf(path)); !begun) {
        say(begun.error().sentence());
    }
}

void TimelinePage::say(const QString& sentence) {
    said_->setText(sentence);
    said_->show();
}

void TimelinePage::chooseFile() {
    QString filter;
    const QString filters = tr("Table (*.csv);;Picture (*.png);;Drawing (*.svg)");
    QString path = QFileDialog::getSaveFileName(this, tr("Save the time line"), QStringLiteral("time-line.csv"), filters, &filter);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += filter.section(u'*', 1).section(u')', 0, 0);
    }
    save(path);
}

}  // namespace pmts::gui
