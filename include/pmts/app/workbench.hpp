#pragma once

#include "pmts/app/aiming_presenter.hpp"
#include "pmts/app/apa_presenter.hpp"
#include "pmts/app/axis_test_presenter.hpp"
#include "pmts/app/camera_presenter.hpp"
#include "pmts/app/board_presenter.hpp"
#include "pmts/app/check_presenter.hpp"
#include "pmts/app/connection_presenter.hpp"
#include "pmts/app/connection_checks.hpp"
#include "pmts/app/control_presenter.hpp"
#include "pmts/app/evidence_collector.hpp"
#include "pmts/app/evidence_presenter.hpp"
#include "pmts/app/image_marks.hpp"
#include "pmts/app/image_routines.hpp"
#include "pmts/app/instructions_presenter.hpp"
#include "pmts/app/instrument_desk.hpp"
#include "pmts/app/instrument_health.hpp"
#include "pmts/app/job_desk.hpp"
#include "pmts/app/job_presenter.hpp"
#include "pmts/app/label_backup_presenter.hpp"
#include "pmts/app/line_bench_presenter.hpp"
#include "pmts/app/distortion_table_presenter.hpp"
#include "pmts/app/live_presenter.hpp"
#include "pmts/app/log_model.hpp"
#include "pmts/app/mark_keeper.hpp"
#include "pmts/app/memory_presenter.hpp"
#include "pmts/app/message_centre.hpp"
#include "pmts/app/method_report_presenter.hpp"
#include "pmts/app/mount_presenter.hpp"
#include "pmts/app/parallax_presenter.hpp"
#include "pmts/app/photo_export.hpp"
#include "pmts/app/plan_presenter.hpp"
#include "pmts/app/plane_range.hpp"
#include "pmts/app/planned_points_model.hpp"
#include "pmts/app/points_model.hpp"
#include "pmts/app/preferences.hpp"
#include "pmts/app/probe_presenter.hpp"
#include "pmts/app/profiles_presenter.hpp"
#include "pmts/app/range_keeper.hpp"
#include "pmts/app/range_presenter.hpp"
#include "pmts/app/recording_presenter.hpp"
#include "pmts/app/self_calibration_presenter.hpp"
#include "pmts/app/simulation_desk.hpp"
#include "pmts/app/snap_presenter.hpp"
#include "pmts/app/station_presenter.hpp"
#include "pmts/app/status_presenter.hpp"
#include "pmts/app/step_runner.hpp"
#include "pmts/app/still_filters.hpp"
#include "pmts/app/targeting_presenter.hpp"
#include "pmts/app/twist_presenter.hpp"
#include "pmts/app/two_face_presenter.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/core/video_gate.hpp"

#include <QObject>
#include <QUndoStack>

#include <memory>

namespace pmts::app {

class BlackBoxPresenter;
class BugReportPresenter;
class ReplayPresenter;
class Timeline;

/// What the command line may say. Empty paths mean the usual places.
struct StartOptions {
    QString data_folder;        ///< app-data: log, settings, sample job
    QString job_path;           ///< empty: the last job, or `sample.gpkg`, created when missing
    bool force_simulated = false;
    SimulationChoice simulation;
    QString replay_path;        ///< a black box file that is shown instead of devices; empty: devices
    double replay_speed = 1.0;

    /// `--data DIR --job FILE --simulated --seed N --time-scale X --scene FILE --fault NAME --line 4800-8N1`, and the
    /// simulated camera's `--camera-lens NAME --camera-mount KIND --rig-error N`; `--replay FILE --speed X`. kBadInput names
    /// the argument.
    [[nodiscard]] static core::Result<StartOptions> fromArguments(const QStringList& arguments);
};

/// Builds everything in the right order and takes it down in the reverse one. Members are public on purpose: the window
/// wires itself to the presenters it shows.
class Workbench : public QObject {
    Q_OBJECT
public:
    explicit Workbench(StartOptions options, QObject* parent = nullptr);
    ~Workbench() override;

    /// Opens the job, connects the instrument, starts the camera. Asks nothing, returns at once.
    void start();
    [[nodiscard]] const StartOptions& options() const { return options_; }
    [[nodiscard]] QString sampleJobPath() const;

private:
    StartOptions options_;  // built first: the paths of the log and the settings

public:
    core::SystemClock clock;
    core::VideoGate gate;
    LogModel log;
    Preferences preferences;
    MessageCentre messages;
    std::unique_ptr<BlackBoxPresenter> black_box;  ///< before the instrument: its links are recorded
    QUndoStack undo;
    RangeKeeper range;
    SimulationDesk simulation;
    InstrumentDesk instrument;
    JobDesk job_desk;
    PointsModel points;
    PlannedPointsModel planned;
    StationPresenter station;
    LivePresenter live;
    CameraPresenter camera;
    TargetingPresenter targeting;
    AimingPresenter aiming;
    EvidenceCollector evidence_collector;
    RecordingPresenter recording;
    JobPresenter job;
    PhotoExport photo_export;
    ConnectionPresenter connection;
    ConnectionChecks connection_checks;
    ProbePresenter probe;
    ControlPresenter control;
    PlanPresenter plan;
    EvidencePresenter evidence;
    StatusPresenter status;
    MethodReportPresenter method_report;
    ApaPresenter apa;
    RangePresenter ranges;
    PlaneRange plane_range;
    ImageMarks marks;
    MarkKeeper mark_keeper;
    ImageRoutines routines;
    SnapPresenter snap;
    StepRunner steps;
    MountPresenter mount;
    TwistPresenter twist;
    ParallaxPresenter board_parallax;
    DistortionTablePresenter distortion_table;
    SelfCalibrationPresenter self_calibration;
    ProfilesPresenter profiles;
    BoardPresenter board;
    CheckPresenter check;
    StillFilters still_filters;
    std::unique_ptr<Timeline> timeline;
    std::unique_ptr<BugReportPresenter> bug_report;
    std::unique_ptr<ReplayPresenter> replay;  ///< null unless a black box file is shown
    MemoryPresenter memory;
    LabelBackupPresenter label_backup;
    InstrumentHealth health;
    AxisTestPresenter axis_test;
    TwoFacePresenter two_faces;
    InstructionFile instruction_file;  ///< the table in use, for the routine library too
    InstructionsPresenter instructions;
    LineBenchPresenter line_bench;

private:
    void wireBlackBox();
    void wireTimeline();
    void wireLog();
    void wireMessages();
    void wireMarks();
    void wireSimulatedPanel();
    void startRealDevices();
    void openSampleInstead(const QString& path);
};

}  // namespace pmts::app
