#pragma once

#include "pmts/app/desk/connection_checks.hpp"

#include <QWidget>

#include <array>

class QLabel;

namespace pmts::gui {

class StateLamp;

/// What has to be right for an instrument to answer: a lamp and a sentence each, filled in while it is connected. Items
/// without a title are not shown.
class CheckList : public QWidget {
    Q_OBJECT
public:
    explicit CheckList(app::ConnectionChecks& checks, QWidget* parent = nullptr);

private:
    struct Row {
        StateLamp* lamp;
        QLabel* title;
        QLabel* sentence;
    };

    void showItems();

    app::ConnectionChecks& checks_;
    std::array<Row, app::ConnectionChecks::kCount> rows_{};
};

}  // namespace pmts::gui
