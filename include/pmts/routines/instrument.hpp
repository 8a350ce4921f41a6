#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/instrument/geodimeter_settings.hpp"
#include "pmts/instrument/switching_on.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/protocol/instruction_table.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace pmts::routines {

/// How the instrument is spoken to.
enum class Dialect {
    kExternal,  ///< the documented interface on the instrument's foot (RG, WG, TG, ...)
    kBus,       ///< the bus under the control unit: angles come by themselves, the rest is an instruction table
};

struct InstrumentSettings {
    Dialect dialect = Dialect::kExternal;
    core::Angle tolerance = core::Angle::fromCc(10);  ///< of every motion, verified against the circles
    instrument::GeodimeterSettings profile;           ///< external dialect
    std::optional<instrument::SwitchingOn> switch_on;  ///< Start() switches the instrument on first, by a BREAK
    protocol::InstructionTable instructions;          ///< bus; kBadInput at Start() where it has problems
};

/// What came over the port: a reading of the circles, or a block that nobody asked for (REG key, slave mode).
struct PortData {
    std::optional<geometry::Pointing> pointing;
    std::optional<instrument::UnsolicitedBlock> block;
    core::Duration at{0};
};

/// The thesis's routines of the instrument (Annexure II) for users' own programs, under its names:
///
///     Instrument station(std::move(link), clock);
///     auto starting = station.Start();
///     if (const auto who = co_await starting; !who) { print(who.error().sentence()); co_return; }
///     auto turning = station.movHV(177.5612, 96.1684);      // gon
///     PMTS_CO_TRY(co_await turning);
///     auto shooting = station.Dist();
///     const auto shot = co_await shooting;                  // shot->slope_distance_m
///
/// The thesis's true is a value here, its false an Error with a sentence of what happened and one of what to do. Each
/// routine is a coroutine that gives its turn away while the instrument works: the program's event loop goes on. One at a
/// time, another one fails with kRefused; a stop token ends any of them with kCancelled. Angles are circle readings in
/// gon, distances slope distances in metres. One thread with an event loop.
class Instrument {
public:
    using Stop = std::stop_token;

    /// The clock outlives the instrument. transport::SerialLink is a port, transport::ReplayLink a recorded session.
    Instrument(std::unique_ptr<transport::ByteLink> link, core::Clock& clock, InstrumentSettings settings = {});
    ~Instrument();  ///< completes what runs with kCancelled, closes the port
    Instrument(const Instrument&) = delete;
    Instrument& operator=(const Instrument&) = delete;

    /// R1. Opens the port, switches the instrument on where the settings say so, and asks who is there; again after a loss.
    /// What the instrument does at its start, the compensator's calibration (`PV,20`) for one, is left to it and its
    /// operator. Fails with kPortUnavailable, kTimeOut, kProtocol, kUnsupported where the link has no BREAK.
    [[nodiscard]] core::Task<core::Result<instrument::Identity>> Start(Stop stop = {});
    /// R2. Writes a label and reads it back.
    [[nodiscard]] core::Task<core::Result<void>> Set(int id, QString value, Stop stop = {});
    /// R3. A label as the instrument writes it. 7 and 8 are HA and VA.
    [[nodiscard]] core::Task<core::Result<QString>> Get(int id, Stop stop = {});
    /// R4 to R6. Turns and verifies the arrival; where it stands then. kNotReached, kLimit, kDevice.
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> movH(double ha_gon, Stop stop = {});
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> movV(double va_gon, Stop stop = {});
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> movHV(double ha_gon, double va_gon, Stop stop = {});
    /// R20. One slope distance, standard mode; kAbsurdPoint when none comes within the learned limit.
    [[nodiscard]] core::Task<core::Result<instrument::DistanceShot>> Dist(Stop stop = {});
    /// R19, R18. The table's routines `laser_on` and `laser_off`; kUnsupported where the table or the dialect has none:
    /// the external dialect knows no command for the laser, and the code for off was never published.
    [[nodiscard]] core::Task<core::Result<void>> laserON(Stop stop = {});
    [[nodiscard]] core::Task<core::Result<void>> laserOFF(Stop stop = {});
    /// R14. One instruction as it stands in the manuals (`RG,7`, on the bus `WV,102=0`), its reply as it came, whatever its
    /// status. Erasing and service commands fail with kRefused (protocol::checkDenyList), file transfers with kUnsupported.
    [[nodiscard]] core::Task<core::Result<protocol::Reply>> prg1(std::string instruction, Stop stop = {});

    /// R16. Whatever comes over the port, as soon as it is there; no timer polls.
    std::function<void(const PortData&)> Timer1_Timer;
    /// The port went away or fell silent; Start() again.
    std::function<void(const core::Error&)> on_lost;

    /// On the wire at once; the routine that runs ends with kCancelled.
    void stop();

private:
    class Impl;
    std::shared_ptr<Impl> impl_;  ///< shared with the routines that are suspended
};

}  // namespace pmts::routines
