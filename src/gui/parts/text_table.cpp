#include "text_table.hpp"

#include <QHeaderView>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr int kRowEdge_px = 6;

bool looksLikeNumber(const QString& text) {
    return !text.isEmpty() && (text[0].isDigit() || text[0] == u'-' || text[0] == u'+');
}

QTableWidgetItem* itemOf(const QString& text, int column, bool sums_up) {
    auto* const item = new QTableWidgetItem(text);
    item->setToolTip(text);
    if (column > 0 && looksLikeNumber(text)) {
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (sums_up) {
        QFont bold = item->font();
        bold.setBold(true);
        item->setFont(bold);
    }
    return item;
}

}  // namespace

void showTexts(QTableWidget& widget, const app::TextTable& texts) {
    widget.clear();
    widget.setColumnCount(static_cast<int>(texts.header.size()));
    widget.setRowCount(static_cast<int>(texts.rows.size()));
    widget.setHorizontalHeaderLabels(texts.header);
    widget.verticalHeader()->hide();
    widget.verticalHeader()->setMinimumSectionSize(widget.fontMetrics().height() + kRowEdge_px);
    widget.verticalHeader()->setDefaultSectionSize(widget.fontMetrics().height() + kRowEdge_px);
    widget.horizontalHeader()->setHighlightSections(false);
    int row = 0;
    for (const QStringList& cells : texts.rows) {
        for (int column = 0; column < cells.size(); ++column) {
            widget.setItem(row, column, itemOf(cells[column], column, row >= texts.plain_rows));
        }
        ++row;
    }
    widget.resizeColumnsToContents();
}

}  // namespace pmts::gui
