#include "command_line.hpp"
#include "termination.hpp"

#include <QCoreApplication>

#include <cstdio>

namespace {

constexpr int kBadArguments = 2, kCannotServe = 1;

void print(const QString& text, std::FILE* to = stdout) {
    std::fputs(text.toLocal8Bit().constData(), to);
    std::fflush(to);
}

int complain(const pmts::core::Error& error, int code) {
    print(QStringLiteral("pmts-sim: %1\n").arg(error.sentence()), stderr);
    return code;
}

void announce(const QString& link_path, const QString& slave_name, const QString& what = QStringLiteral("a Geodimeter")) {
    const QString place = link_path.isEmpty() ? slave_name : link_path + QStringLiteral(" -> ") + slave_name;
    print(QStringLiteral("pmts-sim: serving %1 on %2\n").arg(what, place));
}

QString countsText(const pmts::simulator::ControlUnitCounts& counts) {
    return QStringLiteral("pmts-sim: the control unit asked %1 times: %2 answered, %3 unanswered, %4 foreign\n")
        .arg(counts.asked)
        .arg(counts.answered)
        .arg(counts.unanswered)
        .arg(counts.foreign);
}

void announcePanel(pmts::simulator::Simulation& simulation, const QString& link_path) {
    print(QStringLiteral("pmts-sim: a control unit on %1 -> %2\n").arg(link_path, simulation.panelSlaveName()));
    simulation.controlUnit()->on_foreign = [](const QString& sentence) {
        print(QStringLiteral("pmts-sim: %1\n").arg(sentence), stderr);
    };
}

/// Until it is interrupted.
int serveBus(const pmts::simulator::BusSimulationSettings& settings) {
    pmts::core::SystemClock clock;
    const auto simulation = pmts::simulator::BusSimulation::start(settings, clock);
    if (!simulation) {
        const bool bad_argument = simulation.error().kind == pmts::core::ErrorKind::kBadInput;
        return complain(simulation.error(), bad_argument ? kBadArguments : kCannotServe);
    }
    const auto tell = [&settings](const QString& slave_name) {
        announce(settings.link_path, slave_name, QStringLiteral("a Geodimeter's bus"));
    };
    (*simulation)->on_replugged = tell;
    tell((*simulation)->slaveName());
    return QCoreApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    pmts::sim::onTermination(&app, [] { QCoreApplication::quit(); });
    const auto request = pmts::sim::readCommandLine(QCoreApplication::arguments());
    if (!request) {
        return complain(request.error(), kBadArguments);
    }
    if (request->text) {
        print(*request->text);
        return 0;
    }
    if (request->bus) {
        return serveBus(*request->bus);
    }
    pmts::core::SystemClock clock;
    const auto simulation = pmts::simulator::Simulation::start(request->settings, clock);
    if (!simulation) {
        const bool bad_argument = simulation.error().kind == pmts::core::ErrorKind::kBadInput;
        return complain(simulation.error(), bad_argument ? kBadArguments : kCannotServe);
    }
    const QString link = request->settings.link_path;
    (*simulation)->on_replugged = [link](const QString& slave_name) { announce(link, slave_name); };
    announce(link, (*simulation)->slaveName());
    if ((*simulation)->controlUnit() != nullptr) {
        announcePanel(**simulation, request->settings.panel_link_path);
    }
    const int code = QCoreApplication::exec();
    if (const auto* unit = (*simulation)->controlUnit()) {
        print(countsText(unit->counts()));
    }
    return code;
}
