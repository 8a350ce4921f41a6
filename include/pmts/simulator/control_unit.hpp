#pragma once

#include "pmts/core/clock.hpp"

#include <QString>

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

namespace pmts::simulator {

struct ControlUnitSettings {
    unsigned seed = 1;
    double time_scale = 1.0;
    double baud = 9600.0;  ///< pace of what it sends; 0: at once
    int end_mark = 62;     ///< label 79; 0: silence ends a reply
    QString serial_number = QStringLiteral("620123");          ///< of the instrument, known to the unit
    core::Duration shortest_pause = std::chrono::milliseconds(50);  ///< between two commands
    core::Duration longest_pause = std::chrono::milliseconds(1500);
    core::Duration patience = std::chrono::seconds(60);  ///< for one answer: a motion of the other side is waited for
    core::Duration quiet_time = std::chrono::milliseconds(500);
};

/// What a control unit has seen: on a line shared well `foreign` is 0, and so is `unanswered` while the cable is whole.
struct ControlUnitCounts {
    std::uint64_t asked = 0;
    std::uint64_t answered = 0;    ///< each by exactly the answer to its command
    std::uint64_t unanswered = 0;  ///< patience gone
    std::uint64_t foreign = 0;     ///< blocks that are no answer to what it asked: refusals, other labels, fragments
    std::uint64_t unasked = 0;     ///< whole blocks of data while it asked nothing
};

/// A simulated control unit (GCU) at the other end of a panel port: reads angles and labels, writes and reads back the
/// point number, triggers distances and polls them, at random times from the seed, and checks every answer against what it
/// asked. Written from the protocol page alone. One thread, the one whose clock it is given.
class ControlUnit {
public:
    ControlUnit(ControlUnitSettings settings, core::Clock& clock);
    ~ControlUnit();
    ControlUnit(const ControlUnit&) = delete;
    ControlUnit& operator=(const ControlUnit&) = delete;

    void start();  ///< the operator switches it on
    void stop();
    void receive(std::string_view bytes);
    std::function<void(std::string_view)> send;
    /// Somebody is at the other end of its cable; empty: always. It asks nothing meanwhile.
    std::function<bool()> is_plugged;
    std::function<void(const QString& sentence)> on_foreign;
    [[nodiscard]] const ControlUnitCounts& counts() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
