#pragma once

#include "window/listed_page.hpp"
#include "pmts/app/desk/workbench.hpp"

#include <QTimer>

#include <vector>

class QGridLayout;
class QGroupBox;
class QLabel;
class QPushButton;
class QShortcut;
class QTableWidget;

namespace pmts::gui {

class PathSwitchBox;
class PortForm;
class StateLamp;

/// Who has control of the instrument: the switch with its three modes, the owner, the panel's port, the switch box, counters.
class ControlPage : public ListedPage {
    Q_OBJECT
public:
    explicit ControlPage(app::Workbench& bench, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Control"); }
    void entered() override;
    void left() override;

private:
    void addModes(QGridLayout& grid);
    [[nodiscard]] QLayout* ownerRow();
    [[nodiscard]] QGroupBox* panelBox();
    [[nodiscard]] QGroupBox* countersBox();
    void showMode();
    void showOwner();
    void showPanel();
    void showCounters();

    app::ConnectionPresenter& connection_;
    app::ControlPresenter& control_;
    std::vector<QPushButton*> modes_;
    std::vector<QShortcut*> keys_;
    StateLamp* change_lamp_;
    QLabel* change_;
    QPushButton* cancel_;
    StateLamp* owner_lamp_;
    QLabel* owner_;
    StateLamp* panel_lamp_ = nullptr;
    QLabel* panel_ = nullptr;
    PortForm* port_ = nullptr;
    QPushButton* remove_ = nullptr;
    PathSwitchBox* path_switch_;
    QTableWidget* counters_ = nullptr;
    QTimer tick_;  ///< while it is shown: how long, and the counters without a flicker
};

}  // namespace pmts::gui
