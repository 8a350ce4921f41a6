#pragma once

#include "pmts/app/line/line_bench_presenter.hpp"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

/// What the panel shows is typed, the variables of the stream that may be it are listed; the chosen one can be named.
class MatchPanel : public QWidget {
    Q_OBJECT
public:
    explicit MatchPanel(app::LineBenchPresenter& bench, QWidget* parent = nullptr);

private:
    void fill();
    void fillMatches();
    void fillVariables();
    void addRow(const QString& key, const QStringList& texts);
    void showName();
    void keepName();
    [[nodiscard]] QString chosen() const;

    app::LineBenchPresenter& bench_;
    QLineEdit* panel_;
    QLabel* sentence_;
    QTableWidget* table_;
    QLineEdit* name_;
    QPushButton *keep_, *compare_;
};

}  // namespace pmts::gui
