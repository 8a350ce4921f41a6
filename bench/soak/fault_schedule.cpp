#include "fault_schedule.hpp"

#include <cstdio>

namespace pmts::soak {

using namespace std::chrono_literals;

FaultSchedule::FaultSchedule(SoakField& field, unsigned seed, core::Duration mean_pause)
    : field_(field), random_(seed), mean_pause_(mean_pause) {}

const std::vector<FaultSchedule::Trouble>& FaultSchedule::troubles() {
    static const std::vector<Trouble> all = {
        {"instrument, once", 8, &FaultSchedule::strikeInstrumentOnce},
        {"instrument, for a while", 4, &FaultSchedule::strikeInstrumentForAWhile},
        {"info code", 4, &FaultSchedule::refuseWithACode},
        {"switched off", 1, &FaultSchedule::switchOff},
        {"cable", 2, &FaultSchedule::breakLine},
        {"panel's cable", 2, &FaultSchedule::pullPanel},
        {"mode of control", 2, &FaultSchedule::changeMode},
        {"calendar", 1, &FaultSchedule::jumpCalendar},
        {"job file", 1, &FaultSchedule::takeJobAway},
    };
    return all;
}

void FaultSchedule::start() { next(); }

void FaultSchedule::next() {
    std::exponential_distribution<double> pauses(1.0 / std::chrono::duration<double>(mean_pause_).count());
    const auto pause = std::chrono::duration_cast<core::Duration>(std::chrono::duration<double>(pauses(random_)));
    pause_ = field_.time.callAfter(pause, [this] {
        std::vector<double> weights;
        for (const Trouble& trouble : troubles()) {
            weights.push_back(trouble.weight);
        }
        const Trouble& trouble = troubles()[std::discrete_distribution<std::size_t>(weights.begin(), weights.end())(random_)];
        latest_ = field_.time.now();
        ++count_;
        ++counts_[trouble.name];
        (this->*trouble.strike)();
        next();
    });
}

void FaultSchedule::calm() {
    pause_.cancel();
    ends_.clear();
    inject(QStringLiteral("none"));
    field_.plugIn();
    field_.plugPanelIn();
    field_.setMode(scheduler::ControlMode::kShared);
    field_.bringJobBack();
}

core::Duration FaultSchedule::between(core::Duration least, core::Duration most) {
    return core::Duration(std::uniform_int_distribution<core::Duration::rep>(least.count(), most.count())(random_));
}

QString FaultSchedule::oneOf(const QStringList& texts) {
    return texts[std::uniform_int_distribution<qsizetype>(0, texts.size() - 1)(random_)];
}

void FaultSchedule::inject(const QString& fault) {
    if (const auto injected = field_.station.injectFault(fault); !injected) {
        std::fprintf(stderr, "soak: %s\n", qPrintable(injected.error().sentence()));
        std::exit(2);
    }
}

void FaultSchedule::later(core::Duration after, std::function<void()> action) {
    ends_.push_back(field_.time.callAfter(after, std::move(action)));
}

void FaultSchedule::strikeInstrumentOnce() {
    inject(oneOf({QStringLiteral("silent"), QStringLiteral("silent,on=RG,times=3"), QStringLiteral("late=3"),
                  QStringLiteral("late=20"), QStringLiteral("twice"), QStringLiteral("garble"), QStringLiteral("half_block"),
                  QStringLiteral("missing_eot"), QStringLiteral("stray_end_marks"), QStringLiteral("line_error=4"),
                  QStringLiteral("line_error=1"), QStringLiteral("distance_late"), QStringLiteral("distance_jump"),
                  QStringLiteral("target_lost"), QStringLiteral("target_not_found"), QStringLiteral("motor_overload_h"),
                  QStringLiteral("motor_overload_v"), QStringLiteral("end_switch"), QStringLiteral("initialising"),
                  QStringLiteral("panel_task"), QStringLiteral("reg_key"), QStringLiteral("memory_lost"),
                  QStringLiteral("unplug=7")}));
}

void FaultSchedule::strikeInstrumentForAWhile() {
    const QString name = oneOf({QStringLiteral("drop"), QStringLiteral("garble"), QStringLiteral("tg_ignored"),
                                QStringLiteral("no_signal"), QStringLiteral("residual_h"), QStringLiteral("residual_v"),
                                QStringLiteral("level_loss"), QStringLiteral("battery_low"), QStringLiteral("info_23_loop")});
    const QString value = name == u"garble" ? QStringLiteral("=0.01") : name == u"drop" ? QStringLiteral("=0.03") : QString();
    inject(name + value);
    later(between(10s, 3min), [this, name] { inject(name + QStringLiteral("=off")); });
}

void FaultSchedule::refuseWithACode() {
    inject(QStringLiteral("info=%1").arg(oneOf({QStringLiteral("4"), QStringLiteral("20"), QStringLiteral("23"), QStringLiteral("24"),
                                                QStringLiteral("30"), QStringLiteral("35"), QStringLiteral("40"), QStringLiteral("156"),
                                                QStringLiteral("160"), QStringLiteral("161"), QStringLiteral("174"),
                                                QStringLiteral("190"), QStringLiteral("197"), QStringLiteral("207"),
                                                QStringLiteral("248"), QStringLiteral("999")})));
}

void FaultSchedule::switchOff() { inject(QStringLiteral("power_off=%1").arg(between(5s, 2min) / 1s)); }

void FaultSchedule::breakLine() {
    field_.pullCable();
    later(between(1s, 2min), [this] { field_.plugIn(); });
}

void FaultSchedule::pullPanel() {
    field_.pullPanel();
    later(between(1s, 2min), [this] { field_.plugPanelIn(); });
}

void FaultSchedule::changeMode() {
    field_.setMode(std::bernoulli_distribution(0.5)(random_) ? scheduler::ControlMode::kPanel : scheduler::ControlMode::kComputer);
    later(between(5s, 2min), [this] { field_.setMode(scheduler::ControlMode::kShared); });
}

void FaultSchedule::jumpCalendar() {
    constexpr qint64 kDay_s = 86400;
    field_.clock.jump(std::uniform_int_distribution<qint64>(-30 * kDay_s, 30 * kDay_s)(random_));
}

void FaultSchedule::takeJobAway() {
    field_.moveJobAway();
    later(between(5s, 1min), [this] { field_.bringJobBack(); });
}

}  // namespace pmts::soak
