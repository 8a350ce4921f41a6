#include "line_workspace.hpp"

#include "control_page.hpp"
#include "black_box_page.hpp"
#include "instrument_page.hpp"
#include "instructions_page.hpp"
#include "line_page.hpp"
#include "log_page.hpp"
#include "memory_page.hpp"
#include "state_lamp.hpp"
#include "timeline_page.hpp"
#include "workbench_page.hpp"

#include <QHBoxLayout>
#include <QListWidget>
#include <QStackedWidget>

#include <utility>

namespace pmts::gui {
namespace {

constexpr int kList_px = 150;
constexpr int kRow_px = 48;  ///< a gloved finger

}  // namespace

LineWorkspace::LineWorkspace(app::Workbench& bench, QWidget* parent)
    : QWidget(parent), list_(new QListWidget(this)), stack_(new QStackedWidget(this)) {
    list_->setObjectName(QStringLiteral("line_pages"));
    list_->setAccessibleName(tr("Pages of the line"));
    list_->setFixedWidth(kList_px);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(list_);
    row->addWidget(stack_, 1);
    addPages(bench);
    connect(list_, &QListWidget::currentRowChanged, this, &LineWorkspace::choose);
    list_->setCurrentRow(0);
}

/// One line for each page, the most used first.
void LineWorkspace::addPages(app::Workbench& bench) {
    add(new ControlPage(bench, stack_), QStringLiteral("control_page"));
    add(new TimelinePage(*bench.timeline, stack_), QStringLiteral("time_line_page"));
    add(new LogPage(bench.log, LogPage::Least::kEverything, stack_), QStringLiteral("log_page"));
    add(new BlackBoxPage(*bench.black_box, *bench.bug_report, stack_), QStringLiteral("black_box_page"));
    add(new MemoryPage(bench.memory, bench.label_backup, stack_), QStringLiteral("memory_page"));
    add(new InstrumentPage(bench, stack_), QStringLiteral("instrument_page"));
    add(new InstructionsPage(bench.instructions, stack_), QStringLiteral("instructions_page"));
    add(new WorkbenchPage(bench.line_bench, stack_), QStringLiteral("workbench_page"));
}

void LineWorkspace::add(LinePage* page, const QString& object_name) {
    page->setObjectName(object_name);
    auto* const item = new QListWidgetItem(lampIcon(app::DeviceState::kIdle), page->title(), list_);
    item->setSizeHint({kList_px, kRow_px});
    pages_.push_back(page);
    stack_->addWidget(page);
    connect(page, &LinePage::stateChanged, this, [item](app::DeviceState state) {
        item->setIcon(lampIcon(state));
        item->setToolTip(lampText(state));
    });
}

LinePage* LineWorkspace::current() const {
    const int index = list_->currentRow();
    return index < 0 ? nullptr : pages_[static_cast<std::size_t>(index)];
}

void LineWorkspace::openPage(const QString& object_name) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        if (pages_[i]->objectName() == object_name) {
            list_->setCurrentRow(static_cast<int>(i));
        }
    }
}

void LineWorkspace::choose(int index) {
    leave();
    stack_->setCurrentIndex(index);
    if (isVisible()) {
        enter();
    }
}

void LineWorkspace::enter() {
    if (entered_ == nullptr && current() != nullptr) {
        entered_ = current();
        entered_->entered();
    }
}

void LineWorkspace::leave() {
    if (LinePage* const page = std::exchange(entered_, nullptr)) {
        page->left();
    }
}

void LineWorkspace::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    enter();
}

void LineWorkspace::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    leave();
}

}  // namespace pmts::gui
