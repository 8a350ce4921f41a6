#include "standing_troubles.hpp"

#include "pmts/protocol/info_code.hpp"

#include <algorithm>

namespace pmts::soak {
namespace {

constexpr core::Duration kLongOver = std::chrono::hours(1);

QStringList words(std::initializer_list<const char*> texts) {
    QStringList list;
    for (const char* text : texts) {
        list << QString::fromLatin1(text);
    }
    return list;
}

/// Bytes are lost or changed.
const QStringList& sentencesOfABadLine() {
    static const QStringList all =
        sentencesOfALostLine() + words({"arrived damaged", "could not be read reliably", "did not keep the", "did not understand",
                                        "serial line was disturbed", "gave no usable distance", "a command was missing"});
    return all;
}

/// The connection begins anew, and until the units are known no reading is believed.
QStringList sentencesOfLostSettings() {
    return words({"check sum in the instrument's memory", "has lost its memory", "units of the instrument are not known", "not connected"});
}

}  // namespace

const QStringList& sentencesOfALostLine() {
    static const QStringList all = words({"did not answer in time", "No distance came back", "The connection over",
                                          "Nothing answers on this port", "not connected", "No instrument is connected", "was unplugged"});
    return all;
}

QStringList sentencesOf(const QString& fault, int code) {
    static const std::map<QString, QStringList> known = {
        {"silent", sentencesOfABadLine()},
        {"late", sentencesOfABadLine()},
        {"twice", {}},
        {"garble", sentencesOfABadLine()},
        {"half_block", sentencesOfABadLine()},
        {"missing_eot", {}},
        {"stray_end_marks", {}},
        {"line_error", {}},
        {"distance_late", words({"No distance came back"})},
        {"distance_jump", words({"above 32 km"})},
        {"target_lost", words({"target was lost"})},
        {"target_not_found", words({"target was not found"})},
        {"motor_overload_h", words({"horizontal motor is overloaded"})},
        {"motor_overload_v", words({"vertical motor is overloaded"})},
        {"end_switch", words({"end switch"})},
        {"initialising", sentencesOfALostLine()},
        {"panel_task", words({"inside the instrument is busy"})},
        {"reg_key", {}},
        {"memory_lost", sentencesOfLostSettings()},
        {"unplug", sentencesOfALostLine()},
        {"power_off", sentencesOfALostLine()},
        {"drop", sentencesOfABadLine()},
        {"tg_ignored", words({"No distance came back"})},
        {"no_signal", words({"No distance came back"})},
        {"residual_h", words({"beside its target"})},
        {"residual_v", words({"beside its target"})},
        {"level_loss", words({"tilted beyond"})},
        {"battery_low", {}},
        {"info_23_loop", words({"waited in vain", "got more commands than it can keep"})},
    };
    if (fault == u"info") {
        const bool loses_settings = code == 51 || code == 54;
        return QStringList{protocol::infoCode(code).happened} + (loses_settings ? sentencesOfLostSettings() : QStringList());
    }
    const auto found = known.find(fault);
    return found == known.end() ? QStringList() : found->second;
}

void StandingTroubles::begin(const std::string& name, const QStringList& sentences, core::Duration at,
                             core::Duration aftermath) {
    standing_.push_back({.name = name, .sentences = sentences, .from = at, .until = {}, .fault = {}, .ends_at_strike = 0,
                         .aftermath = aftermath});
}

void StandingTroubles::beginUntilStruck(const std::string& name, const QStringList& sentences, core::Duration at,
                                        core::Duration aftermath, const QString& fault, int times) {
    begin(name, sentences, at, aftermath);
    int& ordered = ordered_[fault];
    ordered = std::max(ordered, times_struck_(fault)) + times;
    standing_.back().fault = fault;
    standing_.back().ends_at_strike = ordered;
}

void StandingTroubles::end(const std::string& name, core::Duration at) {
    for (Standing& trouble : standing_) {
        if (trouble.name == name && !trouble.until) {
            trouble.until = at;
            ++ended_[trouble.name];
        }
    }
}

void StandingTroubles::endAll(core::Duration at) {
    look(at);
    for (Standing& trouble : standing_) {
        trouble.until = trouble.until.value_or(at);
    }
    ordered_.clear();
}

void StandingTroubles::look(core::Duration at) {
    for (Standing& trouble : standing_) {
        if (!trouble.until && !trouble.fault.isEmpty() && times_struck_(trouble.fault) >= trouble.ends_at_strike) {
            trouble.until = at;
            ++ended_[trouble.name];
        }
    }
    std::erase_if(standing_, [at](const Standing& trouble) { return trouble.until && at - *trouble.until > kLongOver; });
}

bool StandingTroubles::wasInForce(const Standing& trouble, core::Duration from) {
    return !trouble.until || *trouble.until + trouble.aftermath >= from;
}

bool StandingTroubles::explain(const QString& said, core::Duration from) const {
    return std::ranges::any_of(standing_, [&](const Standing& trouble) {
        return wasInForce(trouble, from) && std::ranges::any_of(trouble.sentences, [&](const QString& sentence) {
                   return said.contains(sentence, Qt::CaseInsensitive);
               });
    });
}

std::string StandingTroubles::names(core::Duration from) const {
    std::string names;
    for (const Standing& trouble : standing_) {
        if (wasInForce(trouble, from)) {
            names += (names.empty() ? "" : ", ") + trouble.name;
        }
    }
    return names.empty() ? "nothing" : names;
}

}  // namespace pmts::soak
