#pragma once

#include "window/listed_page.hpp"

#include "pmts/app/desk/log_model.hpp"

#include <QSortFilterProxyModel>
#include <QWidget>

#include <memory>

namespace Ui {
class LogPage;
}

namespace pmts::gui {

/// Lines of the log that hold a text, belong to a category and are at least so severe.
class LogFilter : public QSortFilterProxyModel {
    Q_OBJECT
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString& text);
    void setCategory(const QString& category);  ///< empty: every one
    void setLeastRank(int rank);                ///< 0 all, 1 without debug lines, 2 warnings, 3 problems

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString text_, category_;
    int least_rank_ = 0;
};

/// The log window; what goes over the wire has the category `wire`.
class LogPage : public ListedPage {
    Q_OBJECT
public:
    enum class Least { kEverything, kNoWire };

    LogPage(app::LogModel& log, Least least, QWidget* parent = nullptr);
    ~LogPage() override;

    [[nodiscard]] QString title() const override { return tr("Log"); }

private:
    void noteCategories(int first, int last);
    void followNewest();

    app::LogModel& log_;
    LogFilter filter_;
    std::unique_ptr<Ui::LogPage> ui_;
};

}  // namespace pmts::gui
