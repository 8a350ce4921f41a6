#pragma once

#include "pmts/app/line/line_bench_presenter.hpp"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace pmts::gui {

/// What was found of one line, best first, and the same by hand: pace, bits, parity, order, level of rest, way.
class FramingPanel : public QWidget {
    Q_OBJECT
public:
    explicit FramingPanel(app::LineBenchPresenter& bench, QWidget* parent = nullptr);

    void showLine(int line);  ///< -1: none

private:
    void fill();
    void fillFound(const app::FoundLine& line);
    void take();
    [[nodiscard]] const app::FoundLine* found() const;
    [[nodiscard]] QComboBox* choice(const char* name, const QString& label, const QStringList& texts);

    app::LineBenchPresenter& bench_;
    int line_ = -1;
    QLabel* title_;
    QComboBox* scores_;
    QDoubleSpinBox* pace_;
    QLabel* pace_label_;
    QComboBox *bits_, *parity_, *order_, *rest_, *way_;
    QCheckBox* decoded_;
};

}  // namespace pmts::gui
