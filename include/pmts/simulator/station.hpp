#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/simulator/scene.hpp"
#include "pmts/simulator/world.hpp"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <string_view>

namespace pmts::simulator {

/// What the protocol page leaves open, and what a test wants otherwise. Every "sim default" of the page is a field here.
struct StationSettings {
    unsigned seed = 1;
    double speed_gon_s = 50.0;
    double acceleration_gon_s2 = 100.0;
    core::Duration settle = std::chrono::seconds(1);
    core::Duration std_time = std::chrono::seconds(5);
    core::Duration fast_std_time = std::chrono::seconds(1);
    core::Duration trk_interval = std::chrono::milliseconds(400);
    double edm_sigma_m = 0.003, edm_sigma_ppm = 3.0;
    core::Angle angle_sigma = core::Angle::fromCc(3);
    core::Angle collimation, index_error, trunnion_error;
    QString unit_status = QStringLiteral("1111");
    QString serial_number = QStringLiteral("620123");
    int end_mark = 62;
    bool trigger_ends_late = false;  ///< EOT of TG at the end of the measurement instead of at once
    bool bare_station = false;       ///< behaviour 13: TG without effect, writes answer 0.0
    bool target_test = true;         ///< 30 cm / 50 mgon, status 4
    QString reading_while_measuring = QStringLiteral("angles");  ///< or "4", "7"
    bool mode_command_stops_motion = true;  ///< the page knows no stop: PG,3 ends a motion with 190
    int max_command_length = 80;
    int queue_limit = 10;
    QString output = QStringLiteral("request");  ///< or reg_key, slave
    double time_scale = 1.0;  ///< 2: motors, EDM and the wire run twice as fast
    double baud = 9600.0;     ///< pace of the answers; 0: at once
};

/// The simulated instrument: bytes in, bytes out, time from the clock. Written from the protocol page alone.
class Station {
public:
    Station(StationSettings settings, std::shared_ptr<const Scene> scene, std::shared_ptr<TruePointing> pointing, core::Clock& clock);
    ~Station();
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    void receive(std::string_view bytes);
    std::function<void(std::string_view)> send;

    /// Faults on demand, by name, e.g. `silent`, `late`, `twice`, `garble`, `drop=0.05`, `info=156`, `battery_low`. See faultNames().
    [[nodiscard]] core::Result<void> injectFault(const QString& fault);
    [[nodiscard]] static QStringList faultNames();
    void pressRegKey();  ///< what the operator does: a block without request

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
