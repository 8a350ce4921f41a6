#pragma once

#include "pmts/app/line/memory_presenter.hpp"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace pmts::gui {

/// What runs, how far it is, and Cancel; hidden while nothing runs.
class TransferRow : public QWidget {
    Q_OBJECT
public:
    explicit TransferRow(const char* object_name, QWidget* parent = nullptr);

    void showTransfer(const app::TransferView& transfer);

Q_SIGNALS:
    void cancelled();

private:
    QLabel* text_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace pmts::gui
