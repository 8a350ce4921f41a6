#pragma once

#include "pmts/core/clock.hpp"

#include <QString>
#include <QStringList>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pmts::soak {

/// A trouble in force, and what it may be the reason of.
struct Standing {
    std::string name;
    QStringList sentences;  ///< parts of what the program may say because of it; none: nothing may fail because of it
    core::Duration from{0};
    std::optional<core::Duration> until;  ///< absent: it has not ended yet
    QString fault;                        ///< of the simulated instrument: ends when it has struck that often
    int ends_at_strike = 0;
    core::Duration aftermath{0};  ///< so long after its end an action may still fail because of it
};

/// What is wrong now, and what was until a moment ago. An action that fails has to be explained by a trouble that was in
/// force while it ran, with a sentence that this trouble may cause.
class StandingTroubles {
public:
    /// How often a fault of the simulated instrument has struck.
    using TimesStruck = std::function<int(const QString& fault)>;
    explicit StandingTroubles(TimesStruck times_struck) : times_struck_(std::move(times_struck)) {}

    void begin(const std::string& name, const QStringList& sentences, core::Duration at, core::Duration aftermath);
    /// One that ends by itself, after so many strokes.
    void beginUntilStruck(const std::string& name, const QStringList& sentences, core::Duration at, core::Duration aftermath,
                          const QString& fault, int times);
    void end(const std::string& name, core::Duration at);
    void endAll(core::Duration at);
    /// To be called often: ends those that have struck, forgets those that are long over.
    void look(core::Duration at);

    [[nodiscard]] bool explain(const QString& said, core::Duration from) const;
    [[nodiscard]] std::string names(core::Duration from) const;  ///< of those in force since then
    /// How many of each kind have struck and ended.
    [[nodiscard]] const std::map<std::string, std::uint64_t>& ended() const { return ended_; }

private:
    [[nodiscard]] static bool wasInForce(const Standing& trouble, core::Duration from);

    TimesStruck times_struck_;
    std::vector<Standing> standing_;
    std::map<QString, int> ordered_;  ///< strokes of each fault that are struck or still to come
    std::map<std::string, std::uint64_t> ended_;
};

/// What the program may say of a fault of the simulated instrument, by its name; `info` with its code.
[[nodiscard]] QStringList sentencesOf(const QString& fault, int code = 0);
/// What it may say while nothing comes from the instrument.
[[nodiscard]] const QStringList& sentencesOfALostLine();

}  // namespace pmts::soak
