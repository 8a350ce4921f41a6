#include "method_tools.hpp"

#include "apa_dialog.hpp"
#include "method_report_window.hpp"

#include <QCoreApplication>
#include <QPointer>

namespace pmts::gui {
namespace {

constexpr int kEdge_px = 12;  ///< from the window's corner: the title bar stays on the screen

void bringUp(QWidget& opened, Qt::Alignment side) {
    if (!opened.isVisible()) {
        const QRect window = opened.parentWidget()->frameGeometry();
        const int left = side == Qt::AlignRight ? window.right() - opened.width() - kEdge_px : window.left() + kEdge_px;
        opened.move(left, window.top() + kEdge_px);
    }
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
        bringUp(*opened, Qt::AlignLeft);
    });
    QAction* const apa = tools.addAction(QCoreApplication::translate("MethodTools", "Measure APA…"));
    apa->setObjectName(QStringLiteral("measure_apa"));
    QObject::connect(apa, &QAction::triggered, window, [&bench, window, opened = QPointer<QWidget>()]() mutable {
        if (!opened) {
            opened = new ApaDialog(bench.apa, bench.instrument, bench.preferences, window);
        }
        bringUp(*opened, Qt::AlignRight);  // the live view is at the left
    });
}

}  // namespace pmts::gui
