#pragma once

#include "window/listed_page.hpp"
#include "pmts/app/line/label_backup_presenter.hpp"
#include "pmts/app/line/memory_presenter.hpp"

class QLabel;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

class TransferRow;

/// The instrument's memory: its files at the left, the file in sight or the label backup beside them.
class MemoryPage : public ListedPage {
    Q_OBJECT
public:
    MemoryPage(app::MemoryPresenter& memory, app::LabelBackupPresenter& backup, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Memory"); }
    void entered() override;

private:
    QWidget* makeFiles();
    void showListing();
    void showTransfer();
    void readSelected();

    app::MemoryPresenter& memory_;
    app::LabelBackupPresenter& backup_;
    QTableWidget* files_;
    QLabel* room_;
    QPushButton* list_;
    QPushButton* read_;
    TransferRow* transfer_;
};

}  // namespace pmts::gui
