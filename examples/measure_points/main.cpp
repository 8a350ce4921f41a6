// Measures a list of pointings and prints them as CSV: what a user's own program on PMTS's routines looks like.
//
//     pmts-sim --link /tmp/geodimeter &
//     measure-points /tmp/geodimeter 0,100 12.5,98.3 > points.csv
//
// Each pointing is HA,VA in gon. Exit code 0 when all were measured, 1 when some were not, 2 without an instrument.

#include "pmts/routines/instrument.hpp"
#include "pmts/transport/serial_link.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <cstdio>
#include <vector>

namespace {

using pmts::core::Result;
using pmts::core::Task;
using pmts::routines::Instrument;

struct Wanted {
    double ha_gon, va_gon;
};

std::vector<Wanted> wantedFrom(const QStringList& texts) {
    std::vector<Wanted> wanted;
    for (const QString& text : texts) {
        const QStringList angles = text.split(u',');
        bool ha_ok = false, va_ok = false;
        const Wanted pointing{angles.value(0).toDouble(&ha_ok), angles.value(1).toDouble(&va_ok)};
        if (angles.size() != 2 || !ha_ok || !va_ok) {
            return {};
        }
        wanted.push_back(pointing);
    }
    return wanted;
}

void complain(const pmts::core::Error& error) { std::fprintf(stderr, "measure-points: %s\n", qPrintable(error.sentence())); }

/// Turns there, then measures: the routine reads top to bottom, the event loop goes on meanwhile.
Task<Result<void>> measure(Instrument& station, Wanted wanted) {
    auto turning = station.movHV(wanted.ha_gon, wanted.va_gon);
    PMTS_CO_TRY(co_await turning);
    auto shooting = station.Dist();
    const auto shot = co_await shooting;
    PMTS_CO_TRY(shot);
    std::printf("%.4f,%.4f,%.3f\n", shot->pointing.ha.gon(), shot->pointing.va.gon(), shot->slope_distance_m);
    co_return Result<void>();
}

Task<void> measureAll(Instrument& station, std::vector<Wanted> all) {
    auto starting = station.Start();
    const auto who = co_await starting;
    if (!who) {
        complain(who.error());
        QCoreApplication::exit(2);
        co_return;
    }
    auto asking = station.prg1("RG,23");  // any instruction of the manual
    if (const auto units = co_await asking) {
        std::fprintf(stderr, "measure-points: instrument %s, units %s\n", qPrintable(who->serial_number), units->raw.c_str());
    }
    std::puts("HA_gon,VA_gon,SD_m");
    int failed = 0;
    for (const Wanted& wanted : all) {
        auto measuring = measure(station, wanted);
        if (const auto outcome = co_await measuring; !outcome) {
            complain(outcome.error());
            ++failed;
        }
    }
    QCoreApplication::exit(failed == 0 ? 0 : 1);
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication program(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    const std::vector<Wanted> wanted = wantedFrom(arguments.mid(2));
    if (wanted.empty()) {
        std::fputs("usage: measure-points PORT HA,VA [HA,VA ...]      gon\n", stderr);
        return 2;
    }
    pmts::transport::SerialSettings port;
    port.port_name = arguments[1];
    pmts::core::SystemClock clock;
    Instrument station(std::make_unique<pmts::transport::SerialLink>(port), clock);
    station.Timer1_Timer = [](const pmts::routines::PortData& data) {
        if (data.block) {
            std::fprintf(stderr, "measure-points: REG was pressed: %s\n", qPrintable(data.block->raw));
        }
    };
    pmts::core::post([&station, &wanted] { measureAll(station, wanted); });  // once the event loop runs
    return QCoreApplication::exec();
}
