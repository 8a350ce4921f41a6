#include "match_panel.hpp"

#include "parts/lab_parts.hpp"

#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr int kRow_px = 26;

}  // namespace

MatchPanel::MatchPanel(app::LineBenchPresenter& bench, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      panel_(new QLineEdit(this)),
      sentence_(labText("bench_match_sentence", this)),
      table_(new QTableWidget(this)),
      name_(new QLineEdit(this)),
      keep_(labButton(tr("Name it"), "bench_keep_name", this)) {
    panel_->setObjectName(QStringLiteral("bench_panel"));
    panel_->setPlaceholderText(tr("The panel shows, 86.33.06"));
    panel_->setAccessibleName(tr("What the panel shows"));
    panel_->setMinimumHeight(ActionButton::kLeastSide_px);
    name_->setObjectName(QStringLiteral("bench_name"));
    name_->setPlaceholderText(tr("Name of the chosen one"));
    name_->setAccessibleName(tr("Name of the chosen variable"));
    name_->setMinimumHeight(ActionButton::kLeastSide_px);
    table_->setObjectName(QStringLiteral("bench_matches"));
    table_->setAccessibleName(tr("Variables that may be it"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setMinimumSectionSize(kRow_px);
    table_->horizontalHeader()->setStretchLastSection(true);
    compare_ = labButton(tr("Compare"), "bench_compare", this);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->addWidget(panel_, 0, 0);
    grid->addWidget(compare_, 0, 1);
    grid->addWidget(sentence_, 1, 0, 1, 2);
    grid->addWidget(table_, 2, 0, 1, 2);
    grid->addWidget(name_, 3, 0);
    grid->addWidget(keep_, 3, 1);
    grid->setColumnStretch(0, 1);
    grid->setRowStretch(2, 1);
    const auto correlate = [this] { bench_.correlate(panel_->text()); };
    connect(panel_, &QLineEdit::returnPressed, this, correlate);
    connect(compare_, &QPushButton::clicked, this, correlate);
    connect(name_, &QLineEdit::returnPressed, this, &MatchPanel::keepName);
    connect(keep_, &QPushButton::clicked, this, &MatchPanel::keepName);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &MatchPanel::showName);
    connect(&bench_, &app::LineBenchPresenter::matchesChanged, this, &MatchPanel::fill);
    fill();
}

void MatchPanel::addRow(const QString& key, const QStringList& texts) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int column = 0; column < texts.size(); ++column) {
        auto* const item = new QTableWidgetItem(texts[column]);
        item->setData(Qt::UserRole, key);
        item->setToolTip(texts[column]);
        table_->setItem(row, column, item);
    }
}

void MatchPanel::fillMatches() {
    table_->setColumnCount(4);
    table_->setHorizontalHeaderLabels({tr("Variable"), tr("Shown"), tr("Score"), tr("Units")});
    for (const protocol::PanelMatch& match : bench_.matches()) {
        const QString key = app::variableKey(match.stream.unit, match.stream.variable);
        const QString name = bench_.names().of(key);
        addRow(key, {name.isEmpty() ? key : QStringLiteral("%1  %2").arg(key, name), match.shown,
                     QString::number(match.score, 'f', 2), match.units});
    }
}

void MatchPanel::fillVariables() {
    table_->setColumnCount(4);
    table_->setHorizontalHeaderLabels({tr("Variable"), tr("Last"), tr("Times"), tr("Name")});
    if (bench_.findings()) {
        for (const app::SeenVariable& variable : bench_.findings()->variables) {
            const QString key = app::variableKey(variable.unit, variable.variable);
            addRow(key, {key, QString::number(variable.last, 'f', 5), QString::number(variable.times), bench_.names().of(key)});
        }
    }
}

void MatchPanel::fill() {
    const QString kept = chosen();
    {
        const QSignalBlocker quiet(table_);
        table_->setRowCount(0);
        bench_.matches().empty() ? fillVariables() : fillMatches();
        for (int column = 0; column + 1 < table_->columnCount(); ++column) {
            table_->resizeColumnToContents(column);
        }
        table_->resizeRowsToContents();  // units take two lines
        for (int row = 0; row < table_->rowCount(); ++row) {
            if (table_->item(row, 0)->data(Qt::UserRole).toString() == kept || row == 0) {
                table_->setCurrentCell(row, 0);
            }
        }
    }
    panel_->setEnabled(bench_.findings() != nullptr);
    compare_->setEnabled(bench_.findings() != nullptr);
    sentence_->setText(bench_.matchSentence());
    sentence_->setVisible(!bench_.matchSentence().isEmpty());
    showName();
}

QString MatchPanel::chosen() const {
    const QTableWidgetItem* const item = table_->item(table_->currentRow(), 0);
    return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

void MatchPanel::showName() {
    name_->setText(bench_.names().of(chosen()));
    name_->setEnabled(!chosen().isEmpty());
    keep_->setEnabled(!chosen().isEmpty());
}

void MatchPanel::keepName() {
    if (!chosen().isEmpty()) {
        bench_.nameVariable(chosen(), name_->text());
    }
}

}  // namespace pmts::gui
