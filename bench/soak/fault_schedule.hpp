#pragma once

#include "soak_field.hpp"
#include "standing_troubles.hpp"

#include <list>
#include <map>
#include <random>
#include <string>

namespace pmts::soak {

/// Troubles at random moments, all from the seed: of the instrument, the line, the panel, the disk and the calendar.
class FaultSchedule {
public:
    FaultSchedule(SoakField& field, unsigned seed, core::Duration mean_pause);

    void start();
    /// Nothing happens any more, and everything that was taken away is back.
    void calm();
    /// What is wrong now, and what it may be the reason of.
    [[nodiscard]] StandingTroubles& standing() { return standing_; }
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] const std::map<std::string, int>& counts() const { return counts_; }

private:
    struct Trouble {
        const char* name;
        double weight;
        void (FaultSchedule::*strike)();
    };
    static const std::vector<Trouble>& troubles();

    void next();
    void strikeInstrumentOnce();
    void strikeInstrumentForAWhile();
    void refuseWithACode();
    void switchOff();
    void breakLine();
    void pullPanel();
    void changeMode();
    void jumpCalendar();
    void takeJobAway();
    void pressReg();

    [[nodiscard]] core::Duration between(core::Duration least, core::Duration most);
    [[nodiscard]] QString oneOf(const QStringList& texts);
    void inject(const QString& fault);
    void strikeOnce(const QString& order, const QStringList& sentences, int times = 1);
    /// In force until `put_right`, which runs after a random time.
    void forAWhile(const std::string& name, const QStringList& sentences, core::Duration least, core::Duration most,
                   std::function<void()> put_right);
    void later(core::Duration after, std::function<void()> action);

    SoakField& field_;
    std::mt19937 random_;
    core::Duration mean_pause_;
    core::Timer pause_;
    std::list<core::Timer> ends_;  ///< what puts things right again
    std::uint64_t count_ = 0;
    std::map<std::string, int> counts_;
    StandingTroubles standing_;
};

}  // namespace pmts::soak
