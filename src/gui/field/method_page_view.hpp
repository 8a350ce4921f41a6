#pragma once

#include "pmts/app/field/method_page.hpp"

#include <QWidget>

#include <memory>

namespace Ui {
class MethodPage;
}

namespace pmts::gui {

/// One method of a report: how it was run, its table, its plots.
class MethodPageView : public QWidget {
    Q_OBJECT
public:
    MethodPageView(const app::MethodPage& page, const app::MethodReportView& report, QWidget* parent = nullptr);
    ~MethodPageView() override;

private:
    std::unique_ptr<Ui::MethodPage> ui_;
};

}  // namespace pmts::gui
