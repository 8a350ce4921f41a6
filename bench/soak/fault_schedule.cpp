#include "fault_schedule.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace pmts::soak {

using namespace std::chrono_literals;

namespace {

/// Reconnecting, settling of a line that was noisy, the rest of a learned limit.
constexpr core::Duration kAftermath = 90s;
/// `initialising`, `panel_task` and `unplug` end by themselves sooner.
constexpr core::Duration kSpanOfItself = 8s;

}  // namespace

FaultSchedule::FaultSchedule(SoakField& field, unsigned seed, core::Duration mean_pause)
    : field_(field), random_(seed), mean_pause_(mean_pause),
      standing_([&field](const QString& fault) { return field.station.timesStruck(fault); }) {
    // The panel works all the time, and two masters at one distance meter take distances from one another.
    standing_.begin("panel at work", {QStringLiteral("The panel measured or read at the same time")}, field.time.now(), {});
}

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
        {"REG pressed", 2, &FaultSchedule::pressReg},
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
        standing_.look(field_.time.now());
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
    standing_.endAll(field_.time.now());
    standing_.begin("panel at work", {QStringLiteral("The panel measured or read at the same time")}, field_.time.now(), {});
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

void FaultSchedule::strikeOnce(const QString& order, const QStringList& sentences, int times) {
    inject(order);
    const QString fault = order.section(u',', 0, 0).section(u'=', 0, 0);
    standing_.beginUntilStruck(order.toStdString(), sentences, field_.time.now(), kAftermath, fault, times);
}

void FaultSchedule::forAWhile(const std::string& name, const QStringList& sentences, core::Duration least, core::Duration most,
                              std::function<void()> put_right) {
    standing_.begin(name, sentences, field_.time.now(), kAftermath);
    later(between(least, most), [this, name, put_right = std::move(put_right)] {
        put_right();
        standing_.end(name, field_.time.now());
    });
}

void FaultSchedule::strikeInstrumentOnce() {
    struct Order {
        const char* text;
        int times;
    };
    static constexpr std::array kOrders = {
        Order{"silent", 1}, Order{"silent,on=RG,times=3", 3}, Order{"late=3", 1}, Order{"late=20", 1}, Order{"twice", 1},
        Order{"garble", 1}, Order{"half_block", 1}, Order{"missing_eot", 1}, Order{"stray_end_marks", 1},
        Order{"line_error=4", 1}, Order{"line_error=1", 1}, Order{"distance_late", 1}, Order{"distance_jump", 1},
        Order{"target_lost", 1}, Order{"target_not_found", 1}, Order{"motor_overload_h", 1}, Order{"motor_overload_v", 1},
        Order{"end_switch", 1}, Order{"initialising", 0}, Order{"panel_task", 0},
        Order{"memory_lost", 1}, Order{"unplug=7", 0}};
    const Order& order = kOrders[std::uniform_int_distribution<std::size_t>(0, kOrders.size() - 1)(random_)];
    const QString text = QString::fromLatin1(order.text);
    const QString fault = text.section(u',', 0, 0).section(u'=', 0, 0);
    if (order.times > 0) {
        strikeOnce(text, sentencesOf(fault), order.times);
        return;
    }
    inject(text);  // it lasts some seconds by itself
    forAWhile(order.text, sentencesOf(fault), kSpanOfItself, kSpanOfItself, [] {});
}

void FaultSchedule::strikeInstrumentForAWhile() {
    const QString name = oneOf({QStringLiteral("drop"), QStringLiteral("garble"), QStringLiteral("tg_ignored"),
                                QStringLiteral("no_signal"), QStringLiteral("residual_h"), QStringLiteral("residual_v"),
                                QStringLiteral("level_loss"), QStringLiteral("battery_low"), QStringLiteral("info_23_loop")});
    const QString value = name == u"garble" ? QStringLiteral("=0.01") : name == u"drop" ? QStringLiteral("=0.03") : QString();
    inject(name + value);
    forAWhile(name.toStdString() + " for a while", sentencesOf(name), 10s, 3min,
              [this, name] { inject(name + QStringLiteral("=off")); });
}

void FaultSchedule::refuseWithACode() {
    static constexpr std::array kCodes = {4, 20, 23, 24, 26, 30, 35, 40, 51, 54, 156, 157, 160, 161, 174, 190, 197, 207, 248, 999};
    const int code = kCodes[std::uniform_int_distribution<std::size_t>(0, kCodes.size() - 1)(random_)];
    strikeOnce(QStringLiteral("info=%1").arg(code), sentencesOf(QStringLiteral("info"), code));
}

void FaultSchedule::switchOff() {
    const core::Duration span = std::chrono::floor<std::chrono::seconds>(between(5s, 2min));
    inject(QStringLiteral("power_off=%1").arg(span / 1s));
    forAWhile("switched off", sentencesOfALostLine(), span, span, [] {});
}

void FaultSchedule::breakLine() {
    field_.pullCable();
    forAWhile("cable", sentencesOfALostLine(), 1s, 2min, [this] { field_.plugIn(); });
}

void FaultSchedule::pullPanel() {
    field_.pullPanel();
    forAWhile("panel's cable", {}, 1s, 2min, [this] { field_.plugPanelIn(); });
}

void FaultSchedule::changeMode() {
    const bool gives_away = std::bernoulli_distribution(0.5)(random_);
    field_.setMode(gives_away ? scheduler::ControlMode::kPanel : scheduler::ControlMode::kComputer);
    const QStringList barred{QStringLiteral("The panel has control")};
    forAWhile(gives_away ? "panel has control" : "computer has control", gives_away ? barred : QStringList(), 5s, 2min,
              [this] { field_.setMode(scheduler::ControlMode::kShared); });
}

/// At a quiet moment mostly; in the middle of a shot it is no person's.
void FaultSchedule::pressReg() { field_.pressReg(); }

/// No failure may be explained by the calendar.
void FaultSchedule::jumpCalendar() {
    constexpr qint64 kDay_s = 86400;
    field_.time.setTimeOfDayBy(std::chrono::seconds(std::uniform_int_distribution<qint64>(-30 * kDay_s, 30 * kDay_s)(random_)));
}

void FaultSchedule::takeJobAway() {
    field_.moveJobAway();
    forAWhile("job file", {QStringLiteral("is not recorded; the shot is kept"), QStringLiteral("Not recorded: press R")}, 5s, 1min,
              [this] { field_.bringJobBack(); });
}

}  // namespace pmts::soak
