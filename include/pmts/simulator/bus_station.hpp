#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/simulator/world.hpp"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pmts::simulator {

/// Label 102 of the main board brackets every process; what it means is not proven (protocol page 5.3).
enum class Label102 {
    kSuspendsStream,  ///< 0: no angles until it is 1 again
    kTakesControl,    ///< 0: processes are allowed; with 1 they fail
    kNothing,
};

/// The start-up of the base is not disclosed, only that it is long, time critical, and fails while the host is busy with
/// video (thesis 8.3.4). A stand-in: one process, asked for with the arguments 1 to `steps` one after the other.
struct BusStartUp {
    int process = 30;
    int steps = 6;
    core::Duration step_time = std::chrono::milliseconds(20);
    core::Duration patience = std::chrono::milliseconds(500);  ///< from one reply to the host's next command
    double failure_per_frame = 0.0;        ///< probability of a step to fail for each frame the host draws during it
    double failure_per_late_second = 0.0;  ///< and for the time beyond the patience
};

struct BusStationSettings {
    unsigned seed = 1;
    double time_scale = 1.0;
    double baud = 9600.0;  ///< not disclosed; pace of both directions, ten bits a byte; 0: at once
    core::Duration stream_interval = std::chrono::milliseconds(298);  ///< from block to block (protocol page 5.2)
    bool streams_at_start = true;
    core::Angle angle_sigma{}; ///< of each reading of a circle
    std::string reply_end = "\r\x04";         ///< CR and EOT in any combination
    bool third_reply_missing = true;          ///< `PV,4=…`: nothing is listed
    Label102 label_102 = Label102::kSuspendsStream;
    core::Duration turn_around = std::chrono::milliseconds(5);
    core::Duration process_time = std::chrono::milliseconds(60);
    core::Duration calibration_time = std::chrono::seconds(14);  ///< process 20: two faces
    int max_command_length = 80;
    int queue_limit = 10;
    BusStartUp start_up{};
    /// What this base answers to commands that it would not know, by whole command; an empty reply: none. For tables with
    /// routines that the page does not tell.
    std::map<std::string, std::string> more_replies{};
};

/// Fails with kBadInput naming the setting that no base can have.
[[nodiscard]] core::Result<void> checkSettings(const BusStationSettings& settings);

/// The simulated robotic base on its bus (protocol page 5): the angle stream, labels, processes. Written from the page
/// alone. One thread, the one whose clock it is given.
class BusStation {
public:
    BusStation(BusStationSettings settings, std::shared_ptr<const TruePointing> pointing, core::Clock& clock);
    ~BusStation();
    BusStation(const BusStation&) = delete;
    BusStation& operator=(const BusStation&) = delete;

    void receive(std::string_view bytes);
    std::function<void(std::string_view)> send;
    std::function<void(core::Duration)> on_unplug;
    /// Frames that the host has drawn so far; asked on this thread. Empty: a host without video.
    std::function<std::uint64_t()> frames_of_host;

    /// As Station::injectFault(), for the faults of a line: silent, late, twice, garble, half_block, missing_eot, info,
    /// drop, unplug, power_off.
    [[nodiscard]] core::Result<void> injectFault(const QString& fault);
    [[nodiscard]] static const QStringList& faultNames();

    [[nodiscard]] bool isLaserOn() const;  ///< processes 8 and 4 ran inside a bracket
    [[nodiscard]] int mode() const;        ///< process 3
    [[nodiscard]] bool isStarted() const;  ///< every step of the start-up went well
    [[nodiscard]] bool isOn() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
