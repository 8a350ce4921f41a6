#include "log_page.hpp"

#include "ui_log_page.h"

#include <QHeaderView>
#include <QScrollBar>

namespace pmts::gui {
namespace {

int rankOf(int level) {
    switch (level) {
        case QtDebugMsg:
            return 0;
        case QtWarningMsg:
            return 2;
        case QtCriticalMsg:
        case QtFatalMsg:
            return 3;
        default:
            return 1;
    }
}

}  // namespace

void LogFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void LogFilter::setCategory(const QString& category) {
    category_ = category;
    invalidateFilter();
}

void LogFilter::setLeastRank(int rank) {
    least_rank_ = rank;
    invalidateFilter();
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex line = sourceModel()->index(row, app::LogModel::kText, parent);
    return rankOf(line.data(app::LogModel::kLevelRole).toInt()) >= least_rank_ &&
           (category_.isEmpty() || line.data(app::LogModel::kCategoryRole).toString() == category_) &&
           (text_.isEmpty() || line.data().toString().contains(text_, Qt::CaseInsensitive));
}

LogPage::LogPage(app::LogModel& log, Least least, QWidget* parent)
    : ListedPage(parent), log_(log), ui_(std::make_unique<Ui::LogPage>()) {
    ui_->setupUi(this);
    filter_.setSourceModel(&log_);
    ui_->table->setModel(&filter_);
    ui_->table->verticalHeader()->hide();
    ui_->table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    ui_->table->horizontalHeader()->setSectionResizeMode(app::LogModel::kText, QHeaderView::Stretch);
    ui_->category->addItem(tr("Every category"), QString());
    ui_->level->addItems({tr("With the wire"), tr("Without the wire"), tr("Warnings"), tr("Problems")});
    ui_->level->setCurrentIndex(static_cast<int>(least));
    filter_.setLeastRank(static_cast<int>(least));
    ui_->path->setText(log_.filePath());
    ui_->path->setToolTip(ui_->path->text());
    connect(ui_->filter, &QLineEdit::textChanged, &filter_, &LogFilter::setText);
    connect(ui_->category, &QComboBox::currentIndexChanged, this,
            [this] { filter_.setCategory(ui_->category->currentData().toString()); });
    connect(ui_->level, &QComboBox::currentIndexChanged, &filter_, &LogFilter::setLeastRank);
    connect(&log_, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) { noteCategories(first, last); });
    connect(&filter_, &QAbstractItemModel::rowsInserted, this, &LogPage::followNewest);
    noteCategories(0, log_.rowCount() - 1);
    followNewest();
}

LogPage::~LogPage() = default;

void LogPage::noteCategories(int first, int last) {
    for (int row = first; row <= last; ++row) {
        const QString category = log_.index(row, 0).data(app::LogModel::kCategoryRole).toString();
        if (!category.isEmpty() && ui_->category->findData(category) < 0) {
            ui_->category->addItem(category, category);
        }
    }
}

void LogPage::followNewest() {
    if (ui_->follow->isChecked() && isVisible()) {
        ui_->table->scrollToBottom();
    }
}

}  // namespace pmts::gui
