#pragma once

#include "pmts/app/line/label_backup_presenter.hpp"
#include "pmts/app/line/memory_presenter.hpp"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace pmts::gui {

class MemoryLinesModel;
class StateLamp;

/// The job or area file in sight: its lines and what became of each, the verdict on its points, its ways out.
class MemoryFilePanel : public QWidget {
    Q_OBJECT
public:
    MemoryFilePanel(app::MemoryPresenter& memory, const app::LabelBackupPresenter& backup, QWidget* parent = nullptr);

private:
    QWidget* makeVerdict();
    QWidget* makeButtons();
    void showDocument();
    void showEnabled();
    void open();
    void save();
    void send();
    void askForName(const instrument::MemoryFileId& proposed, const QString& reason);
    void askAboutBadLines(const instrument::MemoryFileId& wanted, int count);
    void chooseUnits(int index);

    app::MemoryPresenter& memory_;
    const app::LabelBackupPresenter& backup_;
    QLabel* heading_;
    QComboBox* units_;
    StateLamp* lamp_;
    QLabel* verdict_;
    MemoryLinesModel* lines_;
    QTableView* table_;
    QPushButton* open_;
    QPushButton* save_;
    QPushButton* send_;
    QPushButton* take_;
};

}  // namespace pmts::gui
