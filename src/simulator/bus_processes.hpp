#pragma once

#include "command_line.hpp"
#include "pmts/simulator/bus_station.hpp"

#include <random>

namespace pmts::simulator {

/// The processes of the simulated base's main board: what is known of them (protocol page 5.3, 5.4), and the start-up's
/// stand-in.
class BusProcesses {
public:
    explicit BusProcesses(const BusStationSettings& settings);

    struct Run {
        int number = 0;
        int argument = 0;
        std::optional<std::string> refusal;  ///< instead of running
        core::Duration takes{0};
        core::Duration late{0};  ///< the host, beyond the patience of the start-up
        std::uint64_t frames = 0;
    };
    [[nodiscard]] Run begin(const CommandLine& command, core::Duration at, std::uint64_t frames_of_host);
    /// The reply; nullopt: none.
    [[nodiscard]] std::optional<std::string> end(const Run& run, std::uint64_t frames_of_host);
    void setReplied(core::Duration at) { replied_at_ = at; }
    void setBracket(bool inside) { inside_bracket_ = inside; }

    [[nodiscard]] bool isLaserOn() const { return laser_on_; }
    [[nodiscard]] int mode() const { return mode_; }
    [[nodiscard]] bool isStarted() const { return started_; }

private:
    [[nodiscard]] std::optional<std::string> refusal(const CommandLine& command, int argument) const;
    [[nodiscard]] std::string startUpStep(const Run& run, std::uint64_t frames_of_host);

    const BusStationSettings* settings_;  ///< of the station that this belongs to
    std::mt19937 random_;
    bool inside_bracket_ = false;
    bool laser_prepared_ = false, laser_on_ = false;
    int mode_ = 0;
    int next_step_ = 1;
    bool started_ = false;
    core::Duration replied_at_{0};
};

}  // namespace pmts::simulator
