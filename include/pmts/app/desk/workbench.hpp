#pragma once

#include "pmts/app/field/aiming_presenter.hpp"
#include "pmts/app/field/apa_presenter.hpp"
#include "pmts/app/line/axis_test_presenter.hpp"
#include "pmts/app/lab/camera_presenter.hpp"
#include "pmts/app/lab/board_presenter.hpp"
#include "pmts/app/lab/check_presenter.hpp"
#include "pmts/app/desk/connection_presenter.hpp"
#include "pmts/app/desk/connection_checks.hpp"
#include "pmts/app/line/control_presenter.hpp"
#include "pmts/app/field/evidence_collector.hpp"
#include "pmts/app/field/evidence_presenter.hpp"
#include "pmts/app/field/image_marks.hpp"
#include "pmts/app/field/image_routines.hpp"
#include "pmts/app/line/instructions_presenter.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/line/instrument_health.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/job_presenter.hpp"
#include "pmts/app/line/label_backup_presenter.hpp"
#include "pmts/app/line/line_bench_presenter.hpp"
#include "pmts/app/lab/distortion_table_presenter.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/log_model.hpp"
#include "pmts/app/field/mark_keeper.hpp"
#include "pmts/app/line/memory_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/method_report_presenter.hpp"
#include "pmts/app/lab/mount_presenter.hpp"
#include "pmts/app/lab/parallax_presenter.hpp"
#include "pmts/app/field/photo_export.hpp"
#include "pmts/app/field/plan_presenter.hpp"
#include "pmts/app/field/plane_range.hpp"
#include "pmts/app/field/planned_points_model.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/desk/probe_presenter.hpp"
#include "pmts/app/lab/profiles_presenter.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/field/range_presenter.hpp"
#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/app/lab/self_calibration_presenter.hpp"
#include "pmts/app/desk/simulation_desk.hpp"
#include "pmts/app/field/snap_presenter.hpp"
#include "pmts/app/field/station_presenter.hpp"
#include "pmts/app/desk/status_presenter.hpp"
#include "pmts/app/desk/step_runner.hpp"
#include "pmts/app/lab/still_filters.hpp"
#include "pmts/app/field/targeting_presenter.hpp"
#include "pmts/app/lab/twist_presenter.hpp"
#include "pmts/app/line/two_face_presenter.hpp"
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
