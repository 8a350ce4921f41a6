#pragma once

#include "pmts/app/settings/control_settings.hpp"
#include "pmts/app/desk/frame_feed.hpp"
#include "pmts/app/desk/pointing_track.hpp"
#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/instrument/instrument_connection.hpp"
#include "pmts/instrument/memory.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/targeting/pointing_guard.hpp"
#include "pmts/targeting/recentring.hpp"
#include "pmts/targeting/spot_sweep.hpp"

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

enum class ConnectionState {
    kDisconnected,
    kConnecting,    ///< port open or opening, nothing has answered yet
    kConnected,     ///< the instrument answered: never said for an open port alone
    kReconnecting,  ///< it went away; tried again until it is back or somebody disconnects
};

/// How a desk reaches its instrument. The defaults are the program's; tests put a memory link and a virtual clock in.
struct InstrumentWiring {
    using MakeLink = std::function<std::unique_ptr<transport::ByteLink>(const SerialChoice& choice)>;
    using ListPorts = std::function<std::vector<transport::PortInfo>()>;

    Threading threading = Threading::kOwnThread;
    core::Clock* clock = nullptr;  ///< null: a SystemClock on the instrument thread
    MakeLink make_link;            ///< empty: a serial port
    ListPorts list_ports = transport::listPorts;  ///< where a USB adapter is looked for again
    targeting::FindPatch find_patch = targeting::findInPool(targeting::PatchMatcher());
    instrument::ConnectionSettings connection;
};

/// A click to be brought to the reticle, and with what.
struct RecentringOrder {
    targeting::Click click;
    targeting::PixelToPointing model;
    std::shared_ptr<FrameFeed> frames;
    targeting::RecentringSettings settings;
};

/// A spot to be seen from a list of pointings, and with what.
struct SweepOrder {
    targeting::Click click;
    std::vector<geometry::Pointing> pointings;
    targeting::PixelToPointing model;
    std::shared_ptr<FrameFeed> frames;
    targeting::SweepSettings settings;
    std::vector<targeting::SpotSighting> seen_before{};  ///< of earlier sweeps of the same spot
};

/// The instrument as the GUI thread sees it. The link, the scheduler and the driver live on a thread of their own; every
/// call is queued there and returns at once, every outcome comes back as a signal. Each request ends in exactly one
/// outcome signal (its own, or requestFailed), also on stop, unplugging and shutdown.
class InstrumentDesk : public QObject {
    Q_OBJECT
public:
    explicit InstrumentDesk(core::VideoGate& gate, InstrumentWiring wiring = {}, QObject* parent = nullptr);
    ~InstrumentDesk() override;  ///< completes what waits, closes the port, joins the thread

    [[nodiscard]] ConnectionState connectionState() const { return state_; }
    [[nodiscard]] QString connectionSentence() const { return sentence_; }
    [[nodiscard]] const std::optional<instrument::Identity>& identity() const { return identity_; }
    [[nodiscard]] const SerialChoice& choice() const { return choice_; }
    /// Connected to the foot, where there are commands for motion, distances, labels and memory; the bus has none of them.
    [[nodiscard]] bool speaksExternal() const {
        return state_ == ConnectionState::kConnected && choice_.dialect == instrument::LineDialect::kExternal;
    }
    [[nodiscard]] const PointingTrack& track() const { return track_; }
    [[nodiscard]] const instrument::Progress& progress() const { return progress_; }
    [[nodiscard]] bool isBusy() const { return progress_.activity != instrument::Activity::kIdle; }
    [[nodiscard]] bool isTurning() const { return progress_.activity == instrument::Activity::kTurning; }

    /// How far the cable is wound since it hung free, clockwise positive; absent before the first reading.
    [[nodiscard]] const std::optional<core::Angle>& wound() const { return wound_; }

    /// Refused with kLimit and a sentence where the guard bars the target or the way to it.
    Ticket turnTo(geometry::Pointing target, core::Angle tolerance);
    /// Turns, finds the clicked spot in new pictures and turns again until it is on the reticle (features K9).
    Ticket recentre(const RecentringOrder& order);
    /// Turns through the pointings and finds the clicked spot in new pictures at each.
    Ticket sweep(const SweepOrder& order);
    Ticket measureDistance();
    Ticket setMode(instrument::EdmMode mode);
    Ticket testSignal();
    Ticket readLabel(int label);
    Ticket writeLabel(int label, const QString& data);
    // The instrument's memory and its compensator.
    Ticket listMemory();
    Ticket downloadFile(const instrument::MemoryFileId& file);
    /// Nothing is overwritten: info 33 where the name is taken.
    Ticket uploadFile(const instrument::MemoryFileId& file, const std::vector<std::string>& lines);
    Ticket backUpLabels();
    /// The instrument turns by itself.
    Ticket calibrateCompensator();
    /// Of an instruction table, on the bus only; kUnsupported on the external interface.
    Ticket runRoutine(const protocol::TableRoutine& routine, const std::map<std::string, double>& numbers);

public Q_SLOTS:
    void connectSerial(const pmts::app::SerialChoice& choice);
    /// The same after a BREAK, which switches an instrument on.
    void switchOnSerial(const pmts::app::SerialChoice& choice);
    /// Where the device may be back after a loss, besides its USB adapter under another name: the simulator's new pty.
    void offerAddress(const QString& path);
    void disconnectInstrument();
    /// Holds for this and every later connection; a change of mode waits for the transaction that runs.
    void setControl(const pmts::app::ControlSettings& control);
    /// Limits, Sun and cable: asked before every move, on the instrument thread.
    void setGuard(const pmts::targeting::PointingGuardSettings& settings);
    void cableHangsFree();
    /// Yes or no to instrumentAsks().
    void answerInstrument(bool yes);
    void setTargetTest(const pmts::instrument::TargetTest& test);
    /// Ends the running routine and all that waits; on the wire at once.
    void stop();
    /// Ends this request alone, whether it runs or waits; what others asked for goes on.
    void cancel(pmts::app::Ticket ticket);

Q_SIGNALS:
    void connectionChanged(pmts::app::ConnectionState state, const QString& sentence);
    void connectFailed(const pmts::core::Error& error);  ///< nothing answers: the doctor's page
    void identityChanged(const pmts::instrument::Identity& identity);
    void pointingChanged(const pmts::app::TimedPointing& reading);
    void progressChanged(const pmts::instrument::Progress& progress);
    void turned(pmts::app::Ticket ticket, const pmts::geometry::Pointing& arrived);
    void recentringStepped(pmts::app::Ticket ticket, const pmts::targeting::RecentringStep& step);
    void recentred(pmts::app::Ticket ticket, const pmts::targeting::Recentred& proof);
    void sweepStepped(pmts::app::Ticket ticket, const pmts::targeting::SweepStep& step);
    void swept(pmts::app::Ticket ticket, const pmts::targeting::SweepOutcome& outcome);
    void woundChanged();  ///< by more than a tenth of a turn
    /// The telescope stands still and the Sun has come to it; an empty sentence when it has gone again.
    void sunCame(const QString& happened, const QString& remedy);
    void distanceMeasured(pmts::app::Ticket ticket, const pmts::instrument::DistanceShot& shot);
    void modeSet(pmts::app::Ticket ticket, pmts::instrument::EdmMode mode);
    void signalTested(pmts::app::Ticket ticket, bool signal);
    void labelRead(pmts::app::Ticket ticket, int label, const QString& data);
    void labelWritten(pmts::app::Ticket ticket, int label);
    void memoryListed(pmts::app::Ticket ticket, const pmts::instrument::MemoryListing& listing);
    void transferProgressed(pmts::app::Ticket ticket, const pmts::instrument::TransferProgress& progress);
    void fileDownloaded(pmts::app::Ticket ticket, const pmts::instrument::DownloadedFile& file);
    void fileUploaded(pmts::app::Ticket ticket, const pmts::instrument::UploadedFile& file);
    void labelsBackedUp(pmts::app::Ticket ticket, const pmts::protocol::LabelBackup& backup);
    void instrumentAsks(pmts::app::Ticket ticket);  ///< `!` of PV,20: answerInstrument()
    void compensatorCalibrated(pmts::app::Ticket ticket, const pmts::instrument::CompensatorRun& run);
    void routineStepBegan(pmts::app::Ticket ticket, std::size_t index);
    void routineStepped(pmts::app::Ticket ticket, const pmts::instrument::StepOutcome& step);
    void routineRan(pmts::app::Ticket ticket, const pmts::instrument::RoutineOutcome& outcome);
    void requestFailed(pmts::app::Ticket ticket, const pmts::core::Error& error);
    void unsolicitedBlock(const pmts::instrument::UnsolicitedBlock& block);
    /// All that the instrument warns of now (battery low); empty when it is over.
    void warningsChanged(const std::vector<pmts::core::Error>& standing);
    void controlChanged(const pmts::instrument::ControlStatus& status);
    /// Of PMTS and of the panel.
    void transactionFinished(const pmts::scheduler::TransactionRecord& record);
    void strayCame(const pmts::scheduler::Stray& stray);  ///< it answers nobody

private:
    friend class ReplayPresenter;  // shows what a recorded instrument said
    class Worker;
    template <class Start, class Report>
    Ticket request(Start start, Report report);  // in instrument_worker.hpp
    void showConnection(ConnectionState state, const QString& sentence);
    void showIdentity(const instrument::Identity& identity);
    void showPointing(const TimedPointing& reading);
    void showProgress(const instrument::Progress& progress);
    void showWound(core::Angle wound);

    QThread thread_;
    std::shared_ptr<Worker> worker_;
    Ticket last_ticket_ = 0;
    ConnectionState state_ = ConnectionState::kDisconnected;
    QString sentence_;
    std::optional<instrument::Identity> identity_;
    SerialChoice choice_;
    PointingTrack track_;
    instrument::Progress progress_;
    std::optional<core::Angle> wound_;
};

}  // namespace pmts::app
