#include "pmts/app/desk/workbench.hpp"

#include "pmts/app/line/black_box_presenter.hpp"
#include "pmts/app/line/bug_report_presenter.hpp"
#include "pmts/app/line/replay_presenter.hpp"
#include "pmts/app/line/timeline.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/simulator/line_framing.hpp"
#include "serial_settings.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QStandardPaths>

namespace pmts::app {

namespace {

QString usualDataFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation); }

core::Error badArgument(const QString& argument) {
    return {.kind = core::ErrorKind::kBadInput,
            .happened = QCoreApplication::translate("StartOptions", "PMTS does not understand “%1”.").arg(argument),
            .remedy = QCoreApplication::translate("StartOptions",
                                                  "Known: --data DIR, --job FILE, --simulated, --seed N, --time-scale X, "
                                                  "--scene FILE, --fault NAME, --line 4800-8N1, --camera-lens brown|rational|fisheye|thesis, "
                                                  "--camera-mount telescope|handle, --rig-error N, --replay FILE, --speed X."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// Takes one option with its value; false when the option is unknown or its value cannot be read.
bool takeOption(StartOptions& options, const QString& option, const QString& value) {
    bool is_read = true;
    if (option == QLatin1String("--data")) {
        options.data_folder = value;
    } else if (option == QLatin1String("--job")) {
        options.job_path = value;
    } else if (option == QLatin1String("--seed")) {
        options.simulation.seed = value.toUInt(&is_read);
    } else if (option == QLatin1String("--time-scale")) {
        options.simulation.time_scale = value.toDouble(&is_read);
        is_read = is_read && options.simulation.time_scale > 0.0;
    } else if (option == QLatin1String("--scene")) {
        options.simulation.scene_path = value;
    } else if (option == QLatin1String("--fault")) {
        options.simulation.faults.append(value);
    } else if (option == QLatin1String("--line")) {
        options.simulation.line = value;
        is_read = simulator::LineFraming::fromText(value).has_value();
    } else if (option == QLatin1String("--camera-lens")) {
        const auto lens = simulator::cameraLensFromText(value);
        is_read = lens.has_value();
        options.simulation.camera.lens = lens.value_or(simulator::CameraLens::kBrown);
    } else if (option == QLatin1String("--camera-mount")) {
        is_read = value == QLatin1String("telescope") || value == QLatin1String("handle");
        options.simulation.camera.mount =
            value == QLatin1String("handle") ? camera::MountKind::kHandle : camera::MountKind::kTelescope;
    } else if (option == QLatin1String("--replay")) {
        options.replay_path = value;
    } else if (option == QLatin1String("--speed")) {
        options.replay_speed = value.toDouble(&is_read);
        is_read = is_read && options.replay_speed > 0.0;
    } else if (option == QLatin1String("--rig-error")) {
        options.simulation.camera.rig_error = value.toUInt(&is_read);
    } else {
        return false;
    }
    return is_read && !value.isEmpty();
}

StartOptions withFolder(StartOptions options) {
    if (options.data_folder.isEmpty()) {
        options.data_folder = usualDataFolder();
    }
    QDir().mkpath(options.data_folder);
    return options;
}

QString inFolder(const StartOptions& options, const char* name) {
    return QDir(options.data_folder).filePath(QLatin1String(name));
}

/// The readings that keep HA and VA fresh, twenty a second: they would push everything else out of the log.
bool isPlainPoll(const scheduler::TransactionRecord& record) {
    return !record.timed_out && record.master == scheduler::Master::kComputer && (record.sent == "RG,7\r" || record.sent == "RG,8\r");
}

QString wireText(const scheduler::TransactionRecord& record) {
    const double took_ms = std::chrono::duration<double, std::milli>(record.finished_at - record.sent_at).count();
    const bool of_panel = record.master == scheduler::Master::kPanel;
    return QStringLiteral("%1%2 -> %3 (%4 ms%5%6%7)")
        .arg(of_panel ? QStringLiteral("panel: ") : QString(), bytesText(record.sent), bytesText(record.received))
        .arg(took_ms, 0, 'f', 1)
        .arg(record.timed_out ? QStringLiteral(", timed out") : QString(),
             record.video_paused ? QStringLiteral(", video paused") : QString(),
             record.outcome == scheduler::Outcome::kSwallowed ? QStringLiteral(", swallowed") : QString());
}

bool isReplay(const StartOptions& options) { return !options.replay_path.isEmpty(); }

/// A replay reads the settings and keeps nothing: the program beside it may be at work with them.
Settings settingsOf(const StartOptions& options) {
    Settings settings = Settings::load(inFolder(options, "settings.ini"));
    settings.last_job.clear();
    return settings;
}

/// Every port is recorded; in a replay none opens.
InstrumentWiring wiringFor(const StartOptions& options, const BlackBoxPresenter& black_box) {
    InstrumentWiring wiring;
    if (isReplay(options)) {
        wiring.make_link = [](const SerialChoice&) { return ReplayPresenter::barredLink(); };
    } else {
        wiring.make_link = [&black_box](const SerialChoice& choice) {
            return black_box.tapped(std::make_unique<transport::SerialLink>(serialSettings(choice)));
        };
    }
    return wiring;
}

/// The same for the search for an instrument.
ProbeWiring probeWiringFor(const StartOptions& options, const BlackBoxPresenter& black_box) {
    ProbeWiring wiring;
    if (isReplay(options)) {
        wiring.make_link = [](const transport::SerialSettings&) { return ReplayPresenter::barredLink(); };
    } else {
        wiring.make_link = [&black_box](const transport::SerialSettings& line) {
            return black_box.tapped(std::make_unique<transport::SerialLink>(line));
        };
    }
    return wiring;
}

/// What answers nobody, and the angle stream where it is what tells the angles.
void watchUnasked(InstrumentDesk& instrument, Timeline& timeline) {
    QObject::connect(&instrument, &InstrumentDesk::strayCame, &timeline, &Timeline::addUnasked);
    QObject::connect(&instrument, &InstrumentDesk::pointingChanged, &timeline, [&](const TimedPointing& reading) {
        if (instrument.choice().dialect == instrument::LineDialect::kBus) {
            timeline.addStreamReading(reading.pointing, reading.at);
        }
    });
}

}  // namespace

core::Result<StartOptions> StartOptions::fromArguments(const QStringList& arguments) {
    StartOptions options;
    for (int i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == QLatin1String("--simulated")) {
            options.force_simulated = true;
        } else if (!takeOption(options, arguments[i], arguments.value(i + 1))) {
            return tl::unexpected(badArgument(arguments[i]));
        } else {
            ++i;
        }
    }
    return options;
}

Workbench::Workbench(StartOptions options, QObject* parent)
    : QObject(parent),
      options_(withFolder(std::move(options))),
      log(isReplay(options_) ? QString() : inFolder(options_, "pmts.log")),
      preferences(isReplay(options_) ? QString() : inFolder(options_, "settings.ini")),
      black_box(std::make_unique<BlackBoxPresenter>(inFolder(options_, "blackbox"), preferences, messages, clock)),
      range(preferences.settings().assumed_range_m),
      instrument(gate, wiringFor(options_, *black_box)),
      points(job_desk, preferences, messages, undo),
      planned(job_desk, preferences, messages, undo),
      station(job_desk, points, instrument, preferences, messages, undo),
      live(instrument, points, station, range, job_desk, preferences, messages, gate, clock),
      camera(live, preferences, messages),
      targeting(instrument, live, points, station, range, preferences, messages),
      aiming(preferences, instrument, station, clock),
      evidence_collector(targeting, live, preferences, clock),
      recording(instrument, job_desk, points, station, range, preferences, messages, clock),
      job(job_desk, preferences, messages),
      photo_export(job_desk, messages),
      connection(instrument, simulation, live, gate, preferences, messages),
      connection_checks(instrument),
      probe(connection, instrument, simulation, probeWiringFor(options_, *black_box)),
      control(instrument, preferences, messages, clock),
      plan(points, planned, station, instrument, range),
      evidence(job_desk, points, preferences, messages),
      status(job, station, connection, live, control, instrument),
      method_report(live, job_desk, points, station, range, preferences),
      apa(live, instrument, preferences, messages),
      ranges(range, preferences),
      plane_range(range, points, station, preferences, messages),
      mark_keeper(marks, job_desk, live, messages),
      routines(live, marks, preferences),
      snap(live, preferences),
      steps(targeting, clock),
      mount(live, instrument, preferences, messages),
      twist(live, instrument, preferences, messages),
      board_parallax(live, instrument, range, preferences, messages),
      distortion_table(live, instrument, range, preferences, messages),
      self_calibration(live, instrument, preferences, messages),
      profiles(preferences, live, instrument, messages, clock),
      board(live, preferences, messages, clock),
      check(live, instrument, points, preferences, profiles, clock),
      timeline(std::make_unique<Timeline>(clock)),
      bug_report(std::make_unique<BugReportPresenter>(*black_box, preferences, job_desk, log.filePath(), clock)),
      memory(instrument, planned, messages),
      label_backup(instrument, messages),
      health(instrument, preferences, messages, clock),
      axis_test(instrument, health, preferences, messages, clock),
      two_faces(instrument, job_desk, points, station, preferences, messages),
      instruction_file(inFolder(options_, "instructions.txt"), clock),
      instructions(instruction_file, instrument, messages, clock),
      line_bench(messages, options_.data_folder) {
    connection.setSimulation(options_.simulation);
    recording.collect_evidence = [this](const geometry::Pointing& shot) { return evidence_collector.collect(shot); };
    wireMessages();
    wireMarks();
    wireTimeline();
    if (isReplay(options_)) {
        preferences.set(settingsOf(options_));
        replay = std::make_unique<ReplayPresenter>(
            ReplayStage{.instrument = instrument, .live = live, .log = log, .messages = messages, .timeline = *timeline, .range = range,
                        .health = &health},
            clock);
        return;
    }
    wireSimulatedPanel();
    wireBlackBox();  // before the log: its lines are recorded from the first
    wireLog();
}

Workbench::~Workbench() {
    // Presenters first lose the picture and the wire, then the members go in reverse order of their building: the
    // job desk writes what is queued, the instrument desk closes its port before the simulator's end of it goes.
    live.setSource(nullptr);
    instrument.disconnect(this);
}

void Workbench::wireBlackBox() {
    black_box->watch(instrument);
    black_box->watch(live, gate);
    black_box->watch(log);
    connect(&profiles, &ProfilesPresenter::changed, this, [this] { black_box->noteAir(profiles.temperature()); });
    connect(&health, &InstrumentHealth::changed, this, [this] {
        black_box->noteAir(health.air());
        timeline->addAir(health.air().temperature_degc, health.air().pressure_mbar, clock.now());
    });
}

void Workbench::wireTimeline() {
    connect(&instrument, &InstrumentDesk::transactionFinished, timeline.get(), &Timeline::addTransaction);
    connect(&instrument, &InstrumentDesk::controlChanged, timeline.get(), &Timeline::addControl);
    connect(&instrument, &InstrumentDesk::connectionChanged, timeline.get(), [this](ConnectionState state, const QString& sentence) {
        timeline->addConnection(sentence, state == ConnectionState::kReconnecting ? LineHealth::kFailed : LineHealth::kNote);
    });
    connect(&instrument, &InstrumentDesk::identityChanged, timeline.get(), [this](const instrument::Identity& identity) {
        timeline->setUnits(identity.units_known ? std::optional(identity.units) : std::nullopt);
    });
    const auto take_names = [this] { timeline->setNames(line_bench.names().all()); };
    connect(&line_bench, &LineBenchPresenter::changed, timeline.get(), take_names);
    take_names();
    if (!isReplay(options_)) {
        watchUnasked(instrument, *timeline);
        connect(&profiles, &ProfilesPresenter::changed, timeline.get(), [this] {
            timeline->addAir(profiles.temperature(), std::nullopt, clock.now());
        });
        connect(&live, &LivePresenter::sceneChanged, timeline.get(), [this] {
            if (const auto& frame = live.scene().frame) {
                timeline->addFrame(frame->captured_at, frame->sequence, gate.statistics().frames_dropped);
            }
        });
    }
}

void Workbench::wireLog() {
    log.utc_now = [this] { return clock.utcNow(); };
    log.install();
    connect(&instrument, &InstrumentDesk::transactionFinished, this,
            [this](const scheduler::TransactionRecord& record) {
                if (!isPlainPoll(record)) {
                    log.appendWire(wireText(record));
                }
            });
    connect(&instrument, &InstrumentDesk::connectionChanged, this, [this](ConnectionState, const QString& sentence) {
        if (job_desk.isOpen()) {
            job_desk.log({.utc = clock.utcNow(), .category = QStringLiteral("instrument"), .text = sentence});
        }
    });
    const auto log_message = [this](const Message& message) {
        log.append({.utc = clock.utcNow(),
                    .level = message.kind == MessageKind::kProblem ? QtWarningMsg : QtInfoMsg,
                    .category = QStringLiteral("message"),
                    .text = QStringList{message.happened, message.remedy, message.details}.join(u' ').trimmed()});
    };
    connect(&messages, &MessageCentre::toastShown, this, log_message);
    connect(&messages, &MessageCentre::barKept, this, log_message);
}

void Workbench::wireMessages() {
    connect(&preferences, &Preferences::problemReported, this, [this](const core::Error& error) {
        messages.report(error, MessageAction::kOpenSettings, QStringLiteral("settings"));
    });
    connect(&job_desk, &JobDesk::openFailed, this, &Workbench::openSampleInstead);
    connect(&preferences, &Preferences::changed, this, [this] {
        const double assumed_m = preferences.settings().assumed_range_m;
        if (assumed_m != range.assumed()) {
            range.setAssumed(assumed_m);
        }
    });
}

void Workbench::wireMarks() {
    connect(&planned, &PlannedPointsModel::plannedChanged, this, [this] { live.setPlannedPoints(planned.points()); });
    connect(&marks, &ImageMarks::changed, this, [this] {
        std::vector<OverlayPlace> places;
        for (const ImageMark& mark : marks.marks()) {
            places.push_back({.kind = OverlayKind::kMark,
                              .p_station = geometry::stationFromPolar(
                                  {.pointing = mark.pointing, .slope_distance_m = mark.slope_distance_m}),
                              .label = mark.label,
                              .code = {},
                              .row_id = mark.id});
        }
        live.setExtraPlaces(std::move(places));
    });
}

void Workbench::wireSimulatedPanel() {
    connect(&simulation, &SimulationDesk::panelPlugged, this, [this](const QString& port_path) {
        if (port_path.isEmpty()) {
            control.removePanelForNow();
            return;
        }
        SerialChoice port;
        port.path = port_path;
        control.usePanelForNow(port);
    });
}

QString Workbench::sampleJobPath() const { return inFolder(options_, "sample.gpkg"); }

void Workbench::start() {
    if (replay) {
        return replay->open(options_.replay_path, options_.replay_speed);
    }
    black_box->start();
    const QString last_job = preferences.settings().last_job;
    const QString wanted = !options_.job_path.isEmpty() ? options_.job_path : last_job;
    if (wanted.isEmpty()) {
        job_desk.openOrCreate(sampleJobPath());
    } else if (!options_.job_path.isEmpty()) {
        job_desk.openOrCreate(wanted);
    } else {
        job_desk.open(wanted);
    }
    const bool serial = preferences.settings().last_device == LastDevice::kSerial && !options_.force_simulated;
    if (serial) {
        startRealDevices();
    } else {
        connection.startSimulated();
    }
}

void Workbench::startRealDevices() {
    const video::SourceAddress& chosen = preferences.settings().camera;
    if (chosen.kind != video::SourceKind::kSimulated) {  // a drawn picture would lie about what a real telescope sees
        connection.chooseCamera(chosen);
    }
    connection.connectSerial(connection.serialChoice());
}

void Workbench::openSampleInstead(const QString& path) {
    if (!job_desk.isOpen() && path != sampleJobPath() && options_.job_path.isEmpty()) {
        job_desk.openOrCreate(sampleJobPath());
    }
}

}  // namespace pmts::app
