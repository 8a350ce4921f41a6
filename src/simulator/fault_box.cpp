#include "fault_box.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::simulator {
namespace {

using enum FaultKind::Lasts;

QString tr(const char* text) { return QCoreApplication::translate("SimulatorFaults", text); }

std::vector<FaultKind> makeKinds() {
    const auto kind = [](const char* name, FaultKind::Lasts lasts, std::optional<double> usual,
                         const char* unit, const char* sentence) {
        return FaultKind{QString::fromLatin1(name), lasts, usual, QString::fromLatin1(unit), tr(sentence)};
    };
    const std::optional<double> none;
    // clang-format off
    return {
        kind("silent", kOnce, none, "", "The command is carried out, but its answer never comes."),
        kind("late", kOnce, 3.0, "s", "The answer comes late."),
        kind("twice", kOnce, none, "", "The answer comes twice."),
        kind("garble", kOnce, 0.0, "probability",
             "About a fifth of the answer's bytes are changed; with a value, each byte of the line from now on with this "
             "probability."),
        kind("half_block", kOnce, none, "", "The answer breaks off in the middle, without its end mark."),
        kind("missing_eot", kOnce, none, "", "The answer is whole, but its end mark is lost."),
        kind("stray_end_marks", kOnce, none, "", "Stray end marks stand before the answer."),
        kind("info", kOnce, 0.0, "info code",
             "The command is not carried out and is answered with this info code (155, 156 and 157: carried out all the same)."),
        kind("line_error", kOnce, 1.0, "bit sum",
             "The command is lost on the line, info 21: 1 overrun, 2 parity, 4 framing, 8 break, or their sum."),
        kind("drop", kUntilOff, 0.05, "probability", "Each byte of the line is lost with this probability, both ways."),
        kind("unplug", kAtOnce, 5.0, "s", "The cable is pulled and put back; the instrument stays on."),
        kind("no_cu", kUntilOff, none, "",
             "The body is without its control unit: TG is accepted without effect, writes are answered 0.0."),
        kind("tg_ignored", kUntilOff, none, "", "TG is accepted without effect."),
        kind("no_signal", kUntilOff, none, "", "Every target absorbs: RGT says 300 and a distance never completes."),
        kind("distance_late", kOnce, 20.0, "s", "The next distance takes this much longer."),
        kind("distance_jump", kOnce, none, "", "The next distance ends with info 175, as after swapping prisms quickly."),
        kind("target_lost", kOnce, none, "", "The next distance ends with info 161, target lost."),
        kind("target_not_found", kOnce, none, "", "The next positioning ends with info 158, target not found."),
        kind("residual_h", kUntilOff, 20.0, "cc", "The horizontal axis settles beside its target; 155 when out of tolerance."),
        kind("residual_v", kUntilOff, 20.0, "cc", "The vertical axis settles beside its target; 156 when out of tolerance."),
        kind("motor_overload_h", kOnce, none, "", "The next positioning stops half way with info 151."),
        kind("motor_overload_v", kOnce, none, "", "The next positioning stops half way with info 152."),
        kind("end_switch", kOnce, none, "", "The next positioning stops half way with info 153, end switch."),
        kind("level_loss", kUntilOff, none, "", "The compensator is out of its range: angle readings are refused with info 1."),
        kind("battery_low", kUntilOff, none, "", "Good readings come with info 8, battery low, instead of 0."),
        kind("auto_power_off", kUntilOff, 60.0, "s", "The instrument switches itself off when it is left alone."),
        kind("power_off", kAtOnce, 0.0, "s", "The instrument goes off; with a value it is back after that time."),
        kind("initialising", kAtOnce, 5.0, "s", "The instrument starts up: nothing sent meanwhile is heard."),
        kind("panel_task", kAtOnce, 5.0, "s", "Somebody works at the control unit: commands are answered with info 197."),
        kind("memory_lost", kAtOnce, none, "", "The backup cell is dead: all labels are reset, the next reading says info 51."),
        kind("info_23_loop", kUntilOff, 1.0, "s", "Wrong pins are driven: an unasked info 23 again and again."),
        kind("reg_key", kAtOnce, none, "", "Somebody presses REG: a block that nobody asked for."),
    };
    // clang-format on
}

/// `garble` strikes once without a value and lasts with one.
bool isLasting(const Fault& fault) {
    return findFaultKind(fault.name)->lasts == kUntilOff || (fault.name == u"garble" && fault.value > 0.0);
}

core::Result<double> valueFrom(const QString& text) {
    bool ok = false;
    const double value = text.toDouble(&ok);
    if (!ok || value < 0.0) {
        return core::fail(core::ErrorKind::kBadInput,
                          tr("\"%1\" is not a number that a fault can take.").arg(text));
    }
    return value;
}

core::Result<void> applyOption(Fault& fault, const QString& option) {
    const QString key = option.section(u'=', 0, 0);
    const QString text = option.section(u'=', 1);
    if (key == u"on" && !text.isEmpty()) {
        fault.on = text.toStdString();
        return {};
    }
    if (key != u"times" && key != u"seed") {
        return core::fail(core::ErrorKind::kBadInput, tr("A fault has no option \"%1\".").arg(option),
                          tr("The options are on=COMMAND, times=N and seed=N."));
    }
    const auto value = valueFrom(text);
    if (!value) {
        return tl::unexpected(value.error());
    }
    if (key == u"times") {
        fault.times = static_cast<int>(*value);
    } else {
        fault.seed = static_cast<unsigned>(*value);
    }
    return {};
}

}  // namespace

const std::vector<FaultKind>& Station::faultKinds() {
    static const std::vector<FaultKind> kinds = makeKinds();
    return kinds;
}

QStringList Station::faultNames() {
    QStringList names;
    for (const FaultKind& kind : faultKinds()) {
        names << kind.name;
    }
    return names;
}

const FaultKind* findFaultKind(const QString& name) {
    const auto& kinds = Station::faultKinds();
    const auto found = std::ranges::find(kinds, name, &FaultKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

core::Result<Fault> parseFault(const QString& text) {
    QStringList parts = text.trimmed().split(u',');
    const QString first = parts.takeFirst();
    Fault fault;
    fault.name = first.section(u'=', 0, 0);
    const QString value = first.section(u'=', 1);
    const FaultKind* kind = findFaultKind(fault.name);
    if (kind == nullptr) {
        return core::fail(core::ErrorKind::kBadInput,
                          tr("The simulator knows no fault \"%1\".").arg(fault.name),
                          tr("It knows: %1.").arg(Station::faultNames().join(QStringLiteral(", "))));
    }
    fault.value = kind->usual_value.value_or(0.0);
    fault.off = value == u"off";
    if (!value.isEmpty() && !fault.off) {
        const auto number = valueFrom(value);
        if (!number || !kind->usual_value) {
            return core::fail(core::ErrorKind::kBadInput,
                              kind->usual_value ? number.error().happened
                                                : tr("The fault %1 takes no value.").arg(fault.name));
        }
        fault.value = *number;
    }
    for (const QString& option : std::as_const(parts)) {
        PMTS_TRY(applyOption(fault, option));
    }
    return fault;
}

void FaultBox::add(const Fault& fault) {
    if (fault.seed) {
        random_.seed(*fault.seed);
    }
    if (fault.off || isLasting(fault)) {
        std::erase_if(faults_, [&](const Fault& known) { return known.name == fault.name; });
    }
    if (!fault.off) {
        faults_.push_back(fault);
    }
}

std::optional<double> FaultBox::value(const char* name) const {
    const auto found = std::ranges::find(faults_, QLatin1String(name), &Fault::name);
    return found == faults_.end() ? std::nullopt : std::optional(found->value);
}

std::optional<double> FaultBox::take(const char* name, std::string_view command) {
    const auto found = std::ranges::find_if(faults_, [&](const Fault& fault) {
        return fault.name == QLatin1String(name) && command.starts_with(fault.on) && !isLasting(fault);
    });
    if (found == faults_.end()) {
        return std::nullopt;
    }
    const double value = found->value;
    strike(found->name);
    if (found->times == 1) {
        faults_.erase(found);
    } else if (found->times > 1) {
        --found->times;
    }
    return value;
}

int FaultBox::timesStruck(const QString& name) const {
    const auto found = struck_.find(name);
    return found == struck_.end() ? 0 : found->second;
}

bool FaultBox::chance(double probability) {
    return std::uniform_real_distribution(0.0, 1.0)(random_) < probability;
}

char FaultBox::otherThan(char byte) {
    const char other = static_cast<char>(std::uniform_int_distribution(0x20, 0x7E)(random_));
    return other == byte ? '#' : other;
}

std::string FaultBox::throughBadLine(std::string_view bytes) {
    const double lost = value("drop").value_or(0.0), changed = value("garble").value_or(0.0);
    if (lost <= 0.0 && changed <= 0.0) {
        return std::string(bytes);
    }
    std::string rest;
    for (const char byte : bytes) {
        if (chance(lost)) {
            strike(QStringLiteral("drop"));
        } else if (chance(changed)) {
            strike(QStringLiteral("garble"));
            rest += otherThan(byte);
        } else {
            rest += byte;
        }
    }
    return rest;
}

std::string FaultBox::garbled(std::string_view bytes) {
    constexpr double kPart = 0.2;
    std::string changed(bytes);
    for (char& byte : changed) {
        byte = chance(kPart) ? otherThan(byte) : byte;
    }
    if (changed == bytes && !changed.empty()) {
        changed.front() = otherThan(changed.front());
    }
    return changed;
}

}  // namespace pmts::simulator
