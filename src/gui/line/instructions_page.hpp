#pragma once

#include "window/listed_page.hpp"
#include "pmts/app/line/instructions_presenter.hpp"

class QCheckBox;
class QFormLayout;
class QFrame;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

class StateLamp;
class TableEditor;

/// The instruction table of the bus: the text with its problems at the left; its routines, their numbers, the dry run and
/// the run with every step at the right.
class InstructionsPage : public ListedPage {
    Q_OBJECT
public:
    explicit InstructionsPage(app::InstructionsPresenter& instructions, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Instructions"); }
    void entered() override;

private:
    [[nodiscard]] QWidget* makeTextSide();
    [[nodiscard]] QWidget* makeRunSide();
    [[nodiscard]] QFrame* makeConfirmation();
    void wire();
    void addKeys();

    void showText();
    void showTable();
    void showRoutines();
    void showChosen();
    void showFields();
    void showRun();
    void showSteps();
    void run();
    void importTable();
    void exportTable();

    app::InstructionsPresenter& instructions_;
    TableEditor* editor_ = nullptr;
    QLabel* file_ = nullptr;
    QListWidget* problems_ = nullptr;
    QPushButton *save_ = nullptr, *revert_ = nullptr;
    QListWidget* routines_ = nullptr;
    QLabel* note_ = nullptr;
    QFormLayout* fields_ = nullptr;
    QStringList shown_fields_;
    bool is_showing_text_ = false;  ///< what the editor says then is no typing
    QCheckBox* believes_ = nullptr;
    QPushButton *dry_run_ = nullptr, *run_ = nullptr, *cancel_ = nullptr;
    QFrame* confirmation_ = nullptr;
    QLabel* confirmation_text_ = nullptr;
    QLabel* trouble_ = nullptr;
    QTableWidget* steps_ = nullptr;
    StateLamp* lamp_ = nullptr;
    QLabel* outcome_ = nullptr;
};

}  // namespace pmts::gui
