#pragma once

#include "pmts/app/line/label_backup_presenter.hpp"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

class TransferRow;

/// The backup of all labels, and what changed since an earlier one.
class LabelBackupPanel : public QWidget {
    Q_OBJECT
public:
    LabelBackupPanel(app::LabelBackupPresenter& backup, const app::MemoryPresenter& memory, QWidget* parent = nullptr);

private:
    void showAll();
    void showTransfer();
    void showLabels();
    void showChanges();
    void save();
    void compare();

    app::LabelBackupPresenter& backup_;
    const app::MemoryPresenter& memory_;
    QLabel* sentence_;
    QLabel* comparison_;
    QTableWidget* table_;
    TransferRow* transfer_;
    QPushButton* read_;
    QPushButton* save_;
    QPushButton* compare_;
};

}  // namespace pmts::gui
