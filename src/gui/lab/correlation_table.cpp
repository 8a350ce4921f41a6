#include "correlation_table.hpp"

#include "pmts/gui/theme.hpp"

#include <QEvent>
#include <QHeaderView>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr int kLeastCell_px = 26;
constexpr double kWorthColour = 0.3;

QColor mixed(const QColor& ground, const QColor& ink, double share) {
    const auto part = [share](int a, int b) { return static_cast<int>(a + (b - a) * share); };
    return {part(ground.red(), ink.red()), part(ground.green(), ink.green()),
            part(ground.blue(), ink.blue())};
}

}  // namespace

CorrelationTable::CorrelationTable(QWidget* parent) : QTableWidget(parent) {
    setEditTriggers(NoEditTriggers);
    setSelectionMode(NoSelection);
    setTextElideMode(Qt::ElideNone);
    setAccessibleName(tr("Correlation of the parameters, in per cent"));
    horizontalHeader()->setMinimumSectionSize(kLeastCell_px);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setHighlightSections(false);
}

void CorrelationTable::showView(const app::SelfCalibrationView& view) {
    view_ = view;
    fill();
}

void CorrelationTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) {
        fill();
    }
}

void CorrelationTable::fill() {
    const int count = static_cast<int>(view_.correlation.size());
    setRowCount(count);
    setColumnCount(count);
    const Theme& theme = currentTheme();
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            const double value =
                view_.correlation[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            auto* const item =
                new QTableWidgetItem(row == column ? QString() : QString::number(std::lround(100 * value)));
            const double strength =
                row == column ? 0.0 : std::max(0.0, (std::abs(value) - kWorthColour) / (1 - kWorthColour));
            const QColor ground = mixed(theme.field, theme.accent, strength);
            item->setBackground(row == column ? theme.border : ground);
            item->setForeground(contrastRatio(ground, theme.text) >= contrastRatio(ground, theme.on_accent)
                                    ? theme.text
                                    : theme.on_accent);
            item->setTextAlignment(Qt::AlignCenter);
            item->setToolTip(tr("%1 and %2: %3 %")
                                 .arg(view_.correlated[row], view_.correlated[column])
                                 .arg(100 * value, 0, 'f', 1));
            setItem(row, column, item);
        }
    }
    setHorizontalHeaderLabels(view_.symbols);
    setVerticalHeaderLabels(view_.symbols);
}

}  // namespace pmts::gui
