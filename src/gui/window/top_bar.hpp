#pragma once

#include "pmts/app/desk/status_presenter.hpp"

#include <QWidget>

#include <memory>

class QToolButton;

namespace Ui {
class TopBar;
}

namespace pmts::gui {

/// Job, station, instrument, camera, control: each with its state, each a button to its page.
class TopBar : public QWidget {
    Q_OBJECT
public:
    explicit TopBar(QWidget* parent = nullptr);
    ~TopBar() override;

    void showLine(const app::StatusLine& line);

Q_SIGNALS:
    void jobClicked();
    void stationClicked();
    void instrumentClicked();
    void cameraClicked();
    void controlClicked();
    void gateClicked();

private:
    static void showItem(QToolButton* button, const app::StatusItem& item, const QString& name);

    std::unique_ptr<Ui::TopBar> ui_;
};

}  // namespace pmts::gui
