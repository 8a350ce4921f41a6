#pragma once

#include "pmts/app/desk/connection_presenter.hpp"
#include "pmts/app/line/control_presenter.hpp"
#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/job_presenter.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QObject>
#include <QTimer>

namespace pmts::app {

/// The top bar and the busy line.
struct StatusLine {
    StatusItem job, station, instrument, camera, control, gate;
    bool busy_shown = false;   ///< busy for more than 300 ms
    QString busy_text;         ///< `Measuring`, after 2 s `Measuring, usually 5 s`
    double busy_fraction = 0.0;

    [[nodiscard]] bool operator==(const StatusLine&) const = default;
};

class StatusPresenter : public QObject {
    Q_OBJECT
public:
    StatusPresenter(const JobPresenter& job, const StationPresenter& station, const ConnectionPresenter& connection,
                    const LivePresenter& live, const ControlPresenter& control, const InstrumentDesk& instrument,
                    QObject* parent = nullptr);

    [[nodiscard]] const StatusLine& line() const { return line_; }

Q_SIGNALS:
    void changed();  ///< take line()

private:
    void refresh();

    const JobPresenter& job_;
    const StationPresenter& station_;
    const ConnectionPresenter& connection_;
    const LivePresenter& live_;
    const ControlPresenter& control_;
    const InstrumentDesk& instrument_;
    StatusLine line_;
};

}  // namespace pmts::app
