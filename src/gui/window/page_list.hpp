#pragma once

#include "listed_page.hpp"

#include <QListWidget>

#include <vector>

class QStackedWidget;

namespace pmts::gui {

/// The pages of a workspace by their names, high enough for a gloved finger, each with its lamp. The chosen page is shown in
/// the stack, and told when it is entered and left.
class PageList : public QListWidget {
    Q_OBJECT
public:
    static constexpr int kWidth_px = 150;

    explicit PageList(QStackedWidget& stack, QWidget* parent = nullptr);

    /// `shown` is the page itself or a scroll area around it.
    void add(ListedPage* page, QWidget* shown, const QString& object_name);
    void openPage(const QString& object_name);
    [[nodiscard]] ListedPage* chosenPage() const;
    /// Null while the workspace is hidden.
    [[nodiscard]] ListedPage* enteredPage() const { return entered_; }
    void setWorkspaceShown(bool shown);

Q_SIGNALS:
    void enteredPageChanged();

private:
    void choose(int index);
    void enter();
    void leave();

    QStackedWidget& stack_;
    std::vector<ListedPage*> pages_;
    ListedPage* entered_ = nullptr;
};

}  // namespace pmts::gui
