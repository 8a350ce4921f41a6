#pragma once

#include "pmts/app/line/control_presenter.hpp"

#include <QGroupBox>

#include <array>

class QCheckBox;
class QGridLayout;

namespace pmts::gui {

/// The switch box that DTR and RTS drive: which line is asserted in which mode, and which way round the box takes it.
class PathSwitchBox : public QGroupBox {
    Q_OBJECT
public:
    explicit PathSwitchBox(QWidget* parent = nullptr);

    void showSwitch(const instrument::PathSwitch& path_switch);

Q_SIGNALS:
    void chosen(const pmts::instrument::PathSwitch& path_switch);

private:
    struct Line {
        QCheckBox* used;
        std::array<QCheckBox*, 3> modes;  ///< shared, computer, panel
    };

    [[nodiscard]] Line addLine(const QString& name, const char* object_name, QGridLayout& grid, int row);
    [[nodiscard]] QCheckBox* addTick(const QString& text, const QString& object_name);
    static void showLine(const Line& line, const std::optional<instrument::LineInModes>& modes);
    [[nodiscard]] static std::optional<instrument::LineInModes> lineFrom(const Line& line);
    void tell();

    Line dtr_, rts_;
    QCheckBox* inverted_;
};

}  // namespace pmts::gui
