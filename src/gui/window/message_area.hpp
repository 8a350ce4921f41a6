#pragma once

#include "pmts/app/desk/message_centre.hpp"

#include <QFrame>
#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;

namespace Ui {
class MessageBar;
}

namespace pmts::gui {

/// One message that stays: what happened, what to do, a button that does it, details folded.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(const app::Message& message, QWidget* parent = nullptr);
    ~MessageBar() override;

Q_SIGNALS:
    void actionChosen(pmts::app::MessageAction action);
    void dismissed(quint64 id);

private:
    std::unique_ptr<Ui::MessageBar> ui_;
};

/// The newest messages that stay, newest on top; older ones wait behind.
class MessageArea : public QWidget {
    Q_OBJECT
public:
    static constexpr int kMostShown = 2;

    explicit MessageArea(QWidget* parent = nullptr);

    void showBars(const std::vector<app::Message>& bars);

Q_SIGNALS:
    void actionChosen(pmts::app::MessageAction action);
    void dismissed(quint64 id);
};

/// Good news over the lower edge of its parent; goes away by itself.
class Toast : public QFrame {
    Q_OBJECT
public:
    explicit Toast(QWidget* parent);

    void showText(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QLabel* label_;
    QTimer hide_soon_;
};

}  // namespace pmts::gui
