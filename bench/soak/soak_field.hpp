#pragma once

#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/app/desk/status_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"
#include "pmts/core/virtual_clock.hpp"
#include "pmts/simulator/control_unit.hpp"
#include "pmts/simulator/station.hpp"
#include "pmts/transport/memory_link.hpp"

#include <QTemporaryDir>
#include <QUndoStack>

namespace pmts::soak {

/// Virtual time, and a calendar that somebody may set wrong.
class CalendarClock final : public core::Clock {
public:
    explicit CalendarClock(core::Clock& time) : time_(time) {}

    [[nodiscard]] core::Duration now() const override { return time_.now(); }
    [[nodiscard]] QDateTime utcNow() const override { return time_.utcNow().addSecs(ahead_s_); }
    [[nodiscard]] core::Timer callAfter(core::Duration delay, std::function<void()> action) override {
        return time_.callAfter(delay, std::move(action));
    }
    void jump(qint64 by_s) { ahead_s_ += by_s; }

private:
    core::Clock& time_;
    qint64 ahead_s_ = 0;
};

/// The desks of the program without a window: the simulated instrument and a control unit of its maker at the two ports,
/// lines in memory, a job file on the disk, everything in virtual time and on one thread.
class SoakField {
public:
    explicit SoakField(unsigned seed);
    ~SoakField();
    SoakField(const SoakField&) = delete;
    SoakField& operator=(const SoakField&) = delete;

    void openJob();
    void connect();
    [[nodiscard]] bool isConnected() const { return instrument.connectionState() == app::ConnectionState::kConnected; }
    /// Runs until it is so; false when it is not after `limit` of virtual time, or when nothing is left that could happen.
    bool until(const std::function<bool()>& so, core::Duration limit);
    void pass(core::Duration span) { time.advance(span); }

    void pullCable();
    void plugIn() { is_plugged_ = true; }
    void pullPanel();
    void plugPanelIn() { panel_is_plugged_ = true; }
    void setMode(scheduler::ControlMode mode);
    void moveJobAway();
    void bringJobBack();
    [[nodiscard]] QString jobPath() const { return folder_.filePath(QStringLiteral("soak.gpkg")); }

    core::VirtualClock time;
    CalendarClock clock{time};
    std::shared_ptr<const simulator::Scene> scene;
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    simulator::Station station;
    simulator::ControlUnit panel;

private:
    [[nodiscard]] app::InstrumentWiring wiring();
    [[nodiscard]] std::unique_ptr<transport::ByteLink> makeLink(const app::SerialChoice& choice);
    [[nodiscard]] std::unique_ptr<transport::ByteLink> makePanelLink();

    QTemporaryDir folder_;
    std::unique_ptr<transport::MemoryLink> instrument_end_, panel_end_;
    bool is_plugged_ = true, panel_is_plugged_ = true;
    app::ControlSettings control_;
    core::VideoGate gate_;
    QUndoStack undo_;

public:
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::RangeKeeper range{25.0};
    app::InstrumentDesk instrument{gate_, wiring()};
    app::JobDesk job{app::Threading::kCallersThread};
    app::PointsModel points{job, preferences, messages, undo_};
    app::StationPresenter station_page{job, points, instrument, preferences, messages, undo_};
    app::LivePresenter live{instrument, points, station_page, range, job, preferences, messages, gate_, clock};
    app::TargetingPresenter targeting{instrument, live, points, station_page, range, preferences, messages};
    app::RecordingPresenter recording{instrument, job, points, station_page, range, preferences, messages, clock};
};

}  // namespace pmts::soak
