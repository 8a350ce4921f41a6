#include "method_page_view.hpp"

#include "parts/text_table.hpp"
#include "ui_method_page.h"

namespace pmts::gui {

MethodPageView::MethodPageView(const app::MethodPage& page, const app::MethodReportView& report, QWidget* parent)
    : QWidget(parent), ui_(std::make_unique<Ui::MethodPage>()) {
    ui_->setupUi(this);
    ui_->title->setText(page.title);
    ui_->setting->setText(page.setting);
    ui_->known_error->setText(page.known_error);
    ui_->off_printed->setText(page.off_printed);
    ui_->off_printed->setVisible(!page.off_printed.isEmpty());
    showTexts(*ui_->table, page.table);
    ui_->bars->showBars(page, report.plot_unit);
    ui_->vectors->showVectors(page, report.image_px, report.plot_unit);
    ui_->bars->setVisible(!page.errors.empty());
    ui_->vectors->setVisible(!page.errors.empty());
}

MethodPageView::~MethodPageView() = default;

}  // namespace pmts::gui
