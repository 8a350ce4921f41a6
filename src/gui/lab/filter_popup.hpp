#pragma once

#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/lab/still_filters.hpp"

#include <QFrame>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace pmts::gui {

/// Sliders of the filters of the still: what is seen changes at once, its pixels never.
class FilterPopup : public QFrame {
    Q_OBJECT
public:
    FilterPopup(app::LivePresenter& live, app::StillFilters& filters, QWidget* parent = nullptr);
    void openAt(const QPoint& global);

private:
    QSlider* addSlider(QGridLayout& grid, const QString& name, const char* object_name, int most);
    [[nodiscard]] int stillNumber() const;
    void take();
    void showFilter();
    void save();

    app::LivePresenter& live_;
    app::StillFilters& filters_;
    QLabel* said_;
    QSlider *smooth_, *sharp_, *edges_, *red_, *green_, *blue_;
    QComboBox* bands_;
    QPushButton *none_, *save_;
};

}  // namespace pmts::gui
