#include "method_tools.hpp"

#include "apa_dialog.hpp"
#include "method_report_window.hpp"

#include <QCoreApplication>
#include <QPointer>

namespace pmts::gui {
namespace {

void bringUp(QWidget& opened) {
    opened.show();
    opened.raise();
    opened.activateWindow();
}

}  // namespace

void addMethodTools(QMenu& tools, app::Workbench& bench, QWidget* window) {
    QAction* const report = tools.addAction(QCoreApplication::translate("MethodTools", "Method report…"));
    report->setObjectName(QStringLiteral("method_report"));
    QObject::connect(report, &QAction::triggered, window, [&bench, window, opened = QPointer<QWidget>()]() mutable {
        if (!opened) {
            opened = new MethodReportWindow(bench.method_report, window);
        }
        bringUp(*opened);
    });
    QAction* const apa = tools.addAction(QCoreApplication::translate("MethodTools", "Measure APA…"));
    apa->setObjectName(QStringLiteral("measure_apa"));
    QObject::connect(apa, &QAction::triggered, window, [&bench, window, opened = QPointer<QWidget>()]() mutable {
        if (!opened) {
            opened = new ApaDialog(bench.apa, bench.instrument, bench.preferences, window);
        }
        bringUp(*opened);
    });
}

}  // namespace pmts::gui
