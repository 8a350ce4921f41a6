#include "board_command.hpp"
#include "command_line.hpp"
#include "method_report_command.hpp"

#include "pmts/gui/main_window.hpp"
#include "pmts/gui/rehearsal.hpp"
#include "pmts/simulator/scene.hpp"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLoggingCategory>

#include <cstdio>

namespace {

using pmts::CommandLine;

constexpr double kRehearsalTimeScale = 3.0;
constexpr QSize kRehearsalSize(1440, 900);
const char* const kRehearsedMarks[] = {"T4", "T5", "T6", "T7", "T3"};

void say(const QString& sentence) { std::fprintf(stderr, "pmts: %s\n", qPrintable(sentence)); }

/// False when a window could not be shown: said in a sentence instead of Qt's abort.
bool hasScreen(bool unattended) {
    if (!qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
        !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) {
        return true;
    }
    if (unattended) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    return unattended;
}

/// The rehearsal starts from nothing: its own data folder, its own job, the simulated instrument.
void prepareRehearsal(CommandLine& line) {
    const QDir folder(line.rehearsal_folder);
    folder.mkpath(QStringLiteral("."));
    for (const char* name : {"job.gpkg", "job.gpkg-wal", "job.gpkg-shm", "points.csv", "05-turning.png"}) {
        QFile::remove(folder.filePath(QLatin1String(name)));
    }
    const QString data = folder.filePath(QStringLiteral("data"));
    QDir(data).removeRecursively();
    line.start.data_folder = data;
    line.start.job_path = folder.filePath(QStringLiteral("job.gpkg"));
    line.start.force_simulated = true;
    if (line.start.simulation.time_scale == 1.0) {
        line.start.simulation.time_scale = kRehearsalTimeScale;
    }
    if (line.window_size.isEmpty()) {
        line.window_size = kRehearsalSize;
    }
}

void chooseInstrument(pmts::app::Workbench& bench, CommandLine& line) {
    if (line.instrument.isEmpty() || line.start.force_simulated) {
        return;
    }
    pmts::app::Settings settings = bench.preferences.settings();
    settings.last_device = pmts::app::LastDevice::kSerial;
    settings.serial.path = line.instrument;
    bench.preferences.set(settings);
}

pmts::core::Result<pmts::gui::RehearsalPlan> rehearsalPlan(const CommandLine& line) {
    namespace simulator = pmts::simulator;
    auto scene = simulator::Scene::named(line.start.simulation.scene_path, line.start.simulation.seed);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    pmts::gui::RehearsalPlan plan{.folder = line.rehearsal_folder, .marks = {}};
    for (const char* name : kRehearsedMarks) {
        for (const simulator::Mark& mark : scene->marks()) {
            if (mark.name == QLatin1String(name)) {
                plan.marks.push_back(
                    {mark.name, mark.p_station_m.x(), mark.p_station_m.y(), mark.p_station_m.z()});
            }
        }
    }
    return plan;
}

pmts::core::Task<void> runRehearsal(pmts::gui::MainWindow& window, pmts::app::Workbench& bench,
                                    pmts::gui::RehearsalPlan plan) {
    auto rehearsal = pmts::gui::rehearse(window, bench, std::move(plan));
    const auto outcome = co_await rehearsal;
    if (!outcome) {
        say(outcome.error().sentence());
    }
    QCoreApplication::exit(outcome ? 0 : 1);
}

/// A command that answers with a text instead of a window.
int answer(const pmts::core::Result<QString>& report) {
    if (!report) {
        say(report.error().sentence());
        return 2;
    }
    std::printf("%s\n", report->toUtf8().constData());
    return 0;
}

int run(CommandLine line) {
    pmts::app::Workbench bench(line.start);
    chooseInstrument(bench, line);
    pmts::gui::MainWindow window(bench);
    if (line.palette) {
        window.usePalette(*line.palette);
    }
    if (line.text_scale > 0.0) {
        window.setTextScale(line.text_scale);
    }
    if (!line.window_size.isEmpty()) {
        window.setWindowState(Qt::WindowNoState);
        window.resize(line.window_size);
    }
    window.show();
    bench.start();
    if (!line.camera) {
        bench.live.setSource(nullptr);
    }
    if (line.rehearsal_folder.isEmpty()) {
        return QApplication::exec();
    }
    auto plan = rehearsalPlan(line);
    if (!plan) {
        say(plan.error().sentence());
        return 1;
    }
    runRehearsal(window, bench, std::move(*plan));
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i) {
        arguments.append(QString::fromLocal8Bit(argv[i]));
    }
    if (arguments.contains(QStringLiteral("--method-report"))) {
        return answer(pmts::methodReportFor(arguments));
    }
    if (arguments.contains(QStringLiteral("--calibrate-board"))) {
        return answer(pmts::boardCalibrationFor(arguments));
    }
    auto line = pmts::commandLineFrom(arguments);
    if (!line) {
        say(line.error().sentence());
        return 2;
    }
    if (line->help || line->version) {
        std::printf("%s",
                    qPrintable(line->help ? pmts::helpText()
                                          : QStringLiteral("pmts %1\n").arg(QStringLiteral(PMTS_VERSION))));
        return 0;
    }
    if (!hasScreen(!line->rehearsal_folder.isEmpty())) {
        say(
            QStringLiteral("There is no screen to open a window on. Start it on a desktop, or give "
                           "--unattended DIR to rehearse without one."));
        return 2;
    }
    if (!line->rehearsal_folder.isEmpty()) {
        prepareRehearsal(*line);
    }
    if (line->instrument == QLatin1String("simulated")) {
        line->start.force_simulated = true;
    }
    QApplication application(argc, argv);
    if (QGuiApplication::platformName() == QLatin1String("offscreen")) {
        QLoggingCategory::setFilterRules(
            QStringLiteral("default.warning=false"));  // it complains of every window it is shown
    }
    QApplication::setApplicationName(QStringLiteral("pmts"));
    QApplication::setApplicationDisplayName(QStringLiteral("PMTS"));
    QApplication::setApplicationVersion(QStringLiteral(PMTS_VERSION));
    QApplication::setOrganizationName(QStringLiteral("pmts"));
    if (line->right_to_left) {
        QApplication::setLayoutDirection(Qt::RightToLeft);
    }
    return run(std::move(*line));
}
