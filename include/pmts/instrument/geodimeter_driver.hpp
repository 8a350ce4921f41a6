#pragma once

#include "pmts/instrument/geodimeter_settings.hpp"
#include "pmts/instrument/memory.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/protocol/label_backup.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/scheduler/tt_statistics.hpp"

#include <memory>

namespace pmts::instrument {

struct GeodimeterState;

/// Geodimeter 600 / Trimble 5600 by its external dialect (protocol page 1-4).
///
/// The protocol has no check sum, and a lost byte turns `9=23.418` into `9=2.418`. So nothing is believed
/// once: targets are read back before the motors start, arrival is read from the circles, the angles of a
/// shot must agree with the pointing before it, its distance is read again by `RG,9`. On a line that showed
/// trouble lately a value must lead by six readings over any other; a number with another count of decimals
/// than usual is not believed.
class GeodimeterDriver final : public TotalStation {
public:
    /// Scheduler and clock outlive the driver. Takes on_unsolicited and on_lost of the scheduler.
    GeodimeterDriver(scheduler::Scheduler& line, core::Clock& clock, GeodimeterSettings settings = {});
    ~GeodimeterDriver() override;  ///< running routines complete with kCancelled

    [[nodiscard]] core::Task<core::Result<Identity>> connectTo(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> readPointing(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnTo(geometry::Pointing target,
                                                                      core::Angle tolerance,
                                                                      std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnHorizontal(core::Angle ha,
                                                                              core::Angle tolerance,
                                                                              std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turnVertical(core::Angle va,
                                                                            core::Angle tolerance,
                                                                            std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<DistanceShot>> measureDistance(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<void>> setMode(EdmMode mode) override;
    [[nodiscard]] EdmMode mode() const override;
    [[nodiscard]] core::Task<core::Result<bool>> testSignal(std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<QString>> get(int label, std::stop_token stop) override;
    [[nodiscard]] core::Task<core::Result<void>> set(int label, QString data, std::stop_token stop) override;
    void stop() override;

    // The instrument's memory (protocol page 2.7). Nothing is ever erased or overwritten.
    [[nodiscard]] core::Task<core::Result<MemoryListing>> listMemory(std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<DownloadedFile>> download(MemoryFileId id, OnTransfer progress,
                                                                    std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<UploadedFile>> upload(MemoryFileId id, std::vector<std::string> lines,
                                                                OnTransfer progress, std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<protocol::LabelBackup>> backUpLabels(OnTransfer progress, std::stop_token stop);
    /// PV,20: it turns by itself, half a turn and back. `on_question` answers its yes/no.
    [[nodiscard]] core::Task<core::Result<CompensatorRun>> calibrateCompensator(
        std::function<core::Completion<bool>()> on_question, std::stop_token stop);
    /// The driver's own check that a distance belongs to the point that is aimed at.
    void setTargetTest(const TargetTest& test);

    /// HA and VA at the lowest priority, for the poller: one question each, a doubtful value is left out.
    /// kRefused while a routine runs: that one reports pointings itself.
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> pollPointing(std::stop_token stop);
    [[nodiscard]] bool isBusy() const;
    /// Somebody else sends this to the instrument (a panel on the line): what it changes is no longer believed. True: how
    /// the instrument talks may have changed, units or block end; ask it again before anything else.
    [[nodiscard]] bool noteForeignCommand(std::string_view command);
    /// Range of the next target where known (scan neighbour, plane): chooses the range class of L.
    void expectRange(std::optional<double> slope_distance_m);
    [[nodiscard]] const scheduler::TtStatistics& statistics() const;
    /// L for the next distance, by mode and expected range.
    [[nodiscard]] core::Duration distanceLimit() const;

private:
    std::shared_ptr<GeodimeterState> state_;  ///< shared with the routines that are suspended
};

}  // namespace pmts::instrument
