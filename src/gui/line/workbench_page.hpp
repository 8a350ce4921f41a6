#pragma once

#include "window/listed_page.hpp"

#include "pmts/app/line/line_bench_presenter.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QTableWidget;

namespace pmts::gui {

class FramingPanel;
class MatchPanel;
class ProgressOverlay;
class SignalView;

/// The bench for unknown lines: import, pins, framing, time line, text and bytes, comparison with a panel, saving.
class WorkbenchPage : public ListedPage {
    Q_OBJECT
public:
    explicit WorkbenchPage(app::LineBenchPresenter& bench, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Workbench"); }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    [[nodiscard]] QWidget* makeBar();
    [[nodiscard]] QWidget* makeMiddle();
    void makeTalk();
    void wire();
    void addKeys();
    void showAll();
    void showPins();
    void showBusy();
    void chooseFile();
    void import(const QString& path);
    void saveTable();
    void showSearched(qsizetype character);
    void showRow(int row);

    app::LineBenchPresenter& bench_;
    QPushButton *import_, *save_, *previous_, *next_;
    QComboBox* format_;
    QLineEdit *search_, *rate_;
    QLabel *search_sentence_, *summary_;
    QTableWidget* pins_;
    FramingPanel* framing_;
    MatchPanel* matches_;
    SignalView* signal_;
    QTableView* talk_;
    ProgressOverlay* progress_;
};

}  // namespace pmts::gui
