#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QWidget>

class QLabel;
class QStackedWidget;

namespace pmts::gui {

class FieldActions;
class LabStep;
class LivePanel;
class PageList;

/// The technician's workspace: steps at the left, live view in the middle, the chosen step's panel at the right.
class LabWorkspace : public QWidget {
    Q_OBJECT
public:
    LabWorkspace(app::Workbench& bench, const FieldActions& actions, QWidget* parent = nullptr);

    [[nodiscard]] LivePanel& live() const { return *live_; }
    [[nodiscard]] LabStep* current() const;
    void openStep(const QString& object_name);

Q_SIGNALS:
    void formatRequested();  ///< the video format's dialog

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addSteps(app::Workbench& bench);
    void add(LabStep* step, const QString& object_name);
    void wireLive(app::Workbench& bench, const FieldActions& actions);
    void showReadings(const app::Readings& readings);
    [[nodiscard]] LabStep* entered() const;  ///< null while another workspace is shown
    void showOverlay();

    QStackedWidget* panels_;
    PageList* list_;
    QLabel* readings_;
    LivePanel* live_;
};

}  // namespace pmts::gui
