#include "line_workspace.hpp"

#include "black_box_page.hpp"
#include "control_page.hpp"
#include "instructions_page.hpp"
#include "instrument_page.hpp"
#include "log_page.hpp"
#include "memory_page.hpp"
#include "window/page_list.hpp"
#include "timeline_page.hpp"
#include "workbench_page.hpp"

#include <QHBoxLayout>
#include <QStackedWidget>

namespace pmts::gui {

LineWorkspace::LineWorkspace(app::Workbench& bench, QWidget* parent) : QWidget(parent) {
    auto* const stack = new QStackedWidget(this);
    list_ = new PageList(*stack, this);
    list_->setObjectName(QStringLiteral("line_pages"));
    list_->setAccessibleName(tr("Pages of the line"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(list_);
    row->addWidget(stack, 1);

    // The most used first.
    const auto add = [this](ListedPage* page, const char* name) { list_->add(page, page, QLatin1String(name)); };
    add(new ControlPage(bench, stack), "control_page");
    add(new TimelinePage(*bench.timeline, stack), "time_line_page");
    add(new LogPage(bench.log, LogPage::Least::kEverything, stack), "log_page");
    add(new BlackBoxPage(*bench.black_box, *bench.bug_report, stack), "black_box_page");
    add(new MemoryPage(bench.memory, bench.label_backup, stack), "memory_page");
    add(new InstrumentPage(bench.health, bench.axis_test, bench.two_faces, stack), "instrument_page");
    add(new InstructionsPage(bench.instructions, stack), "instructions_page");
    add(new WorkbenchPage(bench.line_bench, stack), "workbench_page");
    list_->setCurrentRow(0);
}

ListedPage* LineWorkspace::current() const { return list_->chosenPage(); }

void LineWorkspace::openPage(const QString& object_name) { list_->openPage(object_name); }

void LineWorkspace::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    list_->setWorkspaceShown(true);
}

void LineWorkspace::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    list_->setWorkspaceShown(false);
}

}  // namespace pmts::gui
