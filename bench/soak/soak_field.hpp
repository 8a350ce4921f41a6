#pragma once

#include "pmts/app/desk/status_presenter.hpp"
#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"
#include "pmts/app/line/black_box_presenter.hpp"
#include "pmts/core/virtual_clock.hpp"
#include "pmts/simulator/control_unit.hpp"
#include "pmts/simulator/station.hpp"
#include "pmts/transport/memory_link.hpp"
#include "soak_camera.hpp"

#include <QTemporaryDir>
#include <QUndoStack>

namespace pmts::soak {

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
    /// Somebody presses REG on the instrument.
    void pressReg();
    /// Where the telescope pointed when REG was pressed, if that was so lately.
    [[nodiscard]] std::optional<geometry::Pointing> pressedWithin(core::Duration span) const {
        return time.now() - pressed_when_ <= span ? pressed_at_ : std::nullopt;
    }
    void startBlackBox();
    [[nodiscard]] QString blackBoxFolder() const { return folder_.filePath(QStringLiteral("box")); }
    [[nodiscard]] core::VideoGate& gate() { return gate_; }
    void moveJobAway();
    void bringJobBack();
    [[nodiscard]] QString jobPath() const { return folder_.filePath(QStringLiteral("soak.gpkg")); }

    core::VirtualClock time;  ///< somebody may set its calendar wrong
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
    /// A disk is slower than virtual time: it waits for it every second.
    void letBlackBoxWrite();
    core::Timer disk_;
    app::ControlSettings control_;
    std::optional<geometry::Pointing> pressed_at_;
    core::Duration pressed_when_{0};
    core::VideoGate gate_;
    QUndoStack undo_;

public:
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::BlackBoxPresenter black_box{blackBoxFolder(), preferences, messages, time};
    app::RangeKeeper range{25.0};
    app::InstrumentDesk instrument{gate_, wiring()};
    app::JobDesk job{app::Threading::kCallersThread};
    app::PointsModel points{job, preferences, messages, undo_};
    app::StationPresenter station_page{job, points, instrument, preferences, messages, undo_};
    app::LivePresenter live{instrument, points, station_page, range, job, preferences, messages, gate_, time};
    app::TargetingPresenter targeting{instrument, live, points, station_page, range, preferences, messages};
    app::RecordingPresenter recording{instrument, job, points, station_page, range, preferences, messages, time};
    SoakCamera* camera = new SoakCamera(time, gate_);  // NOLINT: the live presenter takes it over
};

}  // namespace pmts::soak
