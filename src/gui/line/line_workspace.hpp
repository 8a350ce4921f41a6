#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QWidget>

namespace pmts::gui {

class ListedPage;
class PageList;

/// The link to the instrument, watched and repaired: pages in a list at the left, the chosen one beside it.
class LineWorkspace : public QWidget {
    Q_OBJECT
public:
    explicit LineWorkspace(app::Workbench& bench, QWidget* parent = nullptr);

    [[nodiscard]] ListedPage* current() const;
    void openPage(const QString& object_name);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    PageList* list_;
};

}  // namespace pmts::gui
