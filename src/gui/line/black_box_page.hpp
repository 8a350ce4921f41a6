#pragma once

#include "window/listed_page.hpp"

#include "pmts/app/line/black_box_presenter.hpp"
#include "pmts/app/line/bug_report_presenter.hpp"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace pmts::gui {

class StateLamp;

/// The black box: whether it records and how much it keeps; and the bug report, looked at before it is written.
class BlackBoxPage : public ListedPage {
    Q_OBJECT
public:
    BlackBoxPage(app::BlackBoxPresenter& black_box, app::BugReportPresenter& report, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Black box"); }
    void entered() override;

private:
    QWidget* makeRecording();
    QWidget* makeReport();
    QWidget* makePreview();
    void wireReport();
    void showStatus();
    void keepSettings();
    void prepare();
    void showReport();
    void showFile(int row);
    void chooseFile();

    app::BlackBoxPresenter& black_box_;
    app::BugReportPresenter& report_;
    StateLamp* lamp_ = nullptr;
    QLabel *state_ = nullptr, *kept_ = nullptr, *said_ = nullptr;
    QCheckBox *on_ = nullptr, *pictures_ = nullptr;
    QSpinBox *kept_mb_ = nullptr, *minutes_ = nullptr;
    QDoubleSpinBox* rate_ = nullptr;
    QPlainTextEdit *words_ = nullptr, *preview_ = nullptr;
    QListWidget* inside_ = nullptr;
    QPushButton *again_ = nullptr, *look_ = nullptr, *cancel_ = nullptr, *save_ = nullptr;
};

/// Shows a black box file in a program of its own: the work here goes on.
void openBlackBoxBeside(QWidget* parent, const QString& folder);

}  // namespace pmts::gui
