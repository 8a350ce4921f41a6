#pragma once

#include "pmts/app/desk/workbench.hpp"
#include "pmts/gui/theme.hpp"

#include <QMainWindow>

#include <memory>

namespace Ui {
class MainWindow;
}

namespace pmts::gui {

class AimingDialog;
class ConnectionDialog;
class EvidenceDialog;
class FieldActions;
class FieldWorkspace;
class LabWorkspace;
class LineWorkspace;
class LivePanel;
class StationDialog;
class Toast;

/// The one window: top bar, mode bar, workspaces, bottom bar; its menu has everything. Computes nothing.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    static constexpr double kSmallestText = 0.8;
    static constexpr double kLargestText = 1.6;

    /// The workbench outlives the window.
    explicit MainWindow(app::Workbench& bench, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] const FieldActions& actions() const { return *actions_; }
    [[nodiscard]] FieldWorkspace& field() const { return *field_; }
    [[nodiscard]] LabWorkspace& lab() const { return *lab_; }
    /// The laboratory with this step, by its object name.
    void openLab(const QString& step);
    [[nodiscard]] double textScale() const { return text_scale_; }
    void setTextScale(double scale);
    void usePalette(PaletteName name);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildWorkspaces();
    void buildMenus();
    void buildFileMenu();
    void buildViewMenu();
    void buildSimulatorMenu();
    void wireMainJob();
    void wirePages();
    void wireBars();
    void wireLook();
    void showStatus();
    void openControl();
    void showMode(int mode);  ///< a ModeBar::Mode: the workspaces lie in the stack in the order of the modes
    [[nodiscard]] LivePanel& shownLive() const;
    void showToast(const QString& text);
    void setFocusMode(bool on);
    void openStation();
    void openStep();
    void openAim();
    void openAiming();
    void showAiming();
    void openUnits();
    void openKeys();
    void openAbout();
    void chooseNewJob();
    void chooseJob();
    void chooseExport();
    void choosePlanned();
    void openEvidence();
    void fillRecentJobs(QMenu* menu);
    void doMessageAction(app::MessageAction action);
    bool stopWhatMoves();
    void keepLayout();
    void restoreLook();

    app::Workbench& bench_;
    std::unique_ptr<Ui::MainWindow> ui_;
    FieldActions* actions_;
    FieldWorkspace* field_ = nullptr;
    LabWorkspace* lab_ = nullptr;
    LineWorkspace* line_ = nullptr;
    Toast* line_toast_ = nullptr;  ///< where no live view is in sight
    ConnectionDialog* connection_ = nullptr;
    StationDialog* station_ = nullptr;
    AimingDialog* aiming_ = nullptr;
    EvidenceDialog* evidence_ = nullptr;
    double base_points_;
    double text_scale_ = 1.0;
};

}  // namespace pmts::gui
