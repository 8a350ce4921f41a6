#include "command_line.hpp"

#include <QCommandLineParser>

namespace pmts::sim {
namespace {

const QCommandLineOption kHelp({QStringLiteral("h"), QStringLiteral("help")},
                               QStringLiteral("Shows this text."));
const QCommandLineOption kVersion(QStringLiteral("version"), QStringLiteral("Shows the version."));
const QCommandLineOption kLink(QStringLiteral("link"),
                               QStringLiteral("Makes PATH a link to the instrument's port."),
                               QStringLiteral("PATH"));
const QCommandLineOption kPanelLink(
    QStringLiteral("panel-link"),
    QStringLiteral("Simulates a control unit too and makes PATH a link to the port that passes it on to the instrument."),
    QStringLiteral("PATH"));
const QCommandLineOption kSeed(QStringLiteral("seed"),
                               QStringLiteral("Seed of the scene, all noise and all faults (1)."),
                               QStringLiteral("N"));
const QCommandLineOption kTimeScale(
    QStringLiteral("time-scale"), QStringLiteral("Motors, distance meter and line run X times as fast (1)."),
    QStringLiteral("X"));
const QCommandLineOption kScene(QStringLiteral("scene"),
                                QStringLiteral("The world to measure, instead of the town square."),
                                QStringLiteral("FILE"));
const QCommandLineOption kFault(
    QStringLiteral("fault"),
    QStringLiteral("Orders a fault, NAME[=VALUE][,on=COMMAND][,times=N][,seed=N]; more may follow."),
    QStringLiteral("NAME"));
const QCommandLineOption kBaud(QStringLiteral("baud"), QStringLiteral("Pace of the line, 0 for none (9600)."),
                               QStringLiteral("N"));
const QCommandLineOption kLine(
    QStringLiteral("line"),
    QStringLiteral("The only line setting it understands, e.g. 4800-8N1, and its pace; otherwise every one. A "
                   "pseudo-terminal shows speed, stop bits and odd parity of the other side, no more."),
    QStringLiteral("SETTING"));
const QCommandLineOption kUnits(
    QStringLiteral("units"),
    QStringLiteral("Label 23: pressure, temperature, length, angle (1111: mbar, deg C, metre, gon)."),
    QStringLiteral("DIGITS"));
const QCommandLineOption kOutput(QStringLiteral("output"),
                                 QStringLiteral("What sends a block: request, reg_key or slave (request)."),
                                 QStringLiteral("WAY"));
const QCommandLineOption kBus(QStringLiteral("bus"),
                              QStringLiteral("Serves the base on the bus under its panel instead of the external interface."));
const QCommandLineOption kFaults(QStringLiteral("list-faults"), QStringLiteral("Lists the faults by name."));

QString faultList() {
    QString text;
    for (const simulator::FaultKind& kind : simulator::Station::faultKinds()) {
        const QString value = kind.usual_value ? QStringLiteral("=%1").arg(kind.unit.toUpper()) : QString();
        text += QStringLiteral("  %1  %2\n").arg(kind.name + value, -24).arg(kind.sentence);
    }
    return text;
}

tl::unexpected<core::Error> refuse(const QString& happened) {
    return core::fail(core::ErrorKind::kBadInput, happened, QStringLiteral("Try pmts-sim --help."));
}

/// Leaves `target` alone when the option was not given.
template <class Number>
core::Result<void> readNumber(const QCommandLineParser& parser, const QCommandLineOption& option,
                              Number& target) {
    if (!parser.isSet(option)) {
        return {};
    }
    const QString text = parser.value(option);
    bool ok = false;
    if constexpr (std::is_integral_v<Number>) {
        target = text.toUInt(&ok);
    } else {
        target = text.toDouble(&ok);
    }
    return ok ? core::Result<void>()
              : refuse(QStringLiteral("--%1 takes a number, not \"%2\".").arg(option.names().last(), text));
}

core::Result<simulator::SimulationSettings> settingsFrom(const QCommandLineParser& parser) {
    simulator::SimulationSettings settings;
    PMTS_TRY(readNumber(parser, kSeed, settings.station.seed));
    PMTS_TRY(readNumber(parser, kTimeScale, settings.station.time_scale));
    PMTS_TRY(readNumber(parser, kBaud, settings.station.baud));
    if (parser.isSet(kLine)) {
        settings.station.line = simulator::LineFraming::fromText(parser.value(kLine));
        if (!settings.station.line) {
            return refuse(QStringLiteral("--line takes a setting like 4800-8N1, not \"%1\".").arg(parser.value(kLine)));
        }
        settings.station.baud = settings.station.line->baud;
    }
    settings.link_path = parser.value(kLink);
    settings.panel_link_path = parser.value(kPanelLink);
    settings.scene_path = parser.value(kScene);
    settings.faults = parser.values(kFault);
    if (parser.isSet(kUnits)) {
        settings.station.unit_status = parser.value(kUnits);
    }
    if (parser.isSet(kOutput)) {
        settings.station.output = parser.value(kOutput);
    }
    const QStringList rest = parser.positionalArguments();
    if (!rest.isEmpty() && settings.faults.isEmpty()) {
        return refuse(QStringLiteral("\"%1\" was not expected.").arg(rest.first()));
    }
    settings.faults += rest;  // --fault NAME NAME...
    PMTS_TRY(simulator::checkSettings(settings.station));
    return settings;
}

/// What the base on its bus shares with the whole instrument.
core::Result<simulator::BusSimulationSettings> busSettingsFrom(const simulator::SimulationSettings& settings) {
    if (!settings.panel_link_path.isEmpty() || !settings.scene_path.isEmpty()) {
        return refuse(QStringLiteral("The base on its bus has no scene and no panel of its own."));
    }
    simulator::BusSimulationSettings bus;
    bus.station.seed = settings.station.seed;
    bus.station.time_scale = settings.station.time_scale;
    bus.station.baud = settings.station.baud;
    bus.link_path = settings.link_path;
    bus.faults = settings.faults;
    PMTS_TRY(simulator::checkSettings(bus.station));
    return bus;
}

}  // namespace

core::Result<Request> readCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Serves a simulated Geodimeter total station on a pseudo-terminal, until it is interrupted."));
    parser.addOptions(
        {kHelp, kVersion, kLink, kPanelLink, kSeed, kTimeScale, kScene, kFault, kBaud, kLine, kUnits, kOutput, kBus,
         kFaults});
    if (!parser.parse(arguments)) {
        return refuse(parser.errorText());
    }
    if (parser.isSet(kHelp)) {
        return Request{.settings = {}, .text = parser.helpText() + QStringLiteral("\nFaults:\n") + faultList()};
    }
    if (parser.isSet(kVersion)) {
        return Request{.settings = {}, .text = QStringLiteral("pmts-sim " PMTS_VERSION "\n")};
    }
    if (parser.isSet(kFaults)) {
        return Request{.settings = {}, .text = faultList()};
    }
    auto settings = settingsFrom(parser);
    PMTS_TRY(settings);
    if (parser.isSet(kBus)) {
        auto bus = busSettingsFrom(*settings);
        PMTS_TRY(bus);
        return Request{.settings = {}, .bus = *std::move(bus)};
    }
    return Request{.settings = *std::move(settings)};
}

}  // namespace pmts::sim
