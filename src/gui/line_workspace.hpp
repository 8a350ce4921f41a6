#pragma once

#include "pmts/app/workbench.hpp"

#include <QWidget>

#include <vector>

class QListWidget;
class QStackedWidget;

namespace pmts::gui {

class LinePage;

/// The link to the instrument, watched and repaired: pages in a list at the left, the chosen one beside it.
class LineWorkspace : public QWidget {
    Q_OBJECT
public:
    explicit LineWorkspace(app::Workbench& bench, QWidget* parent = nullptr);

    [[nodiscard]] LinePage* current() const;
    void openPage(const QString& object_name);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addPages(app::Workbench& bench);
    void add(LinePage* page, const QString& object_name);
    void choose(int index);
    void enter();
    void leave();

    QListWidget* list_;
    QStackedWidget* stack_;
    std::vector<LinePage*> pages_;
    LinePage* entered_ = nullptr;
};

}  // namespace pmts::gui
