#pragma once

#include "pmts/app/workbench.hpp"

#include <QWidget>

#include <vector>

class QLabel;
class QListWidget;
class QStackedWidget;

namespace pmts::gui {

class FieldActions;
class LabStep;
class LivePanel;

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
    void choose(int index);
    void enter();
    void leave();
    void showOverlay();

    QListWidget* list_;
    QLabel* readings_;
    LivePanel* live_;
    QStackedWidget* panels_;
    std::vector<LabStep*> steps_;
    LabStep* entered_ = nullptr;
};

}  // namespace pmts::gui
