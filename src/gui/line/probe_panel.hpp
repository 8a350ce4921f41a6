#pragma once

#include "pmts/app/desk/probe_presenter.hpp"

#include <QGroupBox>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace pmts::gui {

class StateLamp;

/// Looks for the instrument on the ticked ports with every usual line setting, and takes over what was found.
class ProbePanel : public QGroupBox {
    Q_OBJECT
public:
    explicit ProbePanel(app::ProbePresenter& probe, QWidget* parent = nullptr);

    void showPorts();

private:
    void showProbe();
    void startOrCancel();

    app::ProbePresenter& probe_;
    QListWidget* ports_;
    QPushButton* start_;
    QProgressBar* progress_;
    StateLamp* lamp_;
    QLabel* verdict_;
    QPushButton* use_;
};

}  // namespace pmts::gui
