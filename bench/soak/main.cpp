#include "surveyor.hpp"

#include "support/figure.hpp"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QLoggingCategory>

#include <cstdio>

// Three days of simulated work with random faults from a seed. The thesis's version failed every three days.
namespace {

using namespace std::chrono_literals;
using namespace pmts;

void print(unsigned seed, const soak::Tally& tally, const soak::FaultSchedule& faults, const simulator::ControlUnitCounts& panel) {
    std::printf("seed %u: %llu points recorded, %llu of them blocks of REG, %llu moves, %llu while a distance was pending, %llu "
                "troubles; the panel asked %llu times, %llu answered\n", seed,
                static_cast<unsigned long long>(tally.recorded + tally.blocks), static_cast<unsigned long long>(tally.blocks),
                static_cast<unsigned long long>(tally.turned), static_cast<unsigned long long>(tally.impatient),
                static_cast<unsigned long long>(faults.count()), static_cast<unsigned long long>(panel.asked),
                static_cast<unsigned long long>(panel.answered));
    for (const auto& [name, times] : faults.counts()) {
        std::printf("  %5d x trouble: %s\n", times, name.c_str());
    }
    for (const auto& [sentence, times] : tally.refused) {
        std::printf("  %5d x %s\n", times, sentence.c_str());
    }
}

soak::Tally soakWith(unsigned seed, core::Duration span) {
    soak::SoakField field(seed);
    field.openJob();
    field.connect();
    field.until([&field] { return field.isConnected() && !field.instrument.isBusy(); }, 1min);
    soak::FaultSchedule faults(field, seed + 1, 5min);
    soak::Surveyor surveyor(field, faults, seed + 2);
    surveyor.work(span);
    faults.calm();
    print(seed, surveyor.tally(), faults, field.panel.counts());
    const auto gate = field.gate().statistics();
    std::printf("video: %llu pictures shown, %llu dropped in %llu pauses\n", static_cast<unsigned long long>(field.camera->shown()),
                static_cast<unsigned long long>(gate.frames_dropped), static_cast<unsigned long long>(gate.pauses));
    return surveyor.tally();
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication program(argc, argv);
    QLoggingCategory::setFilterRules(QStringLiteral("*=false"));
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("hours"), QStringLiteral("Virtual hours for each seed."), QStringLiteral("H"), QStringLiteral("72")});
    parser.addPositionalArgument(QStringLiteral("seeds"), QStringLiteral("Seeds, 1 unless said."), QStringLiteral("[SEED...]"));
    parser.addHelpOption();
    parser.process(program);
    const auto span = std::chrono::duration_cast<core::Duration>(
        std::chrono::duration<double, std::ratio<3600>>(parser.value(QStringLiteral("hours")).toDouble()));
    QStringList seeds = parser.positionalArguments();
    if (seeds.isEmpty()) {
        seeds << QStringLiteral("1");
    }
    soak::Tally all;
    for (const QString& seed : seeds) {
        const soak::Tally tally = soakWith(seed.toUInt(), span);
        all.recorded += tally.recorded;
        all.deadlocks += tally.deadlocks;
        all.wrong += tally.wrong;
        all.lost += tally.lost;
        all.unexplained += tally.unexplained;
    }
    bench::figure("soak.deadlocks", static_cast<double>(all.deadlocks), "", bench::Wanted::kAtMost, 0);
    bench::figure("soak.wrong_records", static_cast<double>(all.wrong), "", bench::Wanted::kAtMost, 0);
    bench::figure("soak.lost_records", static_cast<double>(all.lost), "", bench::Wanted::kAtMost, 0);
    bench::figure("soak.unexplained_failures", static_cast<double>(all.unexplained), "", bench::Wanted::kAtMost, 0);
    return all.deadlocks + all.wrong + all.lost + all.unexplained == 0 && all.recorded > 0 ? 0 : 1;
}
