#pragma once

#include "pmts/app/field/range_presenter.hpp"

#include <QFrame>

class QLabel;
class QSlider;

namespace pmts::gui {

/// Near and far sliders: which points are drawn over the pictures, by their distance from the station.
class DepthPopup : public QFrame {
    Q_OBJECT
public:
    explicit DepthPopup(app::RangePresenter& ranges, QWidget* parent = nullptr);

    /// Above the button that opens it.
    void openAbove(const QWidget& button);

private:
    QSlider* addSlider(const QString& name, int row);
    void slide(bool near_moved);
    void showValues();

    app::RangePresenter& ranges_;
    QSlider *near_, *far_;
    QLabel *near_text_, *far_text_;
};

}  // namespace pmts::gui
