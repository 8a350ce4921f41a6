#pragma once

#include "fault_schedule.hpp"

#include <deque>
#include <map>
#include <random>
#include <string>

namespace pmts::soak {

/// What three days of work came to.
struct Tally {
    std::uint64_t turned = 0, recorded = 0;
    std::map<std::string, int> refused;  ///< how often each sentence was the end of an action
    std::uint64_t blocks = 0;            ///< points of blocks that nobody asked for
    std::uint64_t impatient = 0;         ///< moves asked for while a distance was pending
    std::uint64_t unexplained = 0;       ///< an action that failed without a sentence, or with one that no trouble in force may cause
    std::uint64_t deadlocks = 0;         ///< an action without an end, or no way back to work when all is well again
    std::uint64_t wrong = 0;             ///< recorded points that differ from the truth
    std::uint64_t lost = 0;              ///< acknowledged and not in the job file, or changed there
};

/// Turns, measures, records, over and over, as somebody who presses the same two keys again after a failure; compares each
/// record with the simulator's truth when it is acknowledged, with the job file and with the black box at the end.
class Surveyor {
public:
    Surveyor(SoakField& field, FaultSchedule& faults, unsigned seed);

    void work(core::Duration span);
    [[nodiscard]] const Tally& tally() const { return tally_; }

private:
    bool turn();
    bool record();
    void rest();
    /// All is well again: the instrument must be back and a point recorded.
    void demandWork();
    /// Asked for while the distance is pending: it waits its turn, and the shot belongs to where it began.
    void askForAMove();
    void judgeMove();
    void failed(const QString& sentence);
    void considerBlock();
    void check(const survey::Point& point);
    void checkBlock(const survey::Point& point);
    [[nodiscard]] geometry::Pointing truthAtShot();
    void demandPictures();
    void compareWithFile();
    void compareWithBlackBox();
    void complain(const char* what, const QString& details);

    SoakField& field_;
    FaultSchedule& faults_;
    std::mt19937 random_;
    Tally tally_;
    std::vector<survey::Point> recorded_;
    std::size_t own_records_ = 0;  ///< not of blocks
    std::optional<std::size_t> boxed_from_;  ///< recorded since the black box runs
    std::optional<geometry::Pointing> offered_at_;  ///< where REG was pressed for the block that is offered
    std::deque<geometry::Pointing> arrivals_;  ///< of the shots that are not recorded yet, oldest first
    core::Duration began_at_{0};  ///< the action
    core::Duration last_word_at_{0};
    QString last_word_;  ///< the newest sentence the program said
};

}  // namespace pmts::soak
