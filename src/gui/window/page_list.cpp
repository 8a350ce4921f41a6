#include "page_list.hpp"

#include "parts/state_lamp.hpp"

#include <QStackedWidget>

#include <utility>

namespace pmts::gui {
namespace {

constexpr int kRow_px = 48;  ///< a gloved finger

}  // namespace

PageList::PageList(QStackedWidget& stack, QWidget* parent) : QListWidget(parent), stack_(stack) {
    setFixedWidth(kWidth_px);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QListWidget::currentRowChanged, this, &PageList::choose);
}

void PageList::add(ListedPage* page, QWidget* shown, const QString& object_name) {
    page->setObjectName(object_name);
    pages_.push_back(page);
    stack_.addWidget(shown);
    auto* const row = new QListWidgetItem(lampIcon(app::DeviceState::kIdle), page->title(), this);
    row->setSizeHint({kWidth_px, kRow_px});
    connect(page, &ListedPage::stateChanged, this, [row](app::DeviceState state) {
        row->setIcon(lampIcon(state));
        row->setToolTip(lampText(state));
    });
}

void PageList::openPage(const QString& object_name) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        if (pages_[i]->objectName() == object_name) {
            setCurrentRow(static_cast<int>(i));
        }
    }
}

ListedPage* PageList::chosenPage() const {
    return currentRow() < 0 ? nullptr : pages_[static_cast<std::size_t>(currentRow())];
}

void PageList::setWorkspaceShown(bool shown) {
    if (shown) {
        enter();
    } else {
        leave();
    }
}

void PageList::choose(int index) {
    const bool was_entered = entered_ != nullptr;
    leave();
    stack_.setCurrentIndex(index);
    if (was_entered) {
        enter();
    }
}

void PageList::enter() {
    if (entered_ == nullptr && chosenPage() != nullptr) {
        entered_ = chosenPage();
        entered_->entered();
        Q_EMIT enteredPageChanged();
    }
}

void PageList::leave() {
    if (ListedPage* const page = std::exchange(entered_, nullptr)) {
        page->left();
        Q_EMIT enteredPageChanged();
    }
}

}  // namespace pmts::gui
