#pragma once

#include "pmts/instrument/instruction_runner.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/scheduler/scheduler.hpp"

#include <memory>

namespace pmts::instrument {

struct BusSettings {
    core::Duration stale_after = std::chrono::seconds(1);    ///< the stream comes about every 0.3 s
    core::Duration stream_limit = std::chrono::seconds(3);   ///< without a reading for so long nobody is there
};

/// The robotic base by its internal bus (protocol page 5): HA and VA come by themselves, everything else is a routine of
/// an instruction table. What the page does not disclose (motion, distance, labels) is kUnsupported here.
class BusDriver final : public TotalStation {
public:
    /// Scheduler and clock outlive the driver. Takes on_unsolicited, on_stream and on_lost of the scheduler, sets its block
    /// end and its stream head.
    BusDriver(scheduler::Scheduler& line, core::Clock& clock, BusSettings settings = {});
    ~BusDriver() override;  ///< running routines complete with kCancelled

    /// One routine at a time, else kRefused.
    [[nodiscard]] core::Task<core::Result<RoutineOutcome>> run(protocol::TableRoutine routine,
                                                               std::map<std::string, double> numbers, std::stop_token stop);
    [[nodiscard]] bool isBusy() const;
    std::function<void(std::size_t index)> on_begin;
    std::function<void(const StepOutcome&)> on_step;
    /// No reading has been believed for the stream's limit; once for each silence. Not while a routine runs: it may have
    /// suspended the stream, and is given the limit again at its end.
    std::function<void(const core::Error&)> on_silence;
    /// Somebody else was answered on the line: the base is there, its silence counts from now.
    void noteForeignTurn();
    /// The line was closed: nothing is expected before the next connectTo().
    void forget();

    /// Somebody is there when the stream comes; nothing is sent.
    [[nodiscard]] core::Task<core::Result<Identity>> connectTo(std::stop_token stop) override;
    /// The latest reading, or the next one where it is stale; kTimeOut when none comes.
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> readPointing(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnTo(geometry::Pointing target, core::Angle tolerance,
                                                                      std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnHorizontal(core::Angle ha, core::Angle tolerance,
                                                                              std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnVertical(core::Angle va, core::Angle tolerance,
                                                                            std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<DistanceShot>> measureDistance(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<void>> setMode(EdmMode mode) override;
    [[nodiscard]] EdmMode mode() const override;
    [[nodiscard]] core::Task<core::Result<bool>> testSignal(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<QString>> get(int label, std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<void>> set(int label, QString data, std::stop_token stop) override;
    /// Ends the routine that runs; no stop command is known on the bus.
    void stop() override;

private:
    class Impl;
    std::shared_ptr<Impl> impl_;  ///< shared with the routines that are suspended
};

}  // namespace pmts::instrument
