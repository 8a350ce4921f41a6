#pragma once

#include "window/listed_page.hpp"

#include "pmts/app/desk/file_saving.hpp"
#include "pmts/app/line/timeline.hpp"

#include <QSortFilterProxyModel>
#include <QTimer>

#include <optional>
#include <vector>

class QAction;
class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace pmts::gui {

class TimelineView;

/// Events of the line that hold a text, or only the slow and the failed ones.
class TimelineFilter : public QSortFilterProxyModel {
    Q_OBJECT
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString& text);
    void setProblemsOnly(bool on);
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString text_;
    bool problems_only_ = false;
};

/// The bus time line: lanes over time, the chosen event in words beside its bytes, and the table of the same.
class TimelinePage : public ListedPage {
    Q_OBJECT
public:
    explicit TimelinePage(app::Timeline& timeline, QWidget* parent = nullptr,
                          app::Threading threading = app::Threading::kOwnThread);

    [[nodiscard]] QString title() const override { return tr("Time line"); }
    void entered() override;
    void left() override;
    /// .csv: the filtered table with bytes and times in ms; .svg, .png: the lanes as shown. Goes on in the pool; the line
    /// below says how it ended.
    void save(const QString& path);
    void refresh();  ///< what the page does ten times a second while it is shown

private:
    QWidget* makeTools();
    QWidget* makeTable();
    QWidget* makeSavingRow();
    void wire();
    void showFollowing(bool on);
    void showEvent(std::optional<std::uint64_t> number);
    void chooseFile();
    void say(const QString& sentence);
    [[nodiscard]] std::vector<app::LineEvent> shownEvents() const;
    [[nodiscard]] app::FileSaving::Make makerOf(const QString& path) const;
    [[nodiscard]] const app::LineEvent* eventOfRow(int row) const;

    using QWidget::showEvent;

    app::Timeline& timeline_;
    TimelineFilter filter_;
    TimelineView* view_;
    QPushButton* follow_ = nullptr;
    QAction* follow_key_ = nullptr;
    QLineEdit* text_ = nullptr;
    QCheckBox* problems_ = nullptr;
    QLabel* details_;
    QLabel* said_;
    QTableView* table_ = nullptr;
    QTimer repaint_;
    app::FileSaving saving_;
};

}  // namespace pmts::gui
