#include "check_list.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"

#include <QGridLayout>

namespace pmts::gui {

CheckList::CheckList(app::ConnectionChecks& checks, QWidget* parent) : QWidget(parent), checks_(checks) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(2, 1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto row = static_cast<int>(i);
        rows_.at(i) = {new StateLamp(this), new QLabel(this), labText("check_sentence", this)};
        rows_.at(i).sentence->setObjectName(QStringLiteral("check_%1").arg(row + 1));
        // Room for the longest sentence: nothing jumps while they come in.
        rows_.at(i).sentence->setMinimumHeight(2 * fontMetrics().lineSpacing());
        grid->addWidget(rows_.at(i).lamp, row, 0);
        grid->addWidget(rows_.at(i).title, row, 1);
        grid->addWidget(rows_.at(i).sentence, row, 2);
    }
    connect(&checks_, &app::ConnectionChecks::changed, this, &CheckList::showItems);
    showItems();
}

void CheckList::showItems() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const app::CheckItem& item = checks_.items().at(i);
        const Row& row = rows_.at(i);
        row.lamp->setState(item.state);
        row.title->setText(item.title);
        row.sentence->setText(item.sentence);
        for (QWidget* const part : std::initializer_list<QWidget*>{row.lamp, row.title, row.sentence}) {
            part->setVisible(!item.title.isEmpty());
        }
    }
}

}  // namespace pmts::gui
